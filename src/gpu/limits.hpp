#pragma once

// How much of a device the renderer may use in one shader stage: what the poorest driver has (docs/architecture.md),
// less what is kept for techniques to come. tests/shaders holds every shader to it.

#include "gpu/vulkan.hpp"

#include <velarium/engine.hpp>

#include <string>

namespace velarium::gpu {

inline constexpr DeviceLimits kUsedLimits{.samplers = 30,
                                          .sampled_images = 96,
                                          .storage_images = 8,
                                          .storage_buffers = 24,
                                          .bound_sets = 4,
                                          .push_constant_bytes = 128};

[[nodiscard]] DeviceLimits device_limits(const VkPhysicalDeviceLimits& limits);

// What a device has too little of, as a sentence goes on after its name; empty where it has enough.
[[nodiscard]] std::string missing_limit(const DeviceLimits& limits);

}  // namespace velarium::gpu
