#include "core/huge_pages.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace velarium {
namespace {

// x86-64's second page size, and that of arm64 with small pages of 4 KiB. A range below two of these may hold none.
constexpr std::size_t kHugePage = std::size_t{2} << 20;

}  // namespace

void prefer_huge_pages(std::span<const std::byte> range) noexcept {
  if (range.size() < 2 * kHugePage) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(range.data());
  const std::uintptr_t first = (begin + page - 1) / page * page, last = (begin + range.size()) / page * page;
  // The answer does not matter: without the pages, the program is only slower.
  static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
}

}  // namespace velarium
