// KHR_materials_variants: the names of the variants, and the material that each primitive has in the chosen one.

#include "scene/gltf_parts.hpp"
#include "scene/choice.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <set>

namespace velarium::scene::gltf {

void read_variants(Context& context, const Value& extension) {
  for (const Value& variant : extension.require("variants").elements()) {
    context.scene.variants.emplace_back(variant.require("name").text());
  }
}

void choose_variant(Context& context) {
  const std::string& choice = context.options.variant;
  const std::vector<std::string>& names = context.scene.variants;
  if (choice.empty()) return;
  if (const auto found = find_choice(names, choice)) {
    context.variant = static_cast<std::uint32_t>(*found);
  } else if (choice != "none") {
    throw Error(ErrorCode::usage, context.root.file(), unknown_choice("variant", names, choice, "none"));
  }
}

void read_variant_material(Context& context, const Value& extension, Primitive& primitive) {
  const auto variant_count = static_cast<std::uint32_t>(context.scene.variants.size());
  const auto material_count = static_cast<std::uint32_t>(context.scene.materials.size());
  std::set<std::uint32_t> mapped;
  for (const Value& mapping : extension.require("mappings").elements()) {
    const std::uint32_t material = mapping.require("material").reference(material_count, "materials");
    for (const Value& entry : mapping.require("variants").elements()) {
      const std::uint32_t variant = entry.reference(variant_count, "variants");
      if (!mapped.insert(variant).second) entry.fail(fmt::format("variant {} has a material already", variant));
      if (variant == context.variant) primitive.material = static_cast<std::int32_t>(material);
    }
  }
}

}  // namespace velarium::scene::gltf
