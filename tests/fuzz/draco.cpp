#include "support.hpp"

#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

namespace velarium::fuzz {
namespace {

using namespace scene::gltf;  // the target is that namespace's reader

// What the first bytes of the input choose. Two bytes make a count, the low one first.
struct Description {
  std::uint8_t faces[2], points[2];
  std::uint8_t attributes;  // a bit for each of NORMAL, TEXCOORD_0 and COLOR_0
};

// One compressed primitive; the unique id of an attribute is the number of its accessor.
std::string document_of(const Description& d, std::size_t buffer_bytes) {
  const int faces = d.faces[0] + 256 * d.faces[1], points = d.points[0] + 256 * d.points[1];
  std::string names = R"("POSITION":0)";
  if (d.attributes & 1) names += R"(,"NORMAL":1)";
  if (d.attributes & 2) names += R"(,"TEXCOORD_0":2)";
  if (d.attributes & 4) names += R"(,"COLOR_0":3)";
  return fmt::format(
      R"({{"buffers":[{{"byteLength":{0}}}],"bufferViews":[{{"buffer":0,"byteLength":{0}}}],"accessors":[)"
      R"({{"componentType":5126,"count":{1},"type":"VEC3"}},{{"componentType":5126,"count":{1},"type":"VEC3"}},)"
      R"({{"componentType":5126,"count":{1},"type":"VEC2"}},)"
      R"({{"componentType":5121,"normalized":true,"count":{1},"type":"VEC4"}},)"
      R"({{"componentType":5125,"count":{2},"type":"SCALAR"}}],"extensionsUsed":["KHR_draco_mesh_compression"],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{{3}}},"indices":4,"extensions":{{"KHR_draco_mesh_compression":)"
      R"({{"bufferView":0,"attributes":{{{3}}}}}}}}}]}}]}})",
      buffer_bytes, points, 3 * faces, names);
}

}  // namespace

void draco(Bytes input) {
  const auto parts = described<Description>(input);
  if (!parts) return;
  scene::GltfOptions options;
  options.limits.elements = 1 << 16;
  expect_orderly([&] {
    Container container;
    container.binary = parts->data;
    Document document("input.gltf", document_of(parts->description, parts->data.size()), {.depth = 16});
    const Buffers buffers(document.root(), container, options);
    Accessors accessors(document.root(), buffers, options.limits);
    scene::Scene scene;
    Context context{document.root(), options, scene};
    read_extension_lists(context);
    read_meshes(context, accessors);
  });
}

}  // namespace velarium::fuzz
