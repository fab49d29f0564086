#include "gpu/check.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::gpu {

void check(VkResult result, const char* what) {
  switch (result) {
    case VK_SUCCESS:
      return;
    case VK_ERROR_DEVICE_LOST:
      throw Error(ErrorCode::temporary, fmt::format("{}: the device was lost; trying again may help", what));
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
      throw Error(ErrorCode::temporary, fmt::format("{}: out of memory; a smaller picture or scene needs less", what));
    default:
      throw Error(ErrorCode::internal, fmt::format("{}: VkResult {}", what, static_cast<int>(result)));
  }
}

}  // namespace velarium::gpu
