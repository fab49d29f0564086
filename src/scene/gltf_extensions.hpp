#pragma once

// Extensions: one table says which are read, and by what.

#include "scene/gltf.hpp"
#include "scene/gltf_json.hpp"

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace velarium::scene::gltf {

// What every part of the reader works on.
struct Context {
  Value root;
  const GltfOptions& options;
  Scene& scene;  // the tables read so far
  std::set<std::string, std::less<>> extensions_used{};
  // Textures after those of the file show roughness that we make of the glossiness in their image, times these factors.
  std::vector<float> glossiness_factors{};
  std::optional<std::uint32_t> variant{};  // the one that materials are chosen for

  [[nodiscard]] bool uses(std::string_view extension) const { return extensions_used.contains(extension); }
};

// One row a supported extension. A hook reads the extension's object where it stands in an object of that kind, after
// the core properties of that object; a null hook means that the extension is not for such objects.
struct Extension {
  std::string_view name;
  void (*document)(Context&, const Value& extension) = nullptr;
  void (*texture_ref)(Context&, const Value& extension, TextureRef&) = nullptr;
  void (*texture)(Context&, const Value& extension, Texture&) = nullptr;
  void (*material)(Context&, const Value& extension, Material&) = nullptr;
  void (*primitive)(Context&, const Value& extension, Primitive&) = nullptr;
  void (*node)(Context&, const Value& extension, Node&) = nullptr;
};

[[nodiscard]] std::span<const Extension> supported_extensions();

// Reads extensionsUsed and extensionsRequired. Throws Error(unsupported) that names all required ones we lack.
void read_extension_lists(Context& context);

// Calls `hook` of each supported extension that stands in `owner`, in the order of the table.
template <class... Target>
void read_extensions(Context& context, const Value& owner, void (*Extension::*hook)(Context&, const Value&, Target&...),
                     Target&... target) {
  const Value extensions = owner["extensions"];
  if (!extensions) return;
  for (const Extension& extension : supported_extensions()) {
    const Value found = extension.*hook ? extensions[extension.name] : Value();
    if (!found) continue;
    if (!context.uses(extension.name)) found.warn("is not listed in /extensionsUsed; it was read");
    (extension.*hook)(context, found, target...);
  }
}

// The hooks, each beside what it extends.
void read_lights_punctual(Context&, const Value& extension);
void read_node_light(Context&, const Value& extension, Node&);
void read_webp_source(Context&, const Value& extension, Texture&);
void read_texture_transform(Context&, const Value& extension, TextureRef&);
void read_unlit(Context&, const Value& extension, Material&);
void read_emissive_strength(Context&, const Value& extension, Material&);
void read_ior(Context&, const Value& extension, Material&);
void read_specular(Context&, const Value& extension, Material&);
void read_specular_glossiness(Context&, const Value& extension, Material&);
void read_variants(Context&, const Value& extension);
void read_variant_material(Context&, const Value& extension, Primitive&);

}  // namespace velarium::scene::gltf
