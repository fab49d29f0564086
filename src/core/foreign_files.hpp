#pragma once

// Files of kinds that this program does not read, told apart for the sake of their error messages.

#include <cstddef>
#include <span>
#include <string_view>

namespace velarium {

// "is a ZIP archive; unpack it": what the beginning of a file shows it to be, and what to do. Empty where it is not
// known.
[[nodiscard]] std::string_view foreign_kind(std::span<const std::byte> bytes);

}  // namespace velarium
