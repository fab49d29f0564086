#include <velarium/scene.hpp>

#include "scene/builtin.hpp"
#include "scene/description.hpp"
#include "scene/gltf.hpp"
#include "scene/snapshot.hpp"
#include "scene/scene.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

namespace velarium {
namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";

std::array<float, 3> to_array(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

void count_primitive(const scene::Primitive& primitive, SceneInfo& info) {
  const std::size_t indices = primitive.indices.size();
  switch (primitive.topology) {
    case scene::Topology::points:
      info.points += indices;
      break;
    case scene::Topology::lines:
      info.lines += indices / 2;
      break;
    case scene::Topology::triangles:
      info.triangles += indices / 3;
      break;
  }
  info.vertices += primitive.vertex_count();
}

void count_tables(const scene::Scene& scene, SceneInfo& info) {
  info.nodes = scene.nodes.size();
  info.meshes = scene.meshes.size();
  info.primitives = scene.primitives.size();
  info.materials = scene.materials.size();
  info.textures = scene.textures.size();
  info.images = scene.images.size();
  info.skins = scene.skins.size();
  for (const auto& image : scene.images) info.texels += std::uint64_t{image.width} * image.height;
  for (const auto& primitive : scene.primitives) info.morph_targets += primitive.morph_targets.size();
  for (const auto& animation : scene.animations)
    info.animations.push_back({animation.name, animation.duration, animation.channels.size()});
}

const char* kind_name(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::directional:
      return "directional";
    case scene::LightKind::point:
      return "point";
    case scene::LightKind::spot:
      return "spot";
  }
  return "";
}

// What the scene shows at time 0: instances are counted as often as they are drawn.
void count_moment(const scene::Scene& scene, SceneInfo& info) {
  const auto snapshot = scene::snapshot_at(scene, 0.0f, "");
  for (const auto& instance : snapshot.instances) count_primitive(scene.primitives[instance.primitive], info);
  for (const auto& [camera, matrix] : snapshot.cameras)
    info.cameras.push_back({camera.name,
                            camera.kind == scene::Camera::Kind::perspective ? "perspective" : "orthographic",
                            camera.z_near, camera.z_far});
  for (const auto& [light, position, direction, right] : snapshot.lights)
    info.lights.push_back({light.name, kind_name(light.kind), to_array(light.color), light.intensity});
  if (snapshot.bounds.empty()) return;
  info.bounds_min = to_array(snapshot.bounds.min);
  info.bounds_max = to_array(snapshot.bounds.max);
}

// Programs set members of LoadOptions directly. Their texts, read back, go through the checks of the options table.
void check_limits(const Settings::load_settings& limits) {
  Settings settings, read_back;
  settings.load = limits;
  for (const OptionInfo& option : option_table()) {
    if (option.key.starts_with("load.")) set_option(read_back, option.key, get_option(settings, option.key));
  }
}

void add_parameters(SceneInfo& info) {
  if (!info.source.starts_with(kBuiltinPrefix)) return;
  for (auto& p : scene::builtin_parameters(info.source.substr(kBuiltinPrefix.size())))
    info.parameters.push_back({std::move(p.key), p.value, p.least, p.most, std::move(p.meaning), std::move(p.names)});
}

}  // namespace

Scene Scene::load(const std::filesystem::path& file, const LoadOptions& options) {
  check_limits(options.limits);
  const std::string name = file.string();
  if (name.starts_with(kBuiltinPrefix)) {
    if (!options.variant.empty()) throw Error(ErrorCode::usage, name, "a built-in scene has no variants");
    return Scene(std::make_shared<scene::Scene>(scene::builtin_scene(name.substr(kBuiltinPrefix.size()))));
  }
  return Scene(
      std::make_shared<scene::Scene>(scene::read_gltf(file, {.allow_outside_files = options.allow_outside_files,
                                                             .strict = options.strict,
                                                             .variant = options.variant,
                                                             .limits = options.limits})));
}

Scene Scene::make(const SceneDescription& description) {
  return Scene(std::make_shared<scene::Scene>(scene::described_scene(description)));
}

std::vector<std::string> Scene::builtin_names() {
  return scene::builtin_names();
}

SceneInfo Scene::info() const {
  SceneInfo info{.source = tables_->source, .generator = tables_->generator};
  count_tables(*tables_, info);
  count_moment(*tables_, info);
  info.variants = tables_->variants;
  add_parameters(info);
  info.extensions_used = tables_->extensions_used;
  info.extensions_required = tables_->extensions_required;
  info.warnings = tables_->warnings;
  return info;
}

}  // namespace velarium
