#pragma once

// Buffers, read once, and the views into them.

#include "core/budget.hpp"
#include "scene/gltf_container.hpp"
#include "scene/gltf_json.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace velarium::scene::gltf {

struct BufferView {
  const std::byte* data = nullptr;      // null where its buffer has no data
  std::uint64_t length = 0;             // bytes
  std::uint64_t offset = 0;             // in its buffer, for alignment rules
  std::optional<std::uint32_t> stride;  // bytes, where the view gives one
};

class Buffers {
 public:
  // Reads every buffer, checks every view against its buffer, and decompresses those of EXT_meshopt_compression.
  // `container` must outlive the result. A buffer may lack data, as a fallback that an extension replaces does: that is
  // an error where it is used.
  Buffers(Value root, const Container& container, const GltfOptions& options);

  // The view that a JSON number refers to; throws at its pointer where there is none.
  [[nodiscard]] const BufferView& view(const Value& reference) const;

 private:
  void read_buffer(const Value& buffer, std::uint32_t index, const Container& container, const GltfOptions& options);
  void read_view(const Value& view);
  struct Range {
    const std::byte* data = nullptr;  // null where the buffer has no data
    std::uint64_t offset = 0, length = 0;
  };
  [[nodiscard]] Range read_range(const Value& view) const;
  void decompress(const Value& extension, BufferView& view);

  std::vector<std::vector<std::byte>> owned_;  // of buffers that are not the BIN chunk, and of decompressed views
  struct Buffer {
    const std::byte* data = nullptr;
    std::uint64_t length = 0;
  };
  std::vector<Buffer> buffers_;
  std::vector<BufferView> views_;
  Budget bytes_;  // of what owned_ was read from, or decompressed to
};

}  // namespace velarium::scene::gltf
