#pragma once

#include "gpu/image.hpp"
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace velarium::upload {

// The different pictures that the scene's spot lights throw. Projectors that differ in their field of view alone share
// one.
[[nodiscard]] std::vector<scene::Projector> projector_pictures(const scene::Scene& scene);

// GpuLight::projector_layer: 1 + the place of the projector's picture among these, 0 where it is not there.
[[nodiscard]] std::uint32_t projector_layer(const scene::Projector& projector,
                                            std::span<const scene::Projector> pictures);

// Those pictures as squares of one size, sRGB-encoded: each lies in the middle of its square, as long as its longer
// side, and fades to black at its borders as its projector says. What is transparent is black.
[[nodiscard]] std::vector<scene::Image> projector_layers(const scene::Scene& scene,
                                                         std::span<const scene::Projector> pictures);

// The pictures on the device.
struct Projectors {
  std::vector<scene::Projector> pictures;
  gpu::Image array;  // a layer each, with mips; one black texel where there are none
};

[[nodiscard]] Projectors make_projectors(gpu::Device& device, const scene::Scene& scene);

}  // namespace velarium::upload
