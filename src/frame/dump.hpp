#pragma once

#include "graph/executor.hpp"

#include <velarium/engine.hpp>

#include <string>
#include <vector>

namespace velarium::frame {

// Throws Error(usage) for a name that no image of the executor's last run has, listing those there are.
void check_dump_names(const graph::Executor& executor, const std::vector<std::string>& names);

// Brings back an image of the executor's last run by its name "pass.image", channels widened to float, absent ones 0
// and alpha 1. Precondition: an image of that name exists.
[[nodiscard]] DumpedImage dump_image(gpu::Device& device, graph::Executor& executor, const std::string& name);

}  // namespace velarium::frame
