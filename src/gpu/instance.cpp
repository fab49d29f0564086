#include "gpu/instance.hpp"

#include "core/log.hpp"
#include "gpu/check.hpp"
#include "gpu/limits.hpp"

#include <velarium/error.hpp>

#include <array>
#include <cstring>

namespace velarium::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

void load_vulkan() {
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  if (volkGetInstanceVersion() != 0) return;
  if (volkInitialize() != VK_SUCCESS)
    throw Error(ErrorCode::no_device,
                "no Vulkan loader found; install libvulkan1, and mesa-vulkan-drivers for rendering without a GPU");
}

bool layer_installed(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const auto& layer : layers)
    if (std::strcmp(layer.layerName, name) == 0) return true;
  return false;
}

bool extension_installed(const char* name, const char* layer) {
  std::uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data());
  for (const auto& extension : extensions)
    if (std::strcmp(extension.extensionName, name) == 0) return true;
  return false;
}

const char* kind_name(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "cpu";
    default:
      return "other";
  }
}

bool has_graphics_and_compute_queue(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  constexpr VkQueueFlags kBoth = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (const auto& family : families)
    if ((family.queueFlags & kBoth) == kBoth) return true;
  return false;
}

// The reason a device cannot render, or "". Limits are those of the design's table of what people have.
std::string missing_feature(VkPhysicalDevice device, std::uint32_t api_version) {
  if (api_version < VK_API_VERSION_1_3) return "it has no Vulkan 1.3";
  VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &v13};
  vkGetPhysicalDeviceFeatures2(device, &features);
  if (!v13.dynamicRendering) return "it has no dynamic rendering";
  if (!v13.synchronization2) return "it has no synchronization2";
  if (!features.features.imageCubeArray) return "it has no cube arrays";
  if (!features.features.independentBlend) return "it has no independent blending";
  if (!features.features.depthClamp) return "it has no depth clamp";
  if (!has_graphics_and_compute_queue(device)) return "it has no queue for graphics and compute";
  VkFormatProperties depth{};
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT_S8_UINT, &depth);
  constexpr VkFormatFeatureFlags kDepth =
      VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
  if ((depth.optimalTilingFeatures & kDepth) != kDepth) return "it has no sampled D32_SFLOAT_S8_UINT";
  return "";
}

}  // namespace

Instance::Instance(bool validation) {
  load_vulkan();
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
    throw Error(ErrorCode::no_device, "the Vulkan loader is older than 1.3; install a newer libvulkan1");
  if (validation && !layer_installed(kValidationLayer))
    throw Error(ErrorCode::no_device, "validation was asked for, but vulkan-validationlayers is not installed");

  std::vector<const char*> extensions;
  debug_utils_ = extension_installed(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, nullptr) ||
                 (validation && extension_installed(VK_EXT_DEBUG_UTILS_EXTENSION_NAME, kValidationLayer));
  if (debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  if (validation) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

  const VkDebugUtilsMessengerCreateInfoEXT messenger{
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity =
          VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
      .pfnUserCallback = on_message,
      .pUserData = this};
  const std::array enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                         .pNext = &messenger,
                                         .enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size()),
                                         .pEnabledValidationFeatures = enabled.data()};
  const VkApplicationInfo application{
      .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "velarium", .apiVersion = VK_API_VERSION_1_3};
  const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                  .pNext = validation ? &features : nullptr,
                                  .pApplicationInfo = &application,
                                  .enabledLayerCount = validation ? 1u : 0u,
                                  .ppEnabledLayerNames = &kValidationLayer,
                                  .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                  .ppEnabledExtensionNames = extensions.data()};
  const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
    throw Error(ErrorCode::no_device, "no Vulkan driver is installed; mesa-vulkan-drivers renders without a GPU");
  check(result, "vkCreateInstance");
  volkLoadInstance(instance_);
  if (validation && debug_utils_)
    check(vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_),
          "vkCreateDebugUtilsMessengerEXT");
}

Instance::~Instance() {
  if (messenger_ != VK_NULL_HANDLE) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physical_devices() const {
  std::uint32_t count = 0;
  if (vkEnumeratePhysicalDevices(instance_, &count, nullptr) != VK_SUCCESS) return {};
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
  return devices;
}

std::vector<std::string> Instance::take_messages() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(messages_, {});
}

VkBool32 Instance::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  auto& self = *static_cast<Instance*>(user);
  const std::scoped_lock lock(self.mutex_);
  self.messages_.emplace_back(data->pMessage);
  return VK_FALSE;
}

DeviceInfo describe_device(VkPhysicalDevice device, std::uint32_t index) {
  VkPhysicalDeviceProperties basic{};
  vkGetPhysicalDeviceProperties(device, &basic);
  DeviceInfo info{.index = index, .name = basic.deviceName, .kind = kind_name(basic.deviceType)};
  info.api_version = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(basic.apiVersion),
                                 VK_API_VERSION_MINOR(basic.apiVersion), VK_API_VERSION_PATCH(basic.apiVersion));
  if (basic.apiVersion >= VK_API_VERSION_1_2) {
    VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver};
    vkGetPhysicalDeviceProperties2(device, &properties);
    info.driver = driver.driverName;
    if (driver.driverInfo[0] != '\0') info.driver += fmt::format(" {}", driver.driverInfo);
  }
  info.limits = device_limits(basic.limits);
  info.why_not = missing_feature(device, basic.apiVersion);
  if (info.why_not.empty()) info.why_not = missing_limit(info.limits);
  info.usable = info.why_not.empty();
  return info;
}

}  // namespace velarium::gpu
