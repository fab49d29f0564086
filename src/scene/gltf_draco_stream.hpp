#pragma once

// Meshes of Draco's bitstream 2.2, decoded within bounds that are checked before memory is asked for.

#include "core/budget.hpp"
#include "scene/gltf_json.hpp"

#include <draco/mesh/mesh.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace velarium::scene::gltf {

class DracoCursor;

class DracoStream {
 public:
  // Reads the header; `bytes` must outlive the result. Throws at `at` where it is none of a triangle mesh, or ends
  // early, and Error(unsupported) where it is of another version of the bitstream.
  DracoStream(const Value& at, std::span<const std::byte> bytes);

  [[nodiscard]] std::uint32_t faces() const { return faces_; }
  // Decoding may split points where attributes have seams, but never joins them.
  [[nodiscard]] std::uint32_t fewest_points() const { return fewest_points_; }

  struct Bounds {
    std::uint32_t points = 0;  // that the mesh must have
    const Budget& elements;    // of 16 bytes, that its tables, and then its attributes, may take
  };
  // Throws where the mesh does not keep to the bounds, and where the stream is damaged; Error(temporary) where memory
  // runs out. Vertices of faces and values of attributes may still be out of range.
  [[nodiscard]] std::unique_ptr<draco::Mesh> decode(const Bounds& bounds) const;

 private:
  void read_counts(DracoCursor& cursor);
  void check_tables(const Bounds& bounds) const;

  Value at_;
  std::span<const std::byte> bytes_;
  std::vector<std::byte> without_metadata_;  // what bytes_ then shows
  bool edgebreaker_ = false;
  std::uint32_t faces_ = 0, fewest_points_ = 0, attribute_tables_ = 0;
};

}  // namespace velarium::scene::gltf
