// The only file that knows which language is reading: GLSL 4.60 (Vulkan) or C++20 through shading/host.hpp.
//
//   FN                   before each function
//   IN(T) OUT(T) INOUT(T)  parameters of structure type; scalars and vectors are passed plain
//   IN_ARRAY(T, name, n), OUT_ARRAY(T, name, n)  parameters of array type
//   require(condition)   a precondition: checked in C++ where assertions are live, free in GLSL
//   CHECK_LAYOUT(Struct, member, offset)  byte offset under std430, which C++ must share
//
// What a shader binds is declared once as well, in NAME_io.glsl. GLSL reads declarations, C++ reads constants of the same
// names, of gpu/slot.hpp, which set writers and specialisations take:
//
//   SAMPLED(set, slot, type, name)        an image without a sampler: texture2D, texture2DArray, textureCube ...
//   SAMPLED_DEPTH(set, slot, type, name)  the same of depth
//   SAMPLER(set, slot, type, name)        a sampler without an image: sampler, samplerShadow
//   STORAGE(set, slot, format, type, name)  an image to load from and store to; type may begin with readonly or writeonly
//   TABLE(set, slot, Block, member)       a storage buffer that is read
//   OUT_TABLE(set, slot, Block, member)   a storage buffer that is written
//   UNIFORM(set, slot, Block, member)     a uniform buffer, std140
//   CONSTANT(type, name, id, value)       a specialisation constant with its default; C++ knows its type and id
//   GROUP_SIZE_X(name, id)                the threads of a group along x, as a specialisation constant
//   PUSH(Struct)                          the push constants, in GLSL as `push`
#ifndef VEL_SHADING_LANG_GLSL
#define VEL_SHADING_LANG_GLSL

#ifdef __cplusplus

#define FN inline
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&
#define IN_ARRAY(T, name, n) const T(&name)[n]
#define OUT_ARRAY(T, name, n) T(&name)[n]
#define CHECK_LAYOUT(Struct, member, offset) static_assert(offsetof(Struct, member) == offset)

#define SAMPLED(set, slot, type, name) inline constexpr ::velarium::gpu::Slot name{set, slot, ::velarium::gpu::SlotType::type}
#define SAMPLED_DEPTH(set, slot, type, name) \
  inline constexpr ::velarium::gpu::Slot name{set, slot, ::velarium::gpu::SlotType::depth_##type}
#define SAMPLER(set, slot, type, name) inline constexpr ::velarium::gpu::Slot name{set, slot, ::velarium::gpu::SlotType::type}
#define STORAGE(set, slot, format, type, name) \
  inline constexpr ::velarium::gpu::Slot name{set, slot, ::velarium::gpu::SlotType::storage_image}
#define TABLE(set, slot, Block, member) inline constexpr ::velarium::gpu::Slot Block{set, slot, ::velarium::gpu::SlotType::buffer}
#define OUT_TABLE(set, slot, Block, member) TABLE(set, slot, Block, member)
#define UNIFORM(set, slot, Block, member) TABLE(set, slot, Block, member)
#define CONSTANT(type, name, id, value) inline constexpr ::velarium::gpu::Constant<type> name{id}
#define GROUP_SIZE_X(name, id) CONSTANT(uint, name, id, 0)
#define PUSH(Struct) static_assert(sizeof(Struct) <= ::velarium::gpu::kPushConstantBytes)

#if !defined(NDEBUG) || defined(VELARIUM_ASSERTS)
#define require(condition) \
  ((condition) ? static_cast<void>(0) : ::velarium::shading::precondition_failed(#condition, __FILE__, __LINE__))
#else
#define require(condition) static_cast<void>(0)
#endif

#else

#define FN
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#define IN_ARRAY(T, name, n) in T name[n]
#define OUT_ARRAY(T, name, n) out T name[n]
#define CHECK_LAYOUT(Struct, member, offset)
#define SAMPLED(set_number, slot, type, name) layout(set = set_number, binding = slot) uniform type name
#define SAMPLED_DEPTH(set_number, slot, type, name) layout(set = set_number, binding = slot) uniform type name
#define SAMPLER(set_number, slot, type, name) layout(set = set_number, binding = slot) uniform type name
#define STORAGE(set_number, slot, format, type, name) layout(set = set_number, binding = slot, format) uniform type name
#define TABLE(set_number, slot, Block, member) layout(set = set_number, binding = slot, std430) readonly buffer Block { member; }
#define OUT_TABLE(set_number, slot, Block, member) layout(set = set_number, binding = slot, std430) buffer Block { member; }
#define UNIFORM(set_number, slot, Block, member) layout(set = set_number, binding = slot, std140) uniform Block { member; }
#define CONSTANT(type, name, id, value) layout(constant_id = id) const type name = value
#define GROUP_SIZE_X(name, id) layout(local_size_x_id = id) in
#define PUSH(Struct) layout(push_constant, std430) uniform PushBlock { Struct push; }
#define require(condition)

#endif

#endif
