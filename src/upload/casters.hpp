#pragma once

// What throws shadows, and how it is drawn into maps of depth.

#include "gpu/gpu_context.hpp"
#include "upload/draws.hpp"

#include <array>
#include <span>

namespace velarium::upload {

struct Tables;

enum class CasterKind : std::uint8_t { opaque, cutout, translucent };  // by AlphaMode: OPAQUE, MASK, BLEND

struct Caster {
  scene::WorldAabb bounds;
  Draw draw;  // of this instance alone
  CasterKind kind = CasterKind::opaque;
  bool dynamic = false;                    // may it stand or look otherwise at another time?
  std::span<const std::uint32_t> indices;  // of its triangles, and
  std::span<const glm::vec3> positions;    // object space; owned by the scene or the snapshot
};

enum class CasterChoice : std::uint8_t { all, static_only };  // static: that never move

// All triangles of a snapshot, wherever the camera looks. Instances of one state stand beside each other, so that those
// that a map sees are few draws.
struct CasterTable {
  std::vector<Caster> casters;      // by gl_InstanceIndex: opaque ones, then cutouts, then translucent ones
  std::vector<ObjectData> objects;  // the same order; relative to the origin
};

// The scene and the snapshot must outlive the table.
[[nodiscard]] CasterTable make_casters(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                       const glm::dvec3& origin);

// World space; empty where there are none.
[[nodiscard]] scene::WorldAabb bounds_of(const CasterTable& table, CasterChoice choice = CasterChoice::all);

// Those of one kind whose bounds overlap a convex volume. planes: world space, as those of a Frustum.
[[nodiscard]] std::vector<Draw> visible_casters(const CasterTable& table, CasterKind kind,
                                                std::span<const glm::dvec4> planes,
                                                CasterChoice choice = CasterChoice::all);

[[nodiscard]] bool has_translucent(const CasterTable& table);
[[nodiscard]] bool has_static(const CasterTable& table);

// How casters are drawn.
struct CasterView {
  glm::mat4 clip_from_world{1.0f};  // from world space; reversed-Z
  // Of single-sided surfaces; double-sided ones are never culled. Light stops at both sides of a surface, as it does
  // for the path tracer: walls of one sheet that look into a room keep the sun out of it.
  VkCullModeFlags cull = VK_CULL_MODE_NONE;
  gpu::RasterState state;  // formats, bias, blending: all but topology, vertices and constants
};

// Of translucency maps, shading/translucency.glsl, and a texel where no BLEND surface stands.
inline constexpr VkFormat kTranslucencyFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
inline constexpr std::array<float, 4> kNoTranslucency{1.0f, 1.0f, 1.0f, 0.0f};

// Of CasterView, for translucent casters: they test depth without writing or biasing it, so that what opaque casters
// hide dyes nothing.
[[nodiscard]] gpu::RasterState translucency_state(VkFormat depth, bool depth_clamp);

// Draws casters of one kind, between begin_rendering() and end_rendering(): opaque ones and cutouts into depth alone,
// translucent ones into a colour target by translucency_state(), cleared to kNoTranslucency: rgb becomes what passes
// them all, a the depth of the one nearest to the light.
void draw_casters(gpu::GpuContext& tools, VkCommandBuffer commands, const Tables& tables, std::span<const Draw> draws,
                  CasterKind kind, const CasterView& view);

}  // namespace velarium::upload
