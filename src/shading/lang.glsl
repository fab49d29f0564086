// The only file that knows which language is reading: GLSL 4.60 (Vulkan) or C++20 through shading/host.hpp.
//
//   FN                   before each function
//   IN(T) OUT(T) INOUT(T)  parameters of structure type; scalars and vectors are passed plain
//   IN_ARRAY(T, name, n), OUT_ARRAY(T, name, n)  parameters of array type
//   require(condition)   a precondition: checked in C++ where assertions are live, free in GLSL
//   CHECK_LAYOUT(Struct, member, offset)  byte offset under std430, which C++ must share
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
#define require(condition)

#endif

#endif
