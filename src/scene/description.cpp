#include "scene/description.hpp"

#include "scene/description_parts.hpp"
#include "scene/gltf_parts.hpp"

namespace velarium::scene {

Scene described_scene(const SceneDescription& description) {
  Scene scene;
  scene.source = description.name.empty() ? "made in code" : "made in code: " + description.name;
  description::add_images(description, scene);
  description::add_materials(description, scene);
  description::add_meshes(description, scene);
  description::add_nodes(description, scene);
  description::add_lights(description, scene);
  description::add_cameras(description, scene);
  // What a file may leave out too: bounds, flat normals, tangents for normal maps.
  gltf::complete_primitives(scene);
  return scene;
}

}  // namespace velarium::scene
