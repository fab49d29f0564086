#include "scenes/atrium_daylight.hpp"
#include "scenes/atrium_painters.hpp"
#include "scenes/atrium_parts.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace velarium::scene::atrium {
namespace {

// One painted texture set, and how large it lies on things.
struct Cover {
  const char* name;
  Painter painter;
  std::uint32_t size;  // texels a side
  glm::vec2 metres;
};

struct Maps {
  std::int32_t base_color, normal, metallic_roughness;
  glm::vec2 scale;
};

// In this order the numbers of the sets.
// clang-format off
enum Set : std::size_t {
  kMarbleSet, kTravertineSet, kSectileSet, kMosaicSet, kPoolSet, kFrescoSet, kBrickSet, kTileSet,
  kClaySet, kBronzeSet, kLinenSet, kWoodSet, kRippleSet,
};
// clang-format on

std::vector<Maps> paint_all(SceneBuilder& builder) {
  const std::array<Cover, 13> covers{{
      {"marble", white_marble, 512, glm::vec2(1.5f)},
      {"travertine", travertine, 512, glm::vec2(1.2f)},
      {"opus sectile", opus_sectile, 1024, glm::vec2(3.2f)},
      {"mosaic", mosaic, 512, glm::vec2(0.96f)},
      {"pool mosaic", pool_mosaic, 512, glm::vec2(0.96f)},
      {"fresco", fresco, 1024, {3.0f, 4.2f}},
      {"brick", brick, 512, glm::vec2(1.2f)},
      {"roof tiles", roof_tile, 512, {1.12f, 1.6f}},
      {"terracotta", terracotta, 256, glm::vec2(0.8f)},
      {"bronze", bronze, 256, glm::vec2(0.6f)},
      {"linen", linen, 256, glm::vec2(0.5f)},
      {"wood", wood, 512, glm::vec2(0.8f)},
      {"ripples", ripples, 256, glm::vec2(4.0f)},
  }};
  std::array<Painting, covers.size()> paintings;
  parallel_for(covers.size(),
               [&](std::size_t i) { paintings[i] = paint(covers[i].size, covers[i].metres, covers[i].painter); });
  std::vector<Maps> maps;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    const auto add = [&](Image& image, const char* what) {
      image.name = std::string(covers[i].name) + what;
      return builder.add_texture(std::move(image));
    };
    Painting& p = paintings[i];
    maps.push_back({add(p.base_color, ", colour"), add(p.normal, ", normal"), add(p.metallic_roughness, ", roughness"),
                    1.0f / covers[i].metres});
  }
  return maps;
}

Material plain(const char* name, const glm::vec3& color, float roughness) {
  Material m;
  m.name = name;
  m.base_color = glm::vec4(color, 1.0f);
  m.metallic = 0.0f;
  m.perceptual_roughness = roughness;
  return m;
}

Material painted(const char* name, const Maps& maps, const glm::vec3& tint = glm::vec3(1.0f)) {
  Material m;
  m.name = name;
  m.base_color = glm::vec4(tint, 1.0f);
  m.base_color_texture = {.texture = maps.base_color, .scale = maps.scale};
  m.normal_texture = {.texture = maps.normal, .scale = maps.scale};
  m.metallic_roughness_texture = {.texture = maps.metallic_roughness, .scale = maps.scale};
  return m;
}

// Dyed linen so thin that a share of what is behind it shows.
Material awning(const char* name, const Maps& maps, const glm::vec3& dye) {
  Material m = painted(name, maps, dye);
  m.base_color.a = 0.92f;
  m.alpha_mode = AlphaMode::blend;
  m.double_sided = true;
  m.normal_texture = {};
  return m;
}

Material water(const Maps& ripples) {
  Material m = plain("water", {0.010f, 0.045f, 0.045f}, 0.03f);
  m.base_color.a = 0.6f;
  m.ior = 1.33f;
  m.alpha_mode = AlphaMode::blend;
  m.normal_texture = {.texture = ripples.normal, .scale = ripples.scale};
  return m;
}

Material gilt() {
  Material m = plain("gilt", {1.0f, 0.71f, 0.29f}, 0.32f);
  m.metallic = 1.0f;
  return m;
}

Material leaves() {
  Material m = plain("laurel", {0.10f, 0.19f, 0.05f}, 0.8f);
  m.double_sided = true;
  return m;
}

Material fire() {
  Material m = plain("flame", glm::vec3(0.0f), 1.0f);
  m.emissive = {4.2f, 1.5f, 0.28f};
  return m;
}

}  // namespace

void add_materials(SceneBuilder& builder) {
  const std::vector<Maps> maps = paint_all(builder);
  Sampler exact{.mipmapped = false, .wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge};
  const std::int32_t ramp = builder.add_texture(daylight_ramp(), exact);
  const auto add = [&]([[maybe_unused]] Stuff stuff, Material material) {
    if (material.alpha_mode == AlphaMode::opaque) material.occlusion_texture = {.texture = ramp, .uv_set = 1};
    [[maybe_unused]] const auto number = builder.add_material(std::move(material));
    VEL_ASSERT(number == stuff);
  };
  add(kMarble, painted("marble", maps[kMarbleSet]));
  add(kTravertine, painted("travertine", maps[kTravertineSet]));
  add(kSectile, painted("opus sectile", maps[kSectileSet]));
  add(kMosaic, painted("mosaic", maps[kMosaicSet]));
  add(kPoolMosaic, painted("pool mosaic", maps[kPoolSet]));
  add(kFresco, painted("fresco", maps[kFrescoSet]));
  add(kBrick, painted("brick", maps[kBrickSet]));
  add(kRoofTile, painted("roof tile", maps[kTileSet]));
  add(kTerracotta, painted("terracotta", maps[kClaySet]));
  add(kGlaze, plain("black glaze", {0.012f, 0.010f, 0.011f}, 0.16f));
  add(kBronze, painted("bronze", maps[kBronzeSet]));
  add(kGilt, gilt());
  add(kWood, painted("wood", maps[kWoodSet]));
  add(kAzure, plain("azure paint", {0.035f, 0.085f, 0.22f}, 0.7f));
  add(kSaffron, awning("saffron linen", maps[kLinenSet], {0.80f, 0.34f, 0.04f}));
  add(kCrimson, awning("crimson linen", maps[kLinenSet], {0.50f, 0.035f, 0.03f}));
  add(kWater, water(maps[kRippleSet]));
  add(kFlame, fire());
  add(kLaurel, leaves());
  add(kSoil, plain("soil", {0.030f, 0.028f, 0.018f}, 0.95f));
}

}  // namespace velarium::scene::atrium
