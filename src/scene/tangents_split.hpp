#pragma once

#include "scene/scene.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace velarium::scene {

// The bits of a float, with -0 as 0: what welding compares, so that a NaN of a hostile file equals itself.
inline std::uint32_t word_of(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0f);
}

template <int N>
[[nodiscard]] bool same_words(const glm::vec<N, float>& a, const glm::vec<N, float>& b) {
  for (int i = 0; i < N; ++i) {
    if (word_of(a[i]) != word_of(b[i])) return false;
  }
  return true;
}

// A 64-bit hash of 32-bit words, fed one at a time (multiply and xor-shift; the multiplier is 2^64 / golden ratio).
class WordHash {
 public:
  WordHash& add(std::uint32_t word) {
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15ull;
    state_ ^= state_ >> 29;
    return *this;
  }
  template <int N>
  WordHash& add(const glm::vec<N, float>& v) {
    for (int i = 0; i < N; ++i) add(word_of(v[i]));
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

// For each i in [0, count), the smallest j with equal(i, j), in linear time. `hash(i)` must agree with `equal`.
template <class Hash, class Equal>
[[nodiscard]] std::vector<std::uint32_t> first_equals(std::size_t count, const Hash& hash, const Equal& equal) {
  constexpr std::uint32_t kFree = 0xffffffffu;
  const std::size_t mask = std::bit_ceil(std::max<std::size_t>(2 * count, 2)) - 1;
  std::vector<std::uint32_t> table(mask + 1, kFree);
  std::vector<std::uint32_t> first(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::size_t slot = hash(i) & mask;
    while (table[slot] != kFree && !equal(table[slot], i)) slot = (slot + 1) & mask;
    if (table[slot] == kFree) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

// Replaces the vertices by copies: new vertex i is old vertex sources[i], in every attribute and morph target.
// Indices are left as they are.
void gather_vertices(Primitive& primitive, std::span<const std::uint32_t> sources);

}  // namespace velarium::scene
