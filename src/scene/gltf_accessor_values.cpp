#include "core/assert.hpp"
#include "scene/gltf_accessors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace velarium::scene::gltf {

namespace {

template <class T>
T load(const std::byte* from) {  // memory of a file may be misaligned
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// glTF 2.0, 3.6.2.2 with 3.11: c / (2^bits - 1), and max(c / (2^(bits - 1) - 1), -1) for signed integers.
template <class T>
float widened(T value, bool normalized) {
  if (!normalized) return static_cast<float>(value);
  return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

template <class T>
void widen_elements(const Elements& elements, std::uint32_t components, bool normalized, float* out) {
  for (std::uint32_t i = 0; i < elements.count; ++i) {
    const std::byte* element = elements.first + static_cast<std::size_t>(i) * elements.stride;
    for (std::uint32_t c = 0; c < components; ++c) *out++ = widened(load<T>(element + c * sizeof(T)), normalized);
  }
}

void copy_floats(const Elements& elements, std::uint32_t components, float* out) {
  const std::size_t size = components * sizeof(float);
  if (elements.stride == size) {
    std::memcpy(out, elements.first, size * elements.count);
    return;
  }
  for (std::uint32_t i = 0; i < elements.count; ++i) {
    std::memcpy(out + static_cast<std::size_t>(i) * components,
                elements.first + static_cast<std::size_t>(i) * elements.stride, size);
  }
}

void widen(const Elements& elements, Format format, std::uint32_t components, float* out) {
  switch (format.component) {
    case Component::i8:
      return widen_elements<std::int8_t>(elements, components, format.normalized, out);
    case Component::u8:
      return widen_elements<std::uint8_t>(elements, components, format.normalized, out);
    case Component::i16:
      return widen_elements<std::int16_t>(elements, components, format.normalized, out);
    case Component::u16:
      return widen_elements<std::uint16_t>(elements, components, format.normalized, out);
    case Component::u32:
      return widen_elements<std::uint32_t>(elements, components, format.normalized, out);
    case Component::f32:
      return copy_floats(elements, components, out);
  }
}

std::uint32_t load_unsigned(const std::byte* from, Component component) {
  switch (component) {
    case Component::u8:
      return load<std::uint8_t>(from);
    case Component::u16:
      return load<std::uint16_t>(from);
    default:
      VEL_ASSERT(component == Component::u32);
      return load<std::uint32_t>(from);
  }
}

template <class Out>
void widen_unsigned(const Elements& elements, Component component, std::uint32_t components, Out* out) {
  if (component == Component::u32 && sizeof(Out) == 4 && elements.stride == components * 4) {
    std::memcpy(out, elements.first, static_cast<std::size_t>(elements.count) * elements.stride);
    return;
  }
  const std::size_t size = component == Component::u8 ? 1 : component == Component::u16 ? 2 : 4;
  for (std::uint32_t i = 0; i < elements.count; ++i) {
    const std::byte* element = elements.first + static_cast<std::size_t>(i) * elements.stride;
    for (std::uint32_t c = 0; c < components; ++c) {
      *out++ = static_cast<Out>(load_unsigned(element + c * size, component));
    }
  }
}

// Decodes the base elements, then those that the sparse part replaces. `decode(elements, out)` writes
// `components` values an element.
template <class T, class Decode>
void fill(const Accessor& accessor, std::uint32_t components, T* out, const Decode& decode) {
  if (accessor.elements.first) decode(accessor.elements, out);
  const std::uint32_t replaced = accessor.sparse_indices.count;
  if (replaced == 0) return;
  std::vector<T> values(static_cast<std::size_t>(replaced) * components);
  decode(accessor.sparse_values, values.data());
  const Value indices = accessor.at["sparse"]["indices"];
  std::int64_t previous = -1;
  for (std::uint32_t i = 0; i < replaced; ++i) {
    const std::byte* place =
        accessor.sparse_indices.first + static_cast<std::size_t>(i) * accessor.sparse_indices.stride;
    const std::uint32_t index = load_unsigned(place, accessor.sparse_index_component);
    if (index >= accessor.elements.count) {
      indices.fail(fmt::format("number {} is {}, but the accessor has {} elements", i, index, accessor.elements.count));
    }
    if (index <= previous) indices.fail(fmt::format("number {} is {}, not more than the one before", i, index));
    previous = index;
    std::copy_n(values.data() + static_cast<std::size_t>(i) * components, components,
                out + static_cast<std::size_t>(index) * components);
  }
}

bool is_finite(float value) {  // in integers, so that the loop over all elements vectorises
  return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) != 0x7f800000u;
}

}  // namespace

void Accessors::fill_floats(const Accessor& accessor, float* out, std::size_t float_count) {
  const auto components = static_cast<std::uint32_t>(float_count / accessor.elements.count);
  // Narrow matrices have padded columns; nothing in glTF uses them, and find() lets none through.
  VEL_ASSERT(accessor.format.type <= Type::vec4 || accessor.format.component == Component::f32);
  fill(accessor, components, out,
       [&](const Elements& elements, float* to) { widen(elements, accessor.format, components, to); });
  if (accessor.format.component != Component::f32) return;
  bool all_finite = true;
  for (std::size_t i = 0; i < float_count; ++i) all_finite &= is_finite(out[i]);
  if (all_finite) return;
  const auto wrong = static_cast<std::size_t>(std::find_if_not(out, out + float_count, is_finite) - out);
  accessor.at.fail(fmt::format("element {} holds {}; export the scene without it", wrong / components, out[wrong]));
}

std::vector<std::uint32_t> Accessors::read_indices(const Accessor& accessor) {
  std::vector<std::uint32_t> out = allocate<std::uint32_t>(accessor);
  fill(accessor, 1, out.data(), [&](const Elements& elements, std::uint32_t* to) {
    widen_unsigned(elements, accessor.format.component, 1, to);
  });
  return out;
}

std::vector<glm::u16vec4> Accessors::read_joints(const Accessor& accessor) {
  std::vector<glm::u16vec4> out = allocate<glm::u16vec4>(accessor);
  fill(accessor, 4, glm::value_ptr(out.front()),
       [&](const Elements& elements, glm::uint16* to) { widen_unsigned(elements, accessor.format.component, 4, to); });
  return out;
}

}  // namespace velarium::scene::gltf
