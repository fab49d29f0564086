#pragma once

// The one way into Vulkan: volk, so that a program starts, and says what is missing, where no loader is installed.
#include <volk.h>
