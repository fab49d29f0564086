#pragma once

// What a request asks to be seen: shared by all that make pictures of a scene.

#include "image/image.hpp"
#include "scene/snapshot.hpp"

#include <velarium/engine.hpp>

#include <optional>
#include <string>
#include <vector>

namespace velarium::api {

// The name of the environment that a picture gets: what was asked for, else what the scene is made for, else the studio
// where the scene brings no light. Adds a note where a user might miss one.
[[nodiscard]] std::string environment_choice(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                             const RenderRequest& request, std::vector<std::string>& notes);

// The lights of a picture: the scene's, unless settings.lighting.punctual puts them out, and the request's sun.
void set_lights(const RenderRequest& request, scene::SceneSnapshot& snapshot);

// The equirectangular picture of an environment: built in, or a file. None for "none". Throws as load_radiance().
[[nodiscard]] std::optional<image::FloatImage> environment_pixels(const std::string& name);

// Throws Error(usage) as choose_camera() and look_at_camera().
[[nodiscard]] scene::CameraInstance camera_of(const scene::SceneSnapshot& snapshot, const RenderRequest& request);

}  // namespace velarium::api
