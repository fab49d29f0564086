#pragma once

#include "flags.hpp"

#include <velarium/velarium.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace velarium::app {

// What render, reference and bench have in common: which view of a scene, with which settings, on which device.
struct View {
  RenderRequest request;
  EngineOptions engine;
  LoadOptions load;
  std::optional<std::array<float, 3>> eye, target, up;
  std::optional<float> fov_deg;
};

// Declares the flags that fill `view`.
void add_view_flags(Flags& flags, View& view);

// What the flags together mean: the camera of --eye and its companions, and the limits of the scene. Throws
// Error(usage) where they contradict each other.
void finish_view(View& view);

// What a picture of this scene is called where nobody says: "builtin:atrium" and "folder/atrium.gltf" become atrium.png
// in the current folder.
[[nodiscard]] std::filesystem::path picture_name(const std::string& scene);

// -q and -v.
void add_verbosity_flags(CLI::App& verb);

}  // namespace velarium::app
