#include "support.hpp"

#include "scene/gltf_accessors.hpp"

#include <glm/glm.hpp>

#include <fmt/core.h>

#include <array>

namespace velarium::fuzz {
namespace {

using namespace scene::gltf;  // the target is that namespace's reader

constexpr std::array<const char*, 8> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4", "VEC5"};

// What the first bytes of the input choose. Bytes, so that each value is near another one.
struct Description {
  std::uint8_t component, type, normalized, count, offset, view_offset, stride;
  std::uint8_t sparse_count, sparse_component, sparse_offset, values_offset;
};

std::string document_of(const Description& d, std::size_t buffer_bytes) {
  const std::size_t view_bytes = buffer_bytes - std::min<std::size_t>(d.view_offset, buffer_bytes);
  const std::string stride = d.stride == 0 ? "" : fmt::format(R"(,"byteStride":{})", d.stride);
  const std::string sparse =
      d.sparse_count == 0
          ? ""
          : fmt::format(R"(,"sparse":{{"count":{},"indices":{{"bufferView":1,"byteOffset":{},"componentType":{}}},)"
                        R"("values":{{"bufferView":1,"byteOffset":{}}}}})",
                        d.sparse_count, d.sparse_offset, 5120 + d.sparse_component % 8, d.values_offset);
  return fmt::format(
      R"({{"buffers":[{{"byteLength":{0}}}],"bufferViews":[{{"buffer":0,"byteOffset":{1},"byteLength":{2}{3}}},)"
      R"({{"buffer":0,"byteLength":{0}}}],"accessors":[{{"bufferView":0,"byteOffset":{4},"componentType":{5},)"
      R"("type":"{6}","normalized":{7},"count":{8}{9}}}],"use":0}})",
      buffer_bytes, d.view_offset, view_bytes, stride, d.offset, 5120 + d.component % 8, kTypes[d.type % kTypes.size()],
      d.normalized % 2 != 0, d.count, sparse);
}

bool is_unsigned(Component component) {
  return component == Component::u8 || component == Component::u16 || component == Component::u32;
}

// The formats that some property of glTF may have: vectors of every component, and float matrices of four columns.
std::vector<Format> usable_formats() {
  std::vector<Format> formats{{Type::mat4, Component::f32, false}};
  for (const auto component :
       {Component::i8, Component::u8, Component::i16, Component::u16, Component::u32, Component::f32}) {
    for (const auto type : {Type::scalar, Type::vec2, Type::vec3, Type::vec4}) {
      for (const bool normalized : {false, true}) formats.push_back({type, component, normalized});
    }
  }
  return formats;
}

// Reads as the scene's reader does, which asks for no type but the accessor's own.
void read(Accessors& accessors, const Accessor& accessor) {
  const Format& format = accessor.format;
  switch (format.type) {
    case Type::scalar:
      static_cast<void>(accessors.read_floats<float>(accessor));
      if (is_unsigned(format.component)) static_cast<void>(accessors.read_indices(accessor));
      break;
    case Type::vec2:
      static_cast<void>(accessors.read_floats<glm::vec2>(accessor));
      break;
    case Type::vec3:
      static_cast<void>(accessors.read_floats<glm::vec3>(accessor));
      break;
    case Type::vec4:
      static_cast<void>(accessors.read_floats<glm::vec4>(accessor));
      if (is_unsigned(format.component)) static_cast<void>(accessors.read_joints(accessor));
      break;
    default:
      static_cast<void>(accessors.read_floats<glm::mat4>(accessor));
  }
}

}  // namespace

void accessors(Bytes input) {
  const auto parts = described<Description>(input);
  if (!parts) return;
  static const std::vector<Format> formats = usable_formats();
  expect_orderly([&] {
    Container container;
    container.binary = parts->data;
    Document document("input.gltf", document_of(parts->description, parts->data.size()), {.depth = 16});
    const Buffers buffers(document.root(), container, {});
    Accessors accessors(document.root(), buffers, {});
    read(accessors, accessors.find(document.root()["use"], formats));
  });
}

}  // namespace velarium::fuzz
