#pragma once

#include "gpu/vulkan.hpp"

#include <velarium/engine.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace velarium::gpu {

// A Vulkan instance and what the validation layers say to it.
// Every instance enables VK_EXT_debug_utils where there is any, because volk's function pointers are shared.
class Instance {
 public:
  // Throws Error(no_device) where there is no loader, or no Vulkan 1.3 loader, or where validation is asked for
  // and the layer is not installed.
  explicit Instance(bool validation);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance vk() const { return instance_; }
  [[nodiscard]] bool has_debug_utils() const { return debug_utils_; }
  [[nodiscard]] std::vector<VkPhysicalDevice> physical_devices() const;

  // Messages of the validation layers since the last call.
  [[nodiscard]] std::vector<std::string> take_messages();

 private:
  static VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                   VkDebugUtilsMessageTypeFlagsEXT types,
                                                   const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  bool debug_utils_ = false;
  std::mutex mutex_;
  std::vector<std::string> messages_;
};

// What the renderer needs and this device has or lacks; `index` is its place in physical_devices().
[[nodiscard]] DeviceInfo describe_device(VkPhysicalDevice device, std::uint32_t index);

}  // namespace velarium::gpu
