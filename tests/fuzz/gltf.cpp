#include "support.hpp"

#include "scene/gltf.hpp"
#include "scene/snapshot.hpp"

namespace velarium::fuzz {
namespace {

// Far above what an input of some kilobytes needs, far below what takes noticeable time.
scene::GltfOptions small_limits() {
  scene::GltfOptions options;
  options.limits.elements = 1 << 16;
  options.limits.pixels = 1 << 20;
  options.limits.image_size = 1 << 12;
  options.limits.nodes = 1 << 10;
  return options;
}

}  // namespace

void gltf(Bytes input) {
  static const InputFile file("input.gltf");
  expect_orderly([&] {
    const scene::Scene scene = scene::read_gltf(file.write(input), small_limits());
    for (const float time_s : {0.0f, 0.5f}) static_cast<void>(scene::snapshot_at(scene, time_s, "all"));
  });
}

}  // namespace velarium::fuzz
