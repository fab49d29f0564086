// A material as shaders bind it: descriptor set 2. Its images have samplers of their own, as glTF gives each texture one.
#ifndef VEL_UPLOAD_MATERIAL_IO_GLSL
#define VEL_UPLOAD_MATERIAL_IO_GLSL

#include "shading/lang.glsl"
#include "upload/gpu_structs.glsl"

// In the order of GpuMaterial::slots.
SAMPLED(2, 0, sampler2D, base_color_map);
SAMPLED(2, 1, sampler2D, metallic_roughness_map);
SAMPLED(2, 2, sampler2D, normal_map);
SAMPLED(2, 3, sampler2D, occlusion_map);
SAMPLED(2, 4, sampler2D, emissive_map);
SAMPLED(2, 5, sampler2D, specular_map);
SAMPLED(2, 6, sampler2D, specular_color_map);

// A uniform buffer, not a table in a storage buffer: llvmpipe answers a storage read of a helper invocation with 0,
// and texture coordinates made of that have wrong derivatives along every edge.
UNIFORM(2, 7, MaterialBuffer, GpuMaterial material);

// Bit i: slot i has a texture. A constant, not a branch on the material: llvmpipe executes both sides of a branch, and
// seven filtered fetches cost more than the rest of the surface.
CONSTANT(uint, kSlots, 0, 0x7fu);
CONSTANT(bool, kBakedNormalSpread, 24, true);  // specular_aa.baked: mips of normal maps widen lobes

#endif
