#pragma once

#include "graph/executor.hpp"

#include <velarium/engine.hpp>

#include <string>

namespace velarium::frame {

// Brings back an image of the executor's last run by its name "pass.image", channels widened to float, absent ones 0
// and alpha 1. Throws Error(usage) for an unknown name, listing those there are.
[[nodiscard]] DumpedImage dump_image(gpu::Device& device, graph::Executor& executor, const std::string& name);

}  // namespace velarium::frame
