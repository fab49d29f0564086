#include "scene/gltf_draco.hpp"

#include "scene/gltf_draco_stream.hpp"
#include "scene/gltf_topology.hpp"

#include <fmt/core.h>

#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace velarium::scene::gltf {

namespace {

// Calls `use` with a zero of the type; false where it is none that glTF could mean.
template <class Use>
bool with_type(draco::DataType type, const Use& use) {
  switch (type) {
    case draco::DT_INT8:
      return use(std::int8_t{}), true;
    case draco::DT_UINT8:
      return use(std::uint8_t{}), true;
    case draco::DT_INT16:
      return use(std::int16_t{}), true;
    case draco::DT_UINT16:
      return use(std::uint16_t{}), true;
    case draco::DT_INT32:
      return use(std::int32_t{}), true;
    case draco::DT_UINT32:
      return use(std::uint32_t{}), true;
    case draco::DT_FLOAT32:
      return use(float{}), true;
    default:
      return false;
  }
}

draco::DataType type_of(Component component) {
  switch (component) {
    case Component::i8:
      return draco::DT_INT8;
    case Component::u8:
      return draco::DT_UINT8;
    case Component::i16:
      return draco::DT_INT16;
    case Component::u16:
      return draco::DT_UINT16;
    case Component::u32:
      return draco::DT_UINT32;
    case Component::f32:
      return draco::DT_FLOAT32;
  }
  return draco::DT_INVALID;
}

// Packed values of one type as those of another. Throws at `id` where one does not fit.
template <class From, class To>
std::vector<std::byte> converted(const Value& id, const std::vector<std::byte>& values, From, To) {
  std::vector<std::byte> out(values.size() / sizeof(From) * sizeof(To));
  for (std::size_t i = 0; i < values.size() / sizeof(From); ++i) {
    From value;
    std::memcpy(&value, values.data() + i * sizeof(From), sizeof(From));
    // Doubles hold every value of both types.
    const auto wide = static_cast<double>(value);
    constexpr auto kLeast = static_cast<double>(std::numeric_limits<To>::lowest());
    constexpr auto kMost = static_cast<double>(std::numeric_limits<To>::max());
    if (!(wide >= kLeast && wide <= kMost))
      id.fail(fmt::format("value {} of its compressed data does not fit the type of its accessor", wide));
    const To narrow = static_cast<To>(wide);
    if (static_cast<double>(narrow) != wide)
      id.fail(fmt::format("value {} of its compressed data is not whole, as its accessor's are", wide));
    std::memcpy(out.data() + i * sizeof(To), &narrow, sizeof(To));
  }
  return out;
}

std::vector<std::byte> converted(const Value& id, const std::vector<std::byte>& values, draco::DataType from,
                                 draco::DataType to) {
  std::vector<std::byte> out;
  with_type(from,
            [&](auto source) { with_type(to, [&](auto target) { out = converted(id, values, source, target); }); });
  return out;
}

// Packed. Throws at `id` where the decoder left points without a value.
std::vector<std::byte> values_of(const Value& id, const draco::PointAttribute& attribute, std::uint32_t points) {
  const auto stride = static_cast<std::size_t>(attribute.byte_stride());
  const bool mapped = !attribute.is_mapping_identity();
  const std::size_t stored = std::min(attribute.size(), attribute.buffer()->data_size() / stride);
  if (mapped && attribute.indices_map_size() < points) id.fail("its compressed data is damaged");
  std::vector<std::byte> out(points * stride);
  for (std::uint32_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex index = attribute.mapped_index(draco::PointIndex(i));
    if (index.value() >= stored) id.fail("its compressed data is damaged");
    std::memcpy(out.data() + i * stride, attribute.GetAddress(index), stride);
  }
  return out;
}

std::vector<std::byte> indices_of(const draco::Mesh& mesh) {
  std::vector<std::byte> out(3 * sizeof(std::uint32_t) * mesh.num_faces());
  std::byte* next = out.data();
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) {
      const std::uint32_t index = corner.value();
      std::memcpy(next, &index, sizeof(index));
      next += sizeof(index);
    }
  }
  return out;
}

// One primitive's extension, checked and decoded step by step.
class Reader {
 public:
  Reader(Accessors& accessors, const Value& primitive, const Value& extension, Mode mode)
      : accessors_(accessors),
        primitive_(primitive),
        at_(extension),
        attributes_(extension.require("attributes")),
        mode_(mode) {}

  void read() {
    const std::uint32_t points = check_attributes();
    const DracoStream stream(at_, data());
    check_counts(stream, points);
    const std::unique_ptr<draco::Mesh> mesh = stream.decode({.points = points, .elements = accessors_.elements()});
    for (const auto& [name, id] : attributes_.members()) replace_attribute(*mesh, points, name, id);
    accessors_.replace(primitive_["indices"], Component::u32, 3 * mesh->num_faces(), indices_of(*mesh));
  }

 private:
  [[nodiscard]] std::span<const std::byte> data() const {
    const Value reference = at_.require("bufferView");
    const BufferView& view = accessors_.buffers().view(reference);
    if (!view.data) reference.fail("has no data");
    return {view.data, view.length};
  }

  // An accessor that the data fills may hold a fallback of its own, but not half of one.
  const Accessor& accessor_of(const Value& reference) const {
    const Accessor& accessor = accessors_.any(reference);
    const Value sparse = accessor.at["sparse"];
    if (sparse && !accessor.at["bufferView"]) sparse.fail("stands in an accessor that compressed data fills");
    return accessor;
  }

  // Returns how many vertices the accessors have that the data fills.
  [[nodiscard]] std::uint32_t check_attributes() const {
    std::optional<std::uint32_t> count;
    for (const auto& [name, id] : attributes_.members()) {
      const Value reference = primitive_["attributes"][name];
      if (!reference) id.fail("is not among the primitive's own attributes");
      const std::uint32_t points = accessor_of(reference).elements.count;
      if (points != count.value_or(points)) {
        reference.fail(fmt::format("has {} elements, but other attributes have {}", points, *count));
      }
      count = points;
    }
    if (!count) attributes_.fail("is empty; compressed data has at least one attribute");
    return *count;
  }

  void check_counts(const DracoStream& stream, std::uint32_t points) const {
    const Value reference = primitive_.require("indices");
    const std::uint64_t indices = accessor_of(reference).elements.count, corners = 3ull * stream.faces();
    // A strip has a triangle for each index after the second, less those that the encoder found empty.
    if (mode_ == Mode::triangle_strip ? stream.faces() + 2ull > indices : corners != indices) {
      reference.fail(fmt::format("has {} elements, but the compressed data has {} triangles", indices, stream.faces()));
    }
    if (stream.fewest_points() > points) {
      at_.fail(fmt::format("the compressed data has {} vertices, but its accessors have {}", stream.fewest_points(),
                           points));
    }
  }

  void replace_attribute(const draco::Mesh& mesh, std::uint32_t points, std::string_view name, const Value& id) const {
    const auto unique_id = static_cast<std::uint32_t>(id.integer(0, UINT32_MAX));
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(unique_id);
    if (!attribute) id.fail(fmt::format("is {}, which no attribute of the compressed data is called", unique_id));
    const Value reference = primitive_["attributes"][name];
    const Format format = accessors_.any(reference).format;
    const draco::DataType from = attribute->data_type(), to = type_of(format.component);
    const bool is_known = with_type(from, [](auto) {});
    if (!is_known || attribute->num_components() != component_count(format.type))
      id.fail("its compressed data is of another type than its accessor");
    std::vector<std::byte> values = values_of(id, *attribute, points);
    if (from != to) {
      id.repair("its compressed data is of another type than its accessor; it was converted");
      values = converted(id, values, from, to);
    }
    accessors_.replace(reference, format.component, points, std::move(values));
  }

  Accessors& accessors_;
  const Value& primitive_;
  const Value& at_;
  Value attributes_;
  Mode mode_;
};

}  // namespace

DracoGeometry::DracoGeometry(Context& context, Accessors& accessors, const Value& primitive) : accessors_(accessors) {
  constexpr std::string_view kName = "KHR_draco_mesh_compression";
  const Value extension = primitive["extensions"][kName];
  if (!extension) return;
  if (!context.uses(kName)) extension.repair("is not listed in /extensionsUsed; it was read");
  const auto mode = static_cast<Mode>(primitive["mode"].integer_or(4, 0, 6));
  if (mode != Mode::triangles && mode != Mode::triangle_strip) {
    primitive["mode"].fail("must be 4 or 5: compressed data holds triangles");
  }
  Reader(accessors, primitive, extension, mode).read();
  present_ = true;
}

}  // namespace velarium::scene::gltf
