#pragma once

// The file as bytes: plain JSON (.gltf) or a binary container (.glb), told apart by content.

#include "scene/gltf.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace velarium::scene::gltf {

struct Container {
  std::vector<std::byte> bytes;  // the whole file; the views below point into it
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  // the BIN chunk
};

// Throws Error(input_missing), or Error(input_invalid) with a byte offset.
[[nodiscard]] Container open_container(const std::filesystem::path& file, const GltfLimits& limits);

}  // namespace velarium::scene::gltf
