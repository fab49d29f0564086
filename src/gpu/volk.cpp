#define VOLK_IMPLEMENTATION
#include "gpu/vulkan.hpp"
