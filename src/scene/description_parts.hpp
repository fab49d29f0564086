#pragma once

// The parts of described_scene(), in the order in which it calls them. Each checks its tables and fills those of the
// scene.

#include "scene/scene.hpp"

#include <velarium/scene_description.hpp>

namespace velarium::scene::description {

void add_images(const SceneDescription& description, Scene& scene);
void add_materials(const SceneDescription& description, Scene& scene);
void add_meshes(const SceneDescription& description, Scene& scene);
void add_nodes(const SceneDescription& description, Scene& scene);
void add_lights(const SceneDescription& description, Scene& scene);
void add_cameras(const SceneDescription& description, Scene& scene);

// x, y, z, w made of unit length, rounded as the reader of files does, so that both place things alike.
[[nodiscard]] glm::quat unit_quaternion(const glm::vec4& xyzw);

// Adds a node, and lists it with its parent or among the roots.
void add_node(Scene& scene, Node node);

}  // namespace velarium::scene::description
