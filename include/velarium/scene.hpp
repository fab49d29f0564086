#pragma once

#include <velarium/scene_description.hpp>
#include <velarium/settings.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace velarium {

namespace scene {
struct Scene;
}

struct LoadOptions {
  bool allow_outside_files = false;  // may a scene name files outside its own folder?
  bool strict = false;               // refuse breaches of glTF that would be read with a warning
  std::string variant;               // of the materials: a name or index; "none" or empty: the usual ones
  // Group `load` of options.def; what exceeds one is refused before memory is asked for.
  Settings::load_settings limits;
};

// What `velarium info` tells.
struct SceneInfo {
  std::string source;
  std::string generator;
  std::uint64_t nodes = 0, meshes = 0, primitives = 0, vertices = 0, triangles = 0, lines = 0, points = 0;
  std::uint64_t materials = 0, textures = 0, images = 0, texels = 0, skins = 0, morph_targets = 0;
  struct Animation {
    std::string name;
    float duration_s;
    std::uint64_t channels;
  };
  struct Camera {
    std::string name;
    std::string kind;
    // Distances along the view axis at which gbuffer.depth is 1 and 0; far_m is infinite where a perspective view has
    // no end. At distance d it is, perspective, near_m / d without an end, else near_m (far_m - d) / (d (far_m -
    // near_m)); orthographic, (far_m - d) / (far_m - near_m).
    float near_m, far_m;
  };
  struct Light {
    std::string name;
    std::string kind;
    std::array<float, 3> color;
    float intensity;
  };
  struct Parameter {
    std::string key;
    std::uint32_t value, least, most;
    std::string meaning;
    std::vector<std::string> names;  // of the values from 0 on, which are written by them; empty: by their numbers
  };
  std::vector<Animation> animations;
  std::vector<Camera> cameras;                      // as instanced in the scene, at time 0
  std::vector<Light> lights;                        // as instanced in the scene, at time 0
  std::array<float, 3> bounds_min{}, bounds_max{};  // metres, world space, at time 0
  std::vector<std::string> variants;                // that LoadOptions::variant can name
  std::vector<Parameter> parameters;                // of a built-in scene: "builtin:NAME?key=value&key=value"
  std::vector<std::string> extensions_used, extensions_required, warnings;
};

// A scene, loaded or made. Immutable, cheap to copy, and may be shared between threads and engines.
class Scene {
 public:
  // A .gltf or .glb file, or "builtin:NAME", or "builtin:NAME?key=value". Throws Error(input_missing, input_invalid,
  // unsupported), and Error(usage) that lists the variants where LoadOptions::variant is not among them, names a limit
  // out of its range, or lists the parameters where one is wrong.
  [[nodiscard]] static Scene load(const std::filesystem::path& file, const LoadOptions& options = {});
  // The scene that a program describes; it keeps nothing of the description. Throws Error(usage) that names the place
  // at fault, such as "scene description: meshes[2].indices[7] is 9, but there are 4 positions": where a value is not
  // finite or out of its range, an index leads nowhere, or counts do not match.
  [[nodiscard]] static Scene make(const SceneDescription& description);
  [[nodiscard]] static std::vector<std::string> builtin_names();

  [[nodiscard]] SceneInfo info() const;
  [[nodiscard]] const scene::Scene& tables() const { return *tables_; }

 private:
  explicit Scene(std::shared_ptr<const scene::Scene> tables) : tables_(std::move(tables)) {}
  std::shared_ptr<const scene::Scene> tables_;
};

}  // namespace velarium
