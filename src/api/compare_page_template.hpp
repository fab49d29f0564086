#pragma once

#include <string_view>

namespace velarium::compared {

// The page of a comparison, with names in double braces where its values go.
extern const std::string_view kPageTemplate;

}  // namespace velarium::compared
