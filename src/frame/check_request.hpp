#pragma once

#include <velarium/engine.hpp>

namespace velarium::frame {

// Throws Error(usage) for a request that no picture can be made of, and says what to change: a size that is zero or
// above `size_limit` (pixels a side), a setting outside its range of the options table, a field of view outside 0 to
// 180 degrees, a background outside 0..1, a time that is not a number, a sun out of its ranges.
void check_request(const RenderRequest& request, std::uint32_t size_limit);

}  // namespace velarium::frame
