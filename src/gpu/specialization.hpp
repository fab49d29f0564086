#pragma once

#include "gpu/slot.hpp"

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

namespace velarium::gpu {

// Values of specialisation constants; those without one keep the default of the shader. A value, ordered by id.
class Specialization {
 public:
  struct Entry {
    std::uint32_t id = 0, bits = 0;
    bool operator==(const Entry&) const = default;
  };

  // Replaces an earlier value.
  template <class T>
  Specialization& set(Constant<T> constant, std::type_identity_t<T> value) {
    if constexpr (std::is_same_v<T, bool>)
      set_bits(constant.id, value ? 1u : 0u);
    else
      set_bits(constant.id, std::bit_cast<std::uint32_t>(value));
    return *this;
  }

  [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
  bool operator==(const Specialization&) const = default;

 private:
  void set_bits(std::uint32_t id, std::uint32_t bits);
  std::vector<Entry> entries_;
};

}  // namespace velarium::gpu
