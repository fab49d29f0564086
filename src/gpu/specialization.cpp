#include "gpu/specialization.hpp"

#include <algorithm>

namespace velarium::gpu {

void Specialization::set_bits(std::uint32_t id, std::uint32_t bits) {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), id,
                                   [](const Entry& entry, std::uint32_t i) { return entry.id < i; });
  if (at != entries_.end() && at->id == id)
    at->bits = bits;
  else
    entries_.insert(at, {id, bits});
}

}  // namespace velarium::gpu
