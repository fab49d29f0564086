#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace velarium::app {

// Each adds one verb to the command line. A verb throws Error, or Interrupted.
void add_render(CLI::App& app);
void add_reference(CLI::App& app);
void add_info(CLI::App& app);
void add_devices(CLI::App& app);
void add_bench(CLI::App& app);
void add_compare(CLI::App& app);
void add_options(CLI::App& app);
void add_completion(CLI::App& app);

// A verb whose unknown arguments are an Error(usage) that names the nearest known flag.
CLI::App& add_verb(CLI::App& app, const std::string& name, const std::string& help, std::function<void()> run);

}  // namespace velarium::app
