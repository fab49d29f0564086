#include "host_structs.hpp"

#include "passes/ambient_lights/read.hpp"
#include "passes/area_lights/read.hpp"
#include "passes/contact_shadows/read.hpp"
#include "passes/environment/read.hpp"
#include "passes/far_shadows/read.hpp"
#include "upload/gpu_structs.hpp"

namespace velarium::test {
namespace {

// Structures that one file of C++ alone reads.
namespace environment_prefilter {
using namespace shading;
#include "bake/environment_prefilter_io.glsl"
}  // namespace environment_prefilter
namespace environment_project {
using namespace shading;
#include "bake/environment_project_io.glsl"
}  // namespace environment_project
namespace average {
using namespace shading;
#include "passes/display/average_io.glsl"
}  // namespace average
namespace display_own {
using namespace shading;
#include "passes/display/display_io.glsl"
}  // namespace display_own
namespace exposure_own {
using namespace shading;
#include "passes/exposure/exposure_io.glsl"
}  // namespace exposure_own
namespace far_blur {
using namespace shading;
#include "passes/far_shadows/far_blur_io.glsl"
}  // namespace far_blur
namespace light_volumes_own {
using namespace shading;
#include "passes/light_volumes/light_volumes_io.glsl"
}  // namespace light_volumes_own
namespace normal_variance_own {
using namespace shading;
#include "passes/specular_aa/specular_aa_io.glsl"
}  // namespace normal_variance_own
namespace caster {
using namespace shading;
#include "upload/caster_io.glsl"
}  // namespace caster
namespace normal_mips {
using namespace shading;
#include "upload/normal_mips_io.glsl"
}  // namespace normal_mips

}  // namespace

#define MEMBER(name) \
  { #name, offsetof(S, name) }
#define STRUCT(type, name, ...)                         \
  [] {                                                  \
    using S = type;                                     \
    return HostStruct{#name, sizeof(S), {__VA_ARGS__}}; \
  }()

std::vector<HostStruct> host_structs() {
  return {
      STRUCT(upload::FrameUniforms, FrameUniforms, MEMBER(clip_from_world), MEMBER(view_from_world), MEMBER(eye),
             MEMBER(ndc_to_view), MEMBER(depth_params), MEMBER(size), MEMBER(perspective), MEMBER(frame_index),
             MEMBER(seed), MEMBER(rounding)),
      STRUCT(upload::LightRanges, LightRanges, MEMBER(first_point), MEMBER(first_spot), MEMBER(count), MEMBER(sun)),
      STRUCT(upload::ObjectData, ObjectData, MEMBER(world_from_object)),
      STRUCT(upload::TextureSlot, TextureSlot, MEMBER(rows), MEMBER(offset), MEMBER(uv_set), MEMBER(unused)),
      STRUCT(upload::GpuMaterial, GpuMaterial, MEMBER(base_color), MEMBER(emissive), MEMBER(metal_rough),
             MEMBER(specular), MEMBER(flags), MEMBER(unused0), MEMBER(unused1), MEMBER(unused2), MEMBER(slots)),
      STRUCT(shading::GpuLight, GpuLight, MEMBER(position_range), MEMBER(direction), MEMBER(color), MEMBER(cone),
             MEMBER(projector), MEMBER(projector_layer), MEMBER(clip_volume), MEMBER(flags), MEMBER(unused)),
      STRUCT(shading::ShadowView, ShadowView, MEMBER(right), MEMBER(down), MEMBER(forward), MEMBER(tile),
             MEMBER(translucent)),
      STRUCT(shading::Cascade, Cascade, MEMBER(place), MEMBER(depth), MEMBER(soft)),
      STRUCT(shading::SunShadows, SunShadows, MEMBER(axis_x), MEMBER(axis_y), MEMBER(axis_z), MEMBER(cascades),
             MEMBER(cascade_count), MEMBER(translucent)),
      STRUCT(far_shadows::io::FarCascade, FarCascade, MEMBER(cascade), MEMBER(normal_offset), MEMBER(snap)),
      STRUCT(environment::io::Environment, Environment, MEMBER(background), MEMBER(turn), MEMBER(sh)),
      STRUCT(shading::GpuAmbientLight, GpuAmbientLight, MEMBER(x), MEMBER(y), MEMBER(z), MEMBER(color)),
      STRUCT(ambient_lights::io::AmbientLights, AmbientLights, MEMBER(count)),
      STRUCT(area_lights::io::AreaLights, AreaLights, MEMBER(min_highlight_alpha)),
      STRUCT(contact_shadows::io::ContactShadows, ContactShadows, MEMBER(longest), MEMBER(thickness)),
      STRUCT(caster::CasterPush, CasterPush, MEMBER(clip_from_world)),
      STRUCT(light_volumes_own::VolumePush, VolumePush, MEMBER(shape)),
      STRUCT(normal_variance_own::SpecularAaPush, SpecularAaPush, MEMBER(share), MEMBER(dim_dielectrics)),
      STRUCT(far_blur::BlurPush, BlurPush, MEMBER(radius), MEMBER(weights)),
      STRUCT(average::AveragePush, AveragePush, MEMBER(frame_weight)),
      STRUCT(display_own::DisplayPush, DisplayPush, MEMBER(background), MEMBER(frame_weight), MEMBER(seed)),
      STRUCT(exposure_own::PartialPush, PartialPush, MEMBER(frame_weight)),
      STRUCT(exposure_own::ResolvePush, ResolvePush, MEMBER(scale)),
      STRUCT(environment_prefilter::PrefilterPush, PrefilterPush, MEMBER(begin), MEMBER(end)),
      STRUCT(environment_project::ProjectPush, ProjectPush, MEMBER(taps), MEMBER(mip)),
      STRUCT(normal_mips::NormalMipPush, NormalMipPush, MEMBER(from_size), MEMBER(to_size), MEMBER(from_first),
             MEMBER(to_first), MEMBER(from_base)),
  };
}

}  // namespace velarium::test
