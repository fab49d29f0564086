#pragma once

// Buffers, read once, and the views into them.

#include "scene/gltf_container.hpp"
#include "scene/gltf_json.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace velarium::scene::gltf {

struct BufferView {
  std::span<const std::byte> bytes;
  std::uint64_t offset = 0;             // in its buffer, for alignment rules
  std::optional<std::uint32_t> stride;  // bytes, where the view gives one
};

class Buffers {
 public:
  // Reads every buffer and checks every view against its buffer. `container` must outlive the result.
  Buffers(Value root, const Container& container, const GltfOptions& options);

  [[nodiscard]] const BufferView& view(std::uint32_t index) const { return views_[index]; }
  // The view that a JSON number refers to; throws at its pointer where there is none.
  [[nodiscard]] const BufferView& view(const Value& reference) const;

 private:
  void read_buffer(const Value& buffer, std::uint32_t index, const Container& container, const GltfOptions& options);
  void read_view(const Value& view);

  std::vector<std::vector<std::byte>> owned_;        // of buffers that are not the BIN chunk
  std::vector<std::span<const std::byte>> buffers_;  // exactly as long as their byteLength
  std::vector<BufferView> views_;
  std::uint64_t bytes_left_ = 0;
};

}  // namespace velarium::scene::gltf
