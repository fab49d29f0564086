#pragma once

// Accessors: typed arrays over buffer views, widened to what the scene tables hold.

#include "core/budget.hpp"
#include "scene/gltf_buffers.hpp"
#include "scene/gltf_json.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace velarium::scene::gltf {

enum class Component : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class Type : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

[[nodiscard]] std::uint32_t component_count(Type type);

struct Format {
  Type type = Type::scalar;
  Component component = Component::f32;
  bool normalized = false;
  bool operator==(const Format&) const = default;
};

// Elements of one format at equal distances; the reader has checked that all lie inside their view.
struct Elements {
  const std::byte* first = nullptr;  // null: all zeros, or no data
  std::uint32_t stride = 0;          // bytes
  std::uint32_t count = 0;
};

struct Accessor {
  Value at;
  Format format;
  Elements elements;
  bool lacks_data = false;           // it lies in a buffer without data, and is not to be read
  bool aligned_for_vertices = true;  // offset and stride are multiples of 4, as glTF asks of vertex attributes
  // Elements that replace others; count 0 where the accessor is not sparse.
  Component sparse_index_component = Component::u32;
  Elements sparse_indices, sparse_values;
};

// How an attribute means integers that are not marked as normalised: by their values, or as shares of 1 whose mark is
// missing.
enum class Integers : std::uint8_t { as_written, normalized };

class Accessors {
 public:
  // Checks every accessor against its view. `buffers` must outlive the result.
  Accessors(Value root, const Buffers& buffers, const GltfLimits& limits);

  // The accessor that a JSON number refers to. Throws at its pointer where there is none, or one whose format is not
  // among those allowed.
  // With Integers::normalized, integers that should be normalised and are not are found as if they were, with a repair.
  [[nodiscard]] const Accessor& find(const Value& reference, std::span<const Format> allowed,
                                     Integers integers = Integers::as_written);
  // The same of any format.
  [[nodiscard]] const Accessor& any(const Value& reference) const;

  // Floats, normalised integers widened to floats; finite, or it throws. The element is a float or a float vector or
  // matrix of the accessor's type.
  template <class Element>
  [[nodiscard]] std::vector<Element> read_floats(const Accessor& accessor) {
    std::vector<Element> out = allocate<Element>(accessor);
    fill_floats(accessor, reinterpret_cast<float*>(out.data()), out.size() * sizeof(Element) / sizeof(float));
    return out;
  }
  // Unsigned scalars, and vectors of four shorts, widened.
  [[nodiscard]] std::vector<std::uint32_t> read_indices(const Accessor& accessor);
  [[nodiscard]] std::vector<glm::u16vec4> read_joints(const Accessor& accessor);

  // Until restore(), the accessor that `reference` names holds these packed elements instead of those of its view.
  // Their type, and whether they are normalised, the accessor says.
  void replace(const Value& reference, Component component, std::uint32_t count, std::vector<std::byte> elements);
  void restore() { replaced_.clear(); }

  [[nodiscard]] const Buffers& buffers() const { return buffers_; }
  [[nodiscard]] const Budget& elements() const { return elements_; }
  // Claims memory for elements that are not read from an accessor; throws at `place` beyond the scene's limit.
  void claim(const Value& place, std::uint64_t elements);

 private:
  [[nodiscard]] std::uint32_t index_of(const Value& reference) const;
  void read_accessor(const Value& at);
  void read_sparse(const Value& sparse, Accessor& accessor);
  template <class Element>
  [[nodiscard]] std::vector<Element> allocate(const Accessor& accessor) {
    constexpr std::uint64_t kClaimedSize = sizeof(glm::vec4);  // a larger element, such as a matrix, counts as several
    claim(accessor.at, accessor.elements.count * std::max<std::uint64_t>(1, sizeof(Element) / kClaimedSize));
    return std::vector<Element>(accessor.elements.count);
  }
  static void fill_floats(const Accessor& accessor, float* out, std::size_t float_count);

  const Buffers& buffers_;
  Budget elements_;
  std::vector<Accessor> accessors_;
  struct Replacement {
    std::vector<std::byte> bytes;
    Accessor accessor;  // over these bytes
  };
  std::map<std::uint32_t, Replacement> replaced_;  // by index
  std::map<std::uint32_t, Accessor> normalized_;   // by index: as if they were marked
};

}  // namespace velarium::scene::gltf
