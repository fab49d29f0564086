#pragma once

// The parts of the reader, in the order in which gltf.cpp calls them. Each fills its tables of context.scene,
// and throws Error(input_invalid) at the JSON pointer at fault.

#include "scene/gltf_accessors.hpp"
#include "scene/gltf_extensions.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace velarium::scene::gltf {

// asset: version 2.x, minVersion at most 2.0. Throws Error(unsupported) for other versions.
void read_asset(Context& context);

// Finds options.variant among those of the file. Throws Error(usage) that lists them where it is not there.
void choose_variant(Context& context);

// textures with their samplers; materials with their extensions. Images are left for read_images().
void read_textures(Context& context);
void read_materials(Context& context);
// A textureInfo of a material; absent: no texture.
[[nodiscard]] TextureRef read_texture_ref(Context& context, const Value& value);
// Makes the G channel perceptual roughness, 1 - factor * A, and the others nothing.
void glossiness_to_roughness(float factor, std::vector<std::uint8_t>& rgba);
// Every use of a texture that a material can have, present or not.
[[nodiscard]] std::array<const TextureRef*, 7> texture_refs(const Material& material);
[[nodiscard]] std::array<TextureRef*, 7> texture_refs(Material& material);

void read_cameras(Context& context);

// Meshes and their primitives as lists of points, lines or triangles. Normals and tangents that the file lacks are left
// for complete_primitives(), which works on all cores.
void read_meshes(Context& context, Accessors& accessors);
void complete_primitives(Scene& scene);

// How many morph targets the primitives of a mesh have.
[[nodiscard]] std::uint32_t morph_target_count(const Context& context, std::uint32_t mesh);

// Nodes as a forest, the copies of their meshes, skins, and the roots of the scene that is shown.
void read_nodes(Context& context);
void read_node_instances(Context& context, Accessors& accessors);
void read_skins(Context& context, Accessors& accessors);
void read_scenes(Context& context);
// What nodes, meshes and skins must agree about.
void check_instances(Context& context);

void read_animations(Context& context, Accessors& accessors);

// Volumes that lights end at, and which light at which: after all that needs the meshes of their nodes, which it takes
// away.
void read_clip_volumes(Context& context);

// Volumes in which environment light is multiplied.
void read_ambient_lights(Context& context);

// Decodes, on all cores, the images that materials of the shown scene and lights use, each once.
void read_images(Context& context, const Buffers& buffers);

}  // namespace velarium::scene::gltf
