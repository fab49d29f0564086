#include "scene/gltf_attributes.hpp"

#include "scene/gltf_directions.hpp"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <array>
#include <cmath>

namespace velarium::scene::gltf {

namespace {

// The formats of an attribute: first those of the core specification (3.7.2.1), then those of KHR_mesh_quantization.
struct FormatList {
  std::span<const Format> all;
  std::size_t core_count;
  Integers integers = Integers::as_written;
  [[nodiscard]] std::span<const Format> allowed(bool quantized) const {
    return quantized ? all : all.first(core_count);
  }
};

constexpr auto kF32 = Component::f32;
constexpr auto kI8 = Component::i8, kU8 = Component::u8, kI16 = Component::i16, kU16 = Component::u16;

constexpr std::array kPositionFormats = {
    Format{Type::vec3, kF32},       Format{Type::vec3, kI8},       Format{Type::vec3, kI8, true},
    Format{Type::vec3, kU8},        Format{Type::vec3, kU8, true}, Format{Type::vec3, kI16},
    Format{Type::vec3, kI16, true}, Format{Type::vec3, kU16},      Format{Type::vec3, kU16, true}};
constexpr std::array kMorphPositionFormats = {Format{Type::vec3, kF32}, Format{Type::vec3, kI8},
                                              Format{Type::vec3, kI8, true}, Format{Type::vec3, kI16},
                                              Format{Type::vec3, kI16, true}};
constexpr std::array kVec3DirectionFormats = {Format{Type::vec3, kF32}, Format{Type::vec3, kI8, true},
                                              Format{Type::vec3, kI16, true}};
constexpr std::array kTangentFormats = {Format{Type::vec4, kF32}, Format{Type::vec4, kI8, true},
                                        Format{Type::vec4, kI16, true}};
constexpr std::array kUvFormats = {
    Format{Type::vec2, kF32}, Format{Type::vec2, kU8, true},  Format{Type::vec2, kU16, true},
    Format{Type::vec2, kI8},  Format{Type::vec2, kI8, true},  Format{Type::vec2, kU8},
    Format{Type::vec2, kI16}, Format{Type::vec2, kI16, true}, Format{Type::vec2, kU16}};
constexpr std::array kColorFormats = {Format{Type::vec3, kF32},       Format{Type::vec3, kU8, true},
                                      Format{Type::vec3, kU16, true}, Format{Type::vec4, kF32},
                                      Format{Type::vec4, kU8, true},  Format{Type::vec4, kU16, true}};
constexpr std::array kJointFormats = {Format{Type::vec4, kU8}, Format{Type::vec4, kU16}};
constexpr std::array kWeightFormats = {Format{Type::vec4, kF32}, Format{Type::vec4, kU8, true},
                                       Format{Type::vec4, kU16, true}};

constexpr FormatList kPosition{kPositionFormats, 1}, kMorphPosition{kMorphPositionFormats, 1},
    kVec3Direction{kVec3DirectionFormats, 1, Integers::normalized}, kTangent{kTangentFormats, 1, Integers::normalized},
    kUv{kUvFormats, 3, Integers::normalized}, kColor{kColorFormats, kColorFormats.size(), Integers::normalized},
    kJoint{kJointFormats, kJointFormats.size()}, kWeight{kWeightFormats, kWeightFormats.size(), Integers::normalized};

// Reads members of an object of attributes, all of one count.
class AttributeReader {
 public:
  AttributeReader(Context& context, Accessors& accessors, const Value& attributes)
      : accessors_(accessors), attributes_(attributes), quantized_(context.uses("KHR_mesh_quantization")) {
    for (const auto& [name, reference] : attributes.members()) static_cast<void>(accessors.any(reference));
  }

  [[nodiscard]] const Value& attributes() const { return attributes_; }
  void expect_count(std::size_t count) { count_ = count; }

  [[nodiscard]] const Accessor* find(std::string_view name, const FormatList& formats) const {
    const Value reference = attributes_[name];
    if (!reference) return nullptr;
    const Accessor& accessor = accessors_.find(reference, formats.allowed(quantized_), formats.integers);
    if (count_ > 0 && accessor.elements.count != count_) {
      reference.fail(fmt::format("has {} elements, but there are {} vertices", accessor.elements.count, count_));
    }
    if (!accessor.aligned_for_vertices) reference.repair("is not aligned to 4 bytes, as vertex attributes should be");
    return &accessor;
  }

  // Empty where there is no such attribute.
  template <class Element>
  [[nodiscard]] std::vector<Element> floats(std::string_view name, const FormatList& formats) const {
    const Accessor* accessor = find(name, formats);
    return accessor ? accessors_.read_floats<Element>(*accessor) : std::vector<Element>();
  }

 private:
  Accessors& accessors_;
  Value attributes_;
  bool quantized_;
  std::size_t count_ = 0;
};

void read_uv_sets(const AttributeReader& reader, Primitive& primitive) {
  for (std::size_t set = 0; set < kMaxUvSets; ++set) {
    primitive.uv[set] = reader.floats<glm::vec2>(fmt::format("TEXCOORD_{}", set), kUv);
  }
}

void read_colors(const AttributeReader& reader, Accessors& accessors, Primitive& primitive) {
  const Accessor* accessor = reader.find("COLOR_0", kColor);
  if (!accessor) return;
  if (accessor->format.type == Type::vec4) {
    primitive.colors = accessors.read_floats<glm::vec4>(*accessor);
  } else {
    const std::vector<glm::vec3> opaque = accessors.read_floats<glm::vec3>(*accessor);
    primitive.colors.reserve(opaque.size());
    for (const glm::vec3& color : opaque) primitive.colors.emplace_back(color, 1.0f);
  }
  bool clamped = false;
  for (glm::vec4& color : primitive.colors) {
    const glm::vec4 inside = glm::clamp(color, 0.0f, 1.0f);
    clamped |= inside != color;
    color = inside;
  }
  if (clamped) reader.attributes()["COLOR_0"].repair("has values outside 0 and 1; the nearest are used");
}

std::uint32_t count_sets(const Value& attributes, std::string_view prefix) {
  std::uint32_t count = 0;
  for (const auto& [name, value] : attributes.members()) count += name.starts_with(prefix) ? 1 : 0;
  return count;
}

// The sum of a vertex's weights; its sets lie `vertices` apart.
float sum_weights(const Value& attributes, const std::vector<glm::vec4>& weights, std::size_t vertex,
                  std::size_t vertices) {
  float sum = 0.0f;
  bool negative = false;
  for (std::size_t i = vertex; i < weights.size(); i += vertices) {
    negative |= glm::any(glm::lessThan(weights[i], glm::vec4(0.0f)));
    sum += weights[i].x + weights[i].y + weights[i].z + weights[i].w;
  }
  if (negative || !std::isfinite(sum)) {
    attributes.fail(fmt::format("vertex {} has joint weights that are negative or too large", vertex));
  }
  return sum;
}

// Makes the weights of each vertex sum to 1, and joints of no weight 0, so that only joints that matter are checked.
void normalize_weights(const Value& attributes, Primitive& primitive) {
  const std::size_t vertices = primitive.vertex_count();
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    const float sum = sum_weights(attributes, primitive.weights, vertex, vertices);
    for (std::size_t i = vertex; i < primitive.weights.size(); i += vertices) {
      for (int c = 0; c < 4; ++c) {
        float& weight = primitive.weights[i][c];
        weight = sum > 0.0f ? weight / sum : 0.0f;
        if (weight == 0.0f) primitive.joints[i][c] = 0;
      }
    }
    if (sum > 0.0f) continue;
    primitive.weights[vertex].x = 1.0f;
    attributes.repair("vertices have no joint weights; they follow the skin's first joint");
  }
}

void read_skinning(const AttributeReader& reader, Accessors& accessors, Primitive& primitive) {
  const Value& attributes = reader.attributes();
  const std::uint32_t sets = count_sets(attributes, "JOINTS_"), weight_sets = count_sets(attributes, "WEIGHTS_");
  if (sets != weight_sets) attributes.fail(fmt::format("has {} sets of joints, but {} of weights", sets, weight_sets));
  for (std::uint32_t set = 0; set < sets; ++set) {
    const std::string joints_name = fmt::format("JOINTS_{}", set), weights_name = fmt::format("WEIGHTS_{}", set);
    static_cast<void>(attributes.require(joints_name));  // sets are numbered from 0 without gaps
    static_cast<void>(attributes.require(weights_name));
    const std::vector<glm::u16vec4> joints = accessors.read_joints(*reader.find(joints_name, kJoint));
    const std::vector<glm::vec4> weights = reader.floats<glm::vec4>(weights_name, kWeight);
    primitive.joints.insert(primitive.joints.end(), joints.begin(), joints.end());
    primitive.weights.insert(primitive.weights.end(), weights.begin(), weights.end());
  }
  primitive.skin_sets = sets;
  if (sets > 0) normalize_weights(attributes, primitive);
}

void drop_without_base(const Value& reference, bool base_is_absent, std::vector<glm::vec3>& displacements) {
  if (!base_is_absent || displacements.empty()) return;
  reference.warn("moves an attribute that the primitive does not have; it is ignored");
  displacements.clear();
}

void warn_of_ignored_sets(const Value& attributes) {
  if (const Value set = attributes[fmt::format("TEXCOORD_{}", kMaxUvSets)]) {
    set.warn(fmt::format("only the first {} sets of texture coordinates are read", kMaxUvSets));
  }
}

}  // namespace

void read_attributes(Context& context, Accessors& accessors, const Value& value, Primitive& primitive) {
  AttributeReader reader(context, accessors, value.require("attributes"));
  const Value& attributes = reader.attributes();
  VertexFrames& vertices = primitive.vertices;
  vertices.positions = reader.floats<glm::vec3>("POSITION", kPosition);
  reader.expect_count(vertices.positions.size());
  vertices.normals = reader.floats<glm::vec3>("NORMAL", kVec3Direction);
  if (!vertices.normals.empty()) {
    make_unit_normals(attributes["NORMAL"], vertices.normals);
    vertices.tangents = reader.floats<glm::vec4>("TANGENT", kTangent);  // meaningless without normals (3.7.2.1)
  }
  if (!vertices.tangents.empty()) make_unit_tangents(attributes["TANGENT"], vertices.normals, vertices.tangents);
  read_uv_sets(reader, primitive);
  read_colors(reader, accessors, primitive);
  read_skinning(reader, accessors, primitive);
  warn_of_ignored_sets(attributes);
}

void read_morph_targets(Context& context, Accessors& accessors, const Value& value, Primitive& primitive) {
  const VertexFrames& base = primitive.vertices;
  for (const Value& attributes : value["targets"].elements()) {
    AttributeReader reader(context, accessors, attributes);
    reader.expect_count(primitive.vertex_count());
    MorphTarget& target = primitive.morph_targets.emplace_back();
    target.positions = reader.floats<glm::vec3>("POSITION", kMorphPosition);
    target.normals = reader.floats<glm::vec3>("NORMAL", kVec3Direction);
    target.tangents = reader.floats<glm::vec3>("TANGENT", kVec3Direction);
    drop_without_base(attributes["NORMAL"], base.normals.empty(), target.normals);
    drop_without_base(attributes["TANGENT"], base.tangents.empty(), target.tangents);
    for (const auto& [name, reference] : attributes.members()) {
      const bool read = name == "POSITION" || name == "NORMAL" || name == "TANGENT";
      if (!read) reference.warn("only positions, normals and tangents are morphed; this one is ignored");
    }
  }
}

}  // namespace velarium::scene::gltf
