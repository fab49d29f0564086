#pragma once

#include <string_view>

namespace velarium::app {

// The script that connects a shell ("bash", "zsh", "fish") with `velarium completion words`, or an empty view.
// It holds no flag and no option itself.
[[nodiscard]] std::string_view completion_script(std::string_view shell);

}  // namespace velarium::app
