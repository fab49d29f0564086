#pragma once

// Reader of glTF 2.0 (.gltf, .glb): strict, bounded, safe on files from anywhere.
//
// What has no reading, or more than one, is refused. A breach of the specification that leaves one plausible reading
// (a rotation not quite of unit length, a factor just out of its range) is read so, with a line in Scene::warnings.

#include "scene/scene.hpp"

#include <filesystem>
#include <string>

namespace velarium::scene {

struct GltfLimits {                           // checked before anything of that size is allocated
  std::uint64_t file_bytes = 4ull << 30;      // of one file, and of all buffers together
  std::uint64_t elements = 1ull << 28;        // of one accessor
  std::uint64_t scene_elements = 1ull << 28;  // of all accessors, counting each use; a matrix is four
  std::uint64_t image_pixels = 1ull << 28;    // of one image
  std::uint64_t scene_pixels = 1ull << 31;    // of all images
  std::uint32_t image_size = 16384;           // width or height
  std::uint32_t nodes = 1u << 20;
  std::uint32_t depth = 256;  // of the node tree, and of JSON
};

struct GltfOptions {
  bool allow_outside_files = false;  // may URIs leave the file's folder?
  std::string variant;               // KHR_materials_variants: a name or index; "none" or empty: the usual materials
  GltfLimits limits;
};

// Meshes, materials, nodes, skins and cameras keep the file's indices; images are those alone that a material in use
// shows, and the other textures have none. Primitives that draw nothing (no positions, too few vertices) are left out.
//
// Throws Error(input_missing), Error(input_invalid) with a JSON pointer and reason,
// Error(unsupported) that names the required extensions that are not supported,
// or Error(usage) that lists the variants where the one asked for is not among them.
[[nodiscard]] Scene read_gltf(const std::filesystem::path& file, const GltfOptions& options = {});

}  // namespace velarium::scene
