#pragma once

#include <cstdint>

namespace velarium {

enum class Sync { normal, paranoid };
enum class ShadingModel { gltf, ryse, blinn_phong };
enum class LightingPath { tiled, volumes, all };
enum class MapUpdate { all, staggered };
enum class FarShadow { off, vsm, static_map };
enum class DiffuseEnvironment { map, sh };
enum class ExposureMode { manual, ev100, automatic };
enum class Tonemap { neutral, agx, aces, linear };
enum class ExrType { half, full };
enum class ShadowFaces { both, back };
enum class Transport { direct, direct_env, one_bounce, full };

// Everything that a picture depends on besides the scene, the view and the time: one struct a group,
// one member a row of options.def, which gives units, ranges and meaning. The group `load` is for LoadOptions.
struct Settings {
// clang-format off
#define VEL_GROUP(group, help) struct group##_settings {
#define VEL_BOOL(group, name, value, help) bool name = value;
#define VEL_INT(group, name, value, min, max, unit, help) int name = value;
#define VEL_COUNT(group, name, value, min, max, unit, help) std::uint64_t name = value;
#define VEL_FLOAT(group, name, value, min, max, unit, help) float name = value;
#define VEL_ENUM(group, name, Type, value, help) Type name = Type::value;
#define VEL_END(group) } group;
// clang-format on
#include <velarium/options.def>
#undef VEL_GROUP
#undef VEL_BOOL
#undef VEL_INT
#undef VEL_COUNT
#undef VEL_FLOAT
#undef VEL_ENUM
#undef VEL_END
};

}  // namespace velarium
