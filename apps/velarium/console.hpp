#pragma once

// What the program says. Results go to standard output, everything else to standard error.

#include <string_view>

namespace velarium::app {

enum class Verbosity { quiet, normal, verbose };

// Errors are always said; warnings, notes and results unless quiet; the library's other remarks where verbose.
void set_verbosity(Verbosity verbosity);
[[nodiscard]] Verbosity verbosity();

void say_error(std::string_view text);
void say_warning(std::string_view text);
void say_note(std::string_view text);

// Text on standard output, as it is. Throws Error(output_not_written) where that fails.
void print(std::string_view text);

}  // namespace velarium::app
