#include "scene/gltf_accessors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace velarium::scene::gltf {

namespace {

struct TypeShape {
  std::string_view name;
  std::uint32_t columns, rows;
};

// Indexed by Type; vectors are one column.
constexpr std::array<TypeShape, 7> kShapes = {
    {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}}};

struct ComponentShape {
  Component component;
  std::string_view name;
  std::uint32_t size;
};

constexpr std::array<ComponentShape, 6> kComponents = {{{Component::i8, "BYTE", 1},
                                                        {Component::u8, "UNSIGNED_BYTE", 1},
                                                        {Component::i16, "SHORT", 2},
                                                        {Component::u16, "UNSIGNED_SHORT", 2},
                                                        {Component::u32, "UNSIGNED_INT", 4},
                                                        {Component::f32, "FLOAT", 4}}};

const ComponentShape& shape_of(Component component) {
  for (const ComponentShape& shape : kComponents) {
    if (shape.component == component) return shape;
  }
  return kComponents.back();
}

// Bytes from one element to the next: the columns of a matrix start at multiples of 4 (glTF 2.0, 3.6.2.4).
std::uint32_t padded_size(Format format) {
  const TypeShape& shape = kShapes[static_cast<std::size_t>(format.type)];
  const std::uint32_t column = shape.rows * shape_of(format.component).size;
  return shape.columns == 1 ? column : shape.columns * ((column + 3) / 4 * 4);
}

// Bytes of the last element, which needs no padding after it.
std::uint32_t unpadded_size(Format format) {
  const TypeShape& shape = kShapes[static_cast<std::size_t>(format.type)];
  const std::uint32_t column = shape.rows * shape_of(format.component).size;
  return padded_size(format) - (shape.columns == 1 ? 0 : (4 - column % 4) % 4);
}

std::string to_string(Format format) {
  return fmt::format("{} {}{}", kShapes[static_cast<std::size_t>(format.type)].name, shape_of(format.component).name,
                     format.normalized ? " normalized" : "");
}

Component read_component(const Value& value) {
  const std::uint64_t number = value.integer(0, UINT16_MAX);
  for (const ComponentShape& shape : kComponents) {
    if (static_cast<std::uint64_t>(shape.component) == number) return shape.component;
  }
  value.fail(fmt::format("is {}, must be one of 5120, 5121, 5122, 5123, 5125, 5126", number));
}

Type read_type(const Value& value) {
  const std::string_view name = value.text();
  for (std::size_t i = 0; i < kShapes.size(); ++i) {
    if (kShapes[i].name == name) return static_cast<Type>(i);
  }
  value.fail(fmt::format("is '{}', must be SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4", name));
}

Format read_format(const Value& at) {
  Format format;
  format.component = read_component(at.require("componentType"));
  format.type = read_type(at.require("type"));
  const Value normalized = at["normalized"];
  format.normalized = normalized.boolean_or(false);
  if (format.normalized && (format.component == Component::f32 || format.component == Component::u32)) {
    normalized.fail(fmt::format("{} cannot be normalized", shape_of(format.component).name));
  }
  return format;
}

// Elements of `view` from `offset` on, checked for alignment and to fit.
Elements elements_of(const Value& at, const BufferView& view, const Value& offset_value, Format format,
                     std::uint32_t stride, std::uint32_t count) {
  const std::uint64_t offset = offset_value.integer_or(0, 0, INT64_MAX);
  const std::uint32_t size = unpadded_size(format);
  const std::uint32_t component = shape_of(format.component).size;
  const bool is_matrix = kShapes[static_cast<std::size_t>(format.type)].columns > 1;
  const std::uint32_t alignment = is_matrix ? 4 : component;
  if (offset % alignment != 0) offset_value.fail(fmt::format("is {}, must be a multiple of {}", offset, alignment));
  if ((view.offset + offset) % component != 0) {
    at.fail(fmt::format("starts at byte {} of its buffer, must be a multiple of {}", view.offset + offset, component));
  }
  if (stride < size) {
    at.fail(fmt::format("its view's byteStride, {}, is less than an element's {} bytes", stride, size));
  }
  const std::uint64_t needed = static_cast<std::uint64_t>(stride) * (count - 1) + size;
  if (offset > view.length || needed > view.length - offset) {
    at.fail(fmt::format("{} bytes from {} on do not fit its view of {} bytes", needed, offset, view.length));
  }
  return {view.data ? view.data + offset : nullptr, stride, count};
}

}  // namespace

std::uint32_t component_count(Type type) {
  const TypeShape& shape = kShapes[static_cast<std::size_t>(type)];
  return shape.columns * shape.rows;
}

Accessors::Accessors(Value root, const Buffers& buffers, const GltfLimits& limits)
    : buffers_(buffers), elements_("load.elements", limits.elements) {
  const std::vector<Value> accessors = root["accessors"].elements();
  accessors_.reserve(accessors.size());
  for (const Value& accessor : accessors) read_accessor(accessor);
}

void Accessors::read_accessor(const Value& at) {
  Accessor& accessor = accessors_.emplace_back();
  accessor.at = at;
  accessor.format = read_format(at);
  const Value count = at.require("count");
  accessor.elements.count = static_cast<std::uint32_t>(count.integer(1, UINT32_MAX));
  if (!elements_.fits(accessor.elements.count)) count.fail("is " + elements_.refusal(accessor.elements.count));
  if (const Value reference = at["bufferView"]) {
    const BufferView& view = buffers_.view(reference);
    const std::uint32_t stride = view.stride.value_or(padded_size(accessor.format));
    const Value offset = at["byteOffset"];
    accessor.elements = elements_of(at, view, offset, accessor.format, stride, accessor.elements.count);
    accessor.lacks_data = view.data == nullptr;
    accessor.aligned_for_vertices = offset.integer_or(0, 0, INT64_MAX) % 4 == 0 && stride % 4 == 0;
  }
  if (const Value sparse = at["sparse"]) read_sparse(sparse, accessor);
}

void Accessors::read_sparse(const Value& sparse, Accessor& accessor) {
  const auto count = static_cast<std::uint32_t>(sparse.require("count").integer(1, accessor.elements.count));
  const auto packed = [&](const Value& part, Format format) {
    const Value reference = part.require("bufferView");
    const BufferView& view = buffers_.view(reference);
    if (view.stride) reference.fail("is a view with byteStride, which sparse data cannot have");
    accessor.lacks_data |= view.data == nullptr;
    return elements_of(part, view, part["byteOffset"], format, padded_size(format), count);
  };
  const Value indices = sparse.require("indices");
  const Value component = indices.require("componentType");
  const Format index_format{Type::scalar, read_component(component), false};
  if (index_format.component != Component::u8 && index_format.component != Component::u16 &&
      index_format.component != Component::u32) {
    component.fail("must be 5121, 5123 or 5125: indices are unsigned");
  }
  accessor.sparse_index_component = index_format.component;
  accessor.sparse_indices = packed(indices, index_format);
  accessor.sparse_values = packed(sparse.require("values"), accessor.format);
}

const Accessor& Accessors::find(const Value& reference, std::span<const Format> allowed, Integers integers) {
  const Accessor& accessor = any(reference);
  const auto is_allowed = [&](const Format& format) { return std::ranges::find(allowed, format) != allowed.end(); };
  const auto checked = [](const Accessor& found) -> const Accessor& {
    if (found.lacks_data) found.at.fail("lies in a buffer that has no uri, nor is it the file's binary chunk");
    return found;
  };
  if (is_allowed(accessor.format)) return checked(accessor);
  Format normalized = accessor.format;
  normalized.normalized = true;
  if (integers == Integers::normalized && is_allowed(normalized)) {
    reference.repair(fmt::format("is an accessor of {}; it was read as normalized", to_string(accessor.format)));
    Accessor& marked = normalized_[index_of(reference)] = accessor;
    marked.format = normalized;
    return checked(marked);
  }
  std::string names;
  for (const Format& format : allowed) names += (names.empty() ? "" : ", ") + to_string(format);
  reference.fail(fmt::format("is an accessor of {}, must be one of: {}", to_string(accessor.format), names));
}

const Accessor& Accessors::any(const Value& reference) const {
  const std::uint32_t index = index_of(reference);
  const auto replaced = replaced_.find(index);
  return replaced == replaced_.end() ? accessors_[index] : replaced->second.accessor;
}

std::uint32_t Accessors::index_of(const Value& reference) const {
  return reference.reference(static_cast<std::uint32_t>(accessors_.size()), "accessors");
}

void Accessors::replace(const Value& reference, Component component, std::uint32_t count,
                        std::vector<std::byte> elements) {
  const std::uint32_t index = index_of(reference);
  Replacement& replacement = replaced_[index];
  replacement.bytes = std::move(elements);
  Accessor& accessor = replacement.accessor = {.at = accessors_[index].at, .format = accessors_[index].format};
  accessor.format.component = component;
  accessor.elements = {replacement.bytes.data(), padded_size(accessor.format), count};
}

void Accessors::claim(const Value& place, std::uint64_t elements) {
  if (!elements_.fits(elements)) place.fail("with it, the scene has " + elements_.refusal(elements));
  elements_.spend(elements);
}

}  // namespace velarium::scene::gltf
