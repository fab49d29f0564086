// Tables that cross from the host to the shaders, declared once for both: C++ reads this file through gpu_structs.hpp.
// std430 layout throughout (GpuMaterial fits std140 as well). World space on the device has
// the scene's axes and its origin at the main eye of the picture.
#ifndef VEL_UPLOAD_GPU_STRUCTS_GLSL
#define VEL_UPLOAD_GPU_STRUCTS_GLSL

#include "shading/lang.glsl"
#include "shading/lights.glsl"

const uint kNoSun = 0xffffffffu;

// One frame of one view: the camera, and what differs from frame to frame.
struct FrameUniforms {
  mat4 clip_from_world;   // with this frame's sub-pixel jitter
  mat4 view_from_world;   // a rotation, and where the eye stands
  vec4 eye;               // xyz: world space
  vec4 ndc_to_view;       // shading/depth.glsl, with the jitter
  vec4 depth_params;      // shading/depth.glsl
  vec4 size;              // width, height in pixels, and their inverses
  float perspective;      // 1: perspective, 0: orthographic
  uint frame_index;
  uint seed;
  float rounding;         // rounding_shift() of the frame
};
CHECK_LAYOUT(FrameUniforms, eye, 128);
CHECK_LAYOUT(FrameUniforms, perspective, 192);

// Where each kind begins in the table of lights: directional ones, then points from here, then spots from here, to here.
struct LightRanges {
  uint first_point;
  uint first_spot;
  uint count;
  uint sun;  // the brightest directional light that casts shadows; kNoSun where none does
};

// One instance of a primitive. Its index is gl_InstanceIndex.
struct ObjectData {
  vec4 world_from_object[3];  // rows
};

// The textures of a material, in the order of its descriptor set.
const uint kSlotBaseColor = 0u;
const uint kSlotMetallicRoughness = 1u;
const uint kSlotNormal = 2u;
const uint kSlotOcclusion = 3u;
const uint kSlotEmissive = 4u;
const uint kSlotSpecular = 5u;
const uint kSlotSpecularColor = 6u;
const uint kSlotCount = 7u;

// uv' = (dot(rows.xy, uv), dot(rows.zw, uv)) + offset
struct TextureSlot {
  vec4 rows;
  vec2 offset;
  uint uv_set;    // 0 or 1: which of the vertex's two sets
  uint unused;
};

const uint kMaterialUnlit = 1u;        // GpuMaterial::flags
const uint kMaterialDoubleSided = 2u;

struct GpuMaterial {
  vec4 base_color;
  vec4 emissive;              // rgb: nits; w: normal scale
  vec4 metal_rough;           // metallic, perceptual roughness, occlusion strength, alpha cutoff
  vec4 specular;              // rgb: specular colour times specular; w: dielectric f0
  uint flags;
  uint unused0;
  uint unused1;
  uint unused2;
  TextureSlot slots[7];       // kSlotCount; GLSL 4.60 and C++ agree on a literal only
};
CHECK_LAYOUT(GpuMaterial, flags, 64);
CHECK_LAYOUT(GpuMaterial, slots, 80);

// Side of the square tiles that lights are culled for, pixels [Ryse, tiled shading; 16 is the common choice].
const uint kTileSize = 16u;

// A limit of the tile's shared memory: 512 words, 2 KiB of the 16 KiB that every device has.
const uint kMaxLights = 16384u;

#endif
