#include "scene/gltf.hpp"

#include "scene/gltf_container.hpp"
#include "scene/gltf_parts.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <charconv>

namespace velarium::scene {

namespace gltf {

namespace {

struct Version {
  std::uint32_t major = 0, minor = 0;
};

// ^[0-9]+\.[0-9]+$, the schema's pattern.
Version read_version(const Value& value) {
  const std::string_view text = value.text();
  const char* const end = text.data() + text.size();
  Version version;
  const auto [dot, major_error] = std::from_chars(text.data(), end, version.major);
  const bool has_minor = major_error == std::errc() && dot != end && *dot == '.';
  const auto [rest, minor_error] = std::from_chars(has_minor ? dot + 1 : end, end, version.minor);
  if (minor_error != std::errc() || rest != end) value.fail(fmt::format("is '{}', must be like \"2.0\"", text));
  return version;
}

}  // namespace

void read_asset(Context& context) {
  const Value asset = context.root.require("asset");
  context.scene.generator = asset["generator"].text_or("");
  const Version version = read_version(asset.require("version"));
  const Value minimum_value = asset["minVersion"];
  const Version minimum = minimum_value ? read_version(minimum_value) : Version{2, 0};
  const bool minimum_exceeds_2_0 = minimum.major > 2 || (minimum.major == 2 && minimum.minor > 0);
  if (version.major == 2 && !minimum_exceeds_2_0) return;
  const Value at = version.major == 2 ? minimum_value : asset["version"];
  throw Error(ErrorCode::unsupported, at.file(),
              fmt::format("{}: the file needs glTF {}, this program reads 2.0; export it as glTF 2.0", at.pointer(),
                          at.text()));
}

}  // namespace gltf

Scene read_gltf(const std::filesystem::path& file, const GltfOptions& options) {
  Scene scene;
  scene.source = file.string();
  const gltf::Container container = gltf::open_container(file, options.limits);
  gltf::Document document(file, container.json, options.limits, options.strict);
  gltf::Context context{document.root(), options, scene};

  gltf::read_asset(context);
  gltf::read_extension_lists(context);
  gltf::read_extensions(context, context.root, &gltf::Extension::document);
  gltf::choose_variant(context);
  const gltf::Buffers buffers(context.root, container, options);
  gltf::Accessors accessors(context.root, buffers, options.limits);
  gltf::read_textures(context);
  gltf::read_materials(context);
  gltf::read_cameras(context);
  gltf::read_meshes(context, accessors);
  gltf::read_nodes(context);
  gltf::read_node_instances(context, accessors);
  gltf::read_skins(context, accessors);
  gltf::check_instances(context);
  gltf::read_scenes(context);
  gltf::read_animations(context, accessors);
  gltf::read_clip_volumes(context);
  gltf::read_ambient_lights(context);
  gltf::read_images(context, buffers);
  gltf::complete_primitives(scene);
  scene.warnings = document.warnings();
  return scene;
}

}  // namespace velarium::scene
