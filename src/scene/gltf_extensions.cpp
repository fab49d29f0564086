#include "scene/gltf_extensions.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace velarium::scene::gltf {

namespace {

// A later extension is a row here, and its hooks beside what they extend.
constexpr std::array kExtensions = {
    Extension{.name = "EXT_mesh_gpu_instancing"},  // read_node_instances() reads it: it needs accessors
    Extension{.name = "EXT_meshopt_compression"},  // Buffers reads it, under both names
    Extension{.name = "EXT_texture_webp", .texture = read_webp_source},
    Extension{.name = "KHR_draco_mesh_compression"},  // DracoGeometry reads it: it needs accessors
    Extension{.name = "KHR_lights_punctual", .document = read_lights_punctual, .node = read_node_light},
    Extension{.name = "KHR_materials_emissive_strength", .material = read_emissive_strength},
    Extension{.name = "KHR_materials_ior", .material = read_ior},
    Extension{.name = "KHR_materials_specular", .material = read_specular},
    Extension{.name = "KHR_materials_unlit", .material = read_unlit},
    Extension{.name = "KHR_materials_variants", .document = read_variants, .primitive = read_variant_material},
    Extension{.name = "KHR_mesh_quantization"},  // adds no object: attribute formats ask Context::uses()
    Extension{.name = "KHR_meshopt_compression"},
    Extension{.name = "KHR_texture_transform", .texture_ref = read_texture_transform},
    // After the other extensions of materials, which it overrides; KHR_materials_unlit overrides it.
    Extension{.name = "KHR_materials_pbrSpecularGlossiness", .material = read_specular_glossiness},
};

bool is_supported(std::string_view name) {
  return std::ranges::any_of(kExtensions, [&](const Extension& extension) { return extension.name == name; });
}

}  // namespace

std::span<const Extension> supported_extensions() {
  return kExtensions;
}

void read_extension_lists(Context& context) {
  std::string lacking;
  for (const Value& name : context.root["extensionsRequired"].elements()) {
    context.scene.extensions_required.emplace_back(name.text());
    if (!is_supported(name.text())) lacking += (lacking.empty() ? "" : ", ") + std::string(name.text());
  }
  if (!lacking.empty()) {
    throw Error(ErrorCode::unsupported, context.root.file(),
                fmt::format("/extensionsRequired: the file requires {}, which this program does not support; "
                            "export it without",
                            lacking));
  }
  for (const Value& name : context.root["extensionsUsed"].elements()) {
    if (!context.extensions_used.emplace(name.text()).second) continue;
    context.scene.extensions_used.emplace_back(name.text());
    if (!is_supported(name.text())) name.warn(fmt::format("{} is not supported; it is ignored", name.text()));
  }
}

}  // namespace velarium::scene::gltf
