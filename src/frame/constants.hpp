#pragma once

#include "gpu/image.hpp"

#include <velarium/settings.hpp>

#include <array>

namespace velarium::frame {

// Tables that depend on nothing but the device they are on.
class Constants {
 public:
  explicit Constants(gpu::Device& device);

  // Best-fit normal lengths, R8 (bake/normal_lengths.hpp).
  [[nodiscard]] const gpu::Image& normal_lengths() const { return normal_lengths_; }
  // E0, E1 by (n.v, smoothness), RG16F (bake/environment_brdf.hpp); made when it is first asked for.
  [[nodiscard]] const gpu::Image& brdf_table(ShadingModel model);

 private:
  gpu::Device& device_;
  gpu::Image normal_lengths_;
  std::array<gpu::Image, 2> brdf_tables_;  // by shading::environment_model()
};

}  // namespace velarium::frame
