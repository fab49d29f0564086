#pragma once

// Scenes that a program describes by values: velarium/scene_description.hpp.

#include "scene/scene.hpp"

#include <velarium/scene_description.hpp>

namespace velarium::scene {

// Materials, meshes, nodes and images keep their indices; lights and cameras get nodes of their own behind the others.
// Throws Error(usage) that names the place at fault.
[[nodiscard]] Scene described_scene(const SceneDescription& description);

}  // namespace velarium::scene
