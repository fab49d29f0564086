#pragma once

namespace velarium {
// Says what was broken and where on standard error, then aborts: a broken invariant is our own defect.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}  // namespace velarium

// Live in debug and test builds; release builds leave it out.
#if !defined(NDEBUG) || defined(VELARIUM_ASSERTS)
#define VEL_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::velarium::assertion_failed(#condition, __FILE__, __LINE__))
#else
#define VEL_ASSERT(condition) static_cast<void>(0)
#endif
