#include "passes/local_shadows/local_shadows.hpp"

#include "graph/context.hpp"
#include "upload/transfer.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace velarium::local_shadows {
namespace {

using graph::Access;
using upload::CasterKind;

constexpr VkFormat kFormat = VK_FORMAT_D32_SFLOAT;

// A texel stores the depth at its middle, and bilinear comparisons reach a texel away on both axes: there the plane of
// the surface itself is nearer by up to both slopes, at most twice the steeper one. Reversed depth: away is less.
constexpr float kSlopeBias = -2.0f;

VkCullModeFlags culled(ShadowFaces faces) {
  return faces == ShadowFaces::back ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_NONE;
}

graph::Area area_of(const Tile& tile) {
  return {tile.x, tile.y, tile.size, tile.size};
}

void draw_map(const graph::Context& c, const upload::SceneTables& scene, const MapDraw& map, VkCullModeFlags cull) {
  c.set_area(area_of(map.tile));
  const upload::CasterView view{
      .clip_from_world = map.clip_from_world, .cull = cull, .state = {.depth_format = kFormat, .depth_bias = true}};
  for (const CasterKind kind : {CasterKind::opaque, CasterKind::cutout})
    upload::draw_casters(c.tools(), c.commands(), scene, upload::visible_casters(scene.casters, kind, map.planes), kind,
                         view);
}

void draw_veils(const graph::Context& c, const upload::SceneTables& scene, const MapDraw& map) {
  c.set_area(area_of(map.tile));
  const upload::CasterView view{.clip_from_world = map.clip_from_world, .state = upload::veil_state(kFormat, false)};
  const auto draws = upload::visible_casters(scene.casters, CasterKind::translucent, map.planes);
  upload::draw_casters(c.tools(), c.commands(), scene, draws, CasterKind::translucent, view);
}

// Beside maps whose depths are drawn.
void add_veils(graph::Graph& graph, const Inputs& in, Outputs& out) {
  auto& pass = graph.pass("local_veils");
  pass.read(out.atlas, Access::depth_test);
  out.veils = pass.write(out.veils, Access::color_attachment);
  pass.run([in, out](graph::Context& c) {
    c.begin_rendering({.colors = {{out.veils}}, .depth = out.atlas, .depth_writable = false});
    for (const MapDraw& map : in.maps.draws)
      if (map.veiled) c.clear_color(area_of(map.tile), upload::kNoVeil);
    for (const MapDraw& map : in.maps.draws)
      if (map.veiled) draw_veils(c, in.scene, map);
    c.end_rendering();
  });
}

// Allocated once, for the largest picture and the smallest; veils only while a map has any.
void allocate(Maps& maps, gpu::Device& device, std::uint32_t side, bool veiled) {
  const std::uint32_t most = device.caps().max_image_size;
  if (side > most)
    throw Error(ErrorCode::usage,
                fmt::format("local_shadows.atlas is {} texels, more than this device's images have, {}", side, most));
  constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const gpu::ImageDesc depth{.format = kFormat, .width = side, .height = side};
  // The old ones and the new ones need not fit beside each other.
  if (maps.atlas.desc() != depth) {
    maps.atlas = {};
    maps.veils = {};
  }
  if (!maps.atlas) maps.atlas = gpu::Image(device, depth, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | kRead);
  const gpu::ImageDesc veils{.format = upload::kVeilFormat, .width = side, .height = side, .array = true};
  if (!veiled)
    maps.veils = {};
  else if (!maps.veils)
    maps.veils = gpu::Image(device, veils, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | kRead);
}

bool is_veiled(const shading::ShadowView& view) {
  return view.tile.w != 0.0f;
}

std::vector<PlacedView> place(Maps& maps, const upload::SceneTables& tables, const Viewer& viewer,
                              const Settings& settings) {
  const auto views = wanted_views(tables.host_lights, viewer, tables.casters, settings.translucent);
  if (settings.updates == 0 || !maps.atlas || maps.scene_id != tables.gpu->id()) maps.keeper.forget();
  maps.scene_id = tables.gpu->id();
  if (settings.updates == 0) return place_views(views, settings);
  std::vector<std::uint64_t> fingerprints;
  for (const View& view : views)
    fingerprints.push_back(fingerprint(view, viewer.view.eye, tables.casters, settings.translucent));
  return maps.keeper.place(views, fingerprints, viewer.view.eye, settings,
                           static_cast<std::uint32_t>(settings.updates));
}

std::uint32_t lights_without_map(const std::vector<PlacedView>& placed) {
  std::set<std::uint32_t> without;
  for (const auto& at : placed)
    if (!at.tile) without.insert(at.view.light);
  return static_cast<std::uint32_t>(without.size());
}

}  // namespace

std::uint32_t prepare(Maps& maps, gpu::Device& device, upload::SceneTables& tables, const Viewer& viewer,
                      const Settings& settings) {
  maps.draws.clear();
  if (!settings.enabled) {
    maps = Maps();
    return 0;
  }
  const auto placed = place(maps, tables, viewer, settings);
  Plan plan = make_plan(placed, tables.host_lights, viewer.view.eye, atlas_side(settings));
  const auto without = lights_without_map(placed);
  if (plan.views.empty()) {
    maps = Maps();
    return without;
  }
  maps.draws = std::move(plan.draws);
  allocate(maps, device, atlas_side(settings), std::any_of(plan.views.begin(), plan.views.end(), is_veiled));
  for (std::size_t i = 0; i < plan.shadow_view.size(); ++i) tables.host_lights[i].shadow_view = plan.shadow_view[i];
  tables.lights = upload::make_buffer(device, tables.host_lights, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  tables.shadow_views = upload::make_buffer(device, plan.views, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  return without;
}

Outputs add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  if (!in.scene.shadow_views) return {};
  const bool draws = in.first && !in.maps.draws.empty();
  // What lies between the tiles is never read, so that a new image counts as initialised where nothing is drawn.
  Outputs out{.atlas = graph.import("local_shadows.atlas", in.maps.atlas, true)};
  if (in.maps.veils) out.veils = graph.import("local_veils.atlas", in.maps.veils, true);
  if (!draws) return out;
  auto& pass = graph.pass("local_shadows");
  out.atlas = pass.write(out.atlas, Access::depth_attachment);
  pass.run([in, drawn = out.atlas, cull = culled(settings.faces)](graph::Context& c) {
    c.begin_rendering({.depth = drawn});
    // All before the first draw: a software driver finishes what it has at each clear.
    for (const MapDraw& map : in.maps.draws) c.clear_depth(area_of(map.tile));
    vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, kSlopeBias);
    for (const MapDraw& map : in.maps.draws) draw_map(c, in.scene, map, cull);
    c.end_rendering();
  });
  const bool veils =
      std::any_of(in.maps.draws.begin(), in.maps.draws.end(), [](const auto& map) { return map.veiled; });
  if (veils) add_veils(graph, in, out);
  return out;
}

}  // namespace velarium::local_shadows
