#pragma once

// Computed tables kept between runs under cache_directory(). Every failure, and every file that is not exactly what
// was stored, is a miss: a table is then computed again.

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace velarium::bake {

// Fills `table` from the file `name`; false, with `table` untouched, on a miss.
[[nodiscard]] bool load_table(const std::string& name, std::span<std::byte> table);

// Stores the table with a hash of its content; silently leaves it where that is not possible.
void store_table(const std::string& name, std::span<const std::byte> table);

// The stored table of `count` elements, or that of `compute`, which is then stored. `name` is a file name that holds
// all that the table depends on, and a version that changes with its computation.
template <class T, class Compute>
[[nodiscard]] std::vector<T> cached_table(const std::string& name, std::size_t count, const Compute& compute) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<T> table(count);
  if (load_table(name, std::as_writable_bytes(std::span(table)))) return table;
  table = compute();
  store_table(name, std::as_bytes(std::span(table)));
  return table;
}

}  // namespace velarium::bake
