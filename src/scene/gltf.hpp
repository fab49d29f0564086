#pragma once

// Reader of glTF 2.0 (.gltf, .glb): strict, bounded, safe on files from anywhere.
//
// What has no reading, or more than one, is refused. A breach of the specification that leaves one plausible reading
// (a rotation not quite of unit length, a factor just out of its range) is read so, with a line in Scene::warnings;
// GltfOptions::strict refuses it.

#include "scene/scene.hpp"

#include <velarium/settings.hpp>

#include <filesystem>
#include <string>

namespace velarium::scene {

// The group `load` of the options: checked before anything of that size is allocated.
using GltfLimits = Settings::load_settings;

struct GltfOptions {
  bool allow_outside_files = false;  // may URIs leave the file's folder?
  bool strict = false;               // refuse what would be read with a repair
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
