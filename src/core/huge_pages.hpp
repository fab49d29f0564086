#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace velarium {

// Asks the system to back a large range that is about to be written with its largest pages: the first touch of 100 MB
// then costs 50 page faults instead of 25,000. A wish: systems that cannot, and ranges too small for it, are left
// alone.
void prefer_huge_pages(std::span<const std::byte> range) noexcept;

// Room for `count` values, wished to be backed so; for vectors of pixels, before they get their size.
template <class T>
void reserve_on_huge_pages(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_huge_pages(std::as_bytes(std::span<const T>(values.data(), values.capacity())));
}

}  // namespace velarium
