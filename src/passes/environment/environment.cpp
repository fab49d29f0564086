#include "passes/environment/environment.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::environment {

Reading add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  const float turn = glm::radians(settings.rotation);
  io::Environment table{.background = in.color,
                        .turn = {settings.intensity, std::cos(turn), std::sin(turn), in.shown ? 1.0f : 0.0f}};
  std::ranges::copy(in.sh, table.sh);
  return {.background = in.background,
          .lobes = in.lobes,
          .irradiance = in.irradiance,
          .brdf_table = in.brdf_table,
          .table = graph.upload("environment.table", table),
          .sh = settings.diffuse == DiffuseEnvironment::sh,
          .occlusion = in.occlusion};
}

}  // namespace velarium::environment
