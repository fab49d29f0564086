#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace velarium::app {

// velarium(1) in roff, from the command line and the table of options.
[[nodiscard]] std::string man_page(const CLI::App& app);

}  // namespace velarium::app
