#include "core/budget.hpp"

#include "core/assert.hpp"

#include <velarium/options.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace velarium {

std::string Budget::refusal(std::uint64_t amount) const {
  const auto table = option_table();
  const auto row = std::find_if(table.begin(), table.end(), [&](const OptionInfo& o) { return o.key == option_; });
  VEL_ASSERT(row != table.end());
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t needed = amount > kLargest - used_ ? kLargest : used_ + amount;
  const std::string advice = static_cast<double>(needed) <= row->maximum
                                 ? fmt::format("-D {}={} allows it", option_, needed)
                                 : fmt::format("{} cannot be more than {:.0f}", option_, row->maximum);
  return fmt::format("{} {}, more than {}={} allows; {}", needed, row->unit, option_, limit_, advice);
}

}  // namespace velarium
