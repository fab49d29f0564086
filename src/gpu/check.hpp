#pragma once

#include "gpu/vulkan.hpp"

namespace velarium::gpu {

// Throws for a failed call: Error(temporary) where the device was lost or memory ran out, else Error(internal).
// `what` is the call or the deed, for the message.
void check(VkResult result, const char* what);

}  // namespace velarium::gpu
