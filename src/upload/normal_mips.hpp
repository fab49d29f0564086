#pragma once

// Mips of normal maps. A texel of a smaller level stands for all the texels of level 0 below it: rgb is the direction
// of the mean of their unit normals, and alpha is how far they, interpolated as filters do, spread about it:
// interpolated_mean_length() of four and spread_from_mean_length(), in shading/specular_aa.glsl. Level 0 has no
// spread. All is computed from level 0 in 32-bit floats: lengths of 8-bit normals are off by 0.3 %, which would read as
// a spread of 0.08.

#include "gpu/image.hpp"
#include "gpu/gpu_context.hpp"
#include "upload/mips.hpp"

#include <span>

namespace velarium::upload {

// Copies 8-bit RGBA, its alpha replaced by 0: what level 0 is.
void copy_without_alpha(std::span<const std::byte> from, std::byte* to);

// Writes every level but the first. levels: from the largest to the last, each
// half as wide and high as the one before, rounded down, and at least 1.
void make_normal_mips(std::span<const TexelRows> levels);

// The same on the device.
class NormalMipmapper {
 public:
  explicit NormalMipmapper(gpu::Device& device) : tools_(device) {}

  // image: 8-bit UNORM RGBA that may be stored to, one layer, whose level 0 the transfer stage has written without
  // alpha; all of it in VK_IMAGE_LAYOUT_GENERAL. Its other levels are written in compute shaders. The commands must
  // have finished before reset().
  void record(VkCommandBuffer commands, const gpu::Image& image);
  void reset();

 private:
  gpu::GpuContext tools_;
  std::vector<gpu::Buffer> means_;  // of images whose commands may still run
};

}  // namespace velarium::upload
