#include "support.hpp"

#include "scene/gltf_accessors.hpp"

namespace velarium::fuzz {

void glb(Bytes input) {
  using namespace scene::gltf;  // the target is that namespace's reader
  static const InputFile file("input.glb");
  constexpr std::uint32_t kDepth = 32;
  const scene::GltfOptions options;
  expect_orderly([&] {
    const Container container = open_container(file.write(input), options.limits);
    Document document("input.glb", container.json, {.depth = kDepth});
    const Buffers buffers(document.root(), container, options);
    const Accessors accessors(document.root(), buffers, options.limits);
  });
}

}  // namespace velarium::fuzz
