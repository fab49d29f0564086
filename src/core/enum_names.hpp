#pragma once

// The enumerators of an enumeration as text, taken from the compiler, so that a choice of the options table is
// written once: in its enumeration. For enumerations whose values count up from 0.

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace velarium {

// g++ and clang both end this function's name with "... = velarium::Sync::paranoid]" (g++ may add "; ..." after it);
// where no enumerator has the value they write a cast, "(velarium::Sync)2".
template <auto kValue>
constexpr std::string_view enumerator_name() {
  std::string_view text = __PRETTY_FUNCTION__;
  text.remove_prefix(text.find("kValue = ") + std::string_view("kValue = ").size());
  text = text.substr(0, text.find_first_of(";]"));
  if (text.front() == '(') return {};
  return text.substr(text.rfind(':') + 1);
}

template <class Enum, std::size_t kCount = 0>
constexpr std::size_t enumerator_count() {
  if constexpr (enumerator_name<static_cast<Enum>(kCount)>().empty()) {
    return kCount;
  } else {
    return enumerator_count<Enum, kCount + 1>();
  }
}

template <class Enum>
inline constexpr auto kEnumNames = []<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
  return std::array<std::string_view, sizeof...(kIndex)>{enumerator_name<static_cast<Enum>(kIndex)>()...};
}
(std::make_index_sequence<enumerator_count<Enum>()>{});

}  // namespace velarium
