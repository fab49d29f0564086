#pragma once

#include "gpu/image.hpp"
#include "gpu/samplers.hpp"
#include "scene/scene.hpp"
#include "upload/gpu_structs.hpp"

#include <array>
#include <map>
#include <vector>

namespace velarium::upload {

// The texture of each slot of a material, in slot order.
[[nodiscard]] std::array<const scene::TextureRef*, kSlotCount> slots_of(const scene::Material& material);

// What the texels of a slot are: colours are stored sRGB-encoded, and mips of normals keep how far those spread.
enum class TexelKind { color, data, normals };
[[nodiscard]] TexelKind texel_kind(std::uint32_t slot);

[[nodiscard]] gpu::SamplerDesc sampler_desc(const scene::Sampler& sampler, float anisotropy, float lod_bias);

// Every image that a material uses, on the device with its mips: once for each kind that is needed.
class Textures {
 public:
  // Images larger than the device takes are scaled down, with a warning in the log.
  Textures(gpu::Device& device, const scene::Scene& scene);

  // What a material's slot samples: a white texel where the slot has no texture.
  struct Bound {
    const gpu::Image* image;
    scene::Sampler sampler;
  };
  [[nodiscard]] Bound bound(const scene::TextureRef& ref, std::uint32_t slot) const;

 private:
  const scene::Scene& scene_;
  std::vector<gpu::Image> images_;                                   // the last is the white texel
  std::map<std::pair<std::int32_t, TexelKind>, std::size_t> index_;  // (scene image, kind) -> images_
};

}  // namespace velarium::upload
