#include "gpu/device.hpp"

#include "core/assert.hpp"
#include "core/files.hpp"
#include "core/log.hpp"
#include "gpu/check.hpp"

#include <velarium/error.hpp>

#include <algorithm>
#include <charconv>
#include <limits>

namespace velarium::gpu {
namespace {

constexpr std::uint64_t kMaxCacheBytes = 256u << 20;

int preference(const DeviceInfo& info) {
  if (info.kind == "discrete") return 4;
  if (info.kind == "integrated") return 3;
  if (info.kind == "virtual") return 2;
  return info.kind == "cpu" ? 1 : 0;
}

bool matches(const DeviceInfo& info, const std::string& choice) {
  if (choice.empty()) return true;
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  if (error == std::errc() && end == choice.data() + choice.size()) return info.index == index;
  if (choice == "cpu") return info.kind == "cpu";
  return info.name.find(choice) != std::string::npos;
}

std::string pipeline_cache_name(const Device& device) {
  return fmt::format("pipelines-{:016x}.bin", device.driver_hash());
}

// The best usable device that `choice` names.
DeviceInfo choose(const std::vector<VkPhysicalDevice>& devices, const std::string& choice) {
  DeviceInfo best;
  std::string refused;
  for (std::uint32_t i = 0; i < devices.size(); ++i) {
    DeviceInfo info = describe_device(devices[i], i);
    const bool named = matches(info, choice);
    if (named && info.usable && (!best.usable || preference(info) > preference(best)))
      best = info;
    else if (!info.usable || !named)
      refused += fmt::format("; {} ({}): {}", i, info.name, info.usable ? "not what was asked for" : info.why_not);
  }
  if (best.usable) return best;
  if (devices.empty())
    throw Error(ErrorCode::no_device, "no Vulkan device found; mesa-vulkan-drivers renders without a GPU");
  throw Error(ErrorCode::no_device,
              fmt::format("no usable device{}{}", choice.empty() ? "" : " matches '" + choice + "'", refused));
}

std::uint32_t find_queue_family(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  const auto found = std::find_if(families.begin(), families.end(), [](const auto& family) {
    constexpr VkQueueFlags kBoth = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    return (family.queueFlags & kBoth) == kBoth;
  });
  return static_cast<std::uint32_t>(found - families.begin());
}

}  // namespace

Device::Device(const std::string& choice, bool validation) : instance_(std::make_unique<Instance>(validation)) {
  const auto devices = instance_->physical_devices();
  info_ = choose(devices, choice);
  physical_ = devices[info_.index];
  queue_family_ = find_queue_family(physical_);
  create_device();
  read_capabilities();
  memory_ = std::make_unique<MemoryAllocator>(physical_, device_);
  load_pipeline_cache();
}

Device::~Device() {
  vkDeviceWaitIdle(device_);
  save_pipeline_cache();
  vkDestroyPipelineCache(device_, pipeline_cache_, nullptr);
  for (const auto& recorder : recorders_) {
    vkDestroyFence(device_, recorder.fence, nullptr);
    vkDestroyCommandPool(device_, recorder.pool, nullptr);
  }
  memory_.reset();
  vkDestroyDevice(device_, nullptr);
}

void Device::create_device() {
  VkPhysicalDeviceFeatures has{};
  vkGetPhysicalDeviceFeatures(physical_, &has);
  const float priority = 1.0f;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = queue_family_,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
                                       .synchronization2 = VK_TRUE,
                                       .dynamicRendering = VK_TRUE,
                                       .maintenance4 = VK_TRUE};  // SPIR-V 1.6 says group sizes by LocalSizeId
  const VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                           .pNext = &v13,
                                           .features = {.robustBufferAccess = has.robustBufferAccess,
                                                        .imageCubeArray = VK_TRUE,
                                                        .independentBlend = VK_TRUE,
                                                        .depthClamp = VK_TRUE,
                                                        .samplerAnisotropy = has.samplerAnisotropy}};
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &features,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue};
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
}

void Device::read_capabilities() {
  VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 all{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver};
  vkGetPhysicalDeviceProperties2(physical_, &all);
  const VkPhysicalDeviceProperties& properties = all.properties;
  VkPhysicalDeviceFeatures features{};
  vkGetPhysicalDeviceFeatures(physical_, &features);
  const auto& limits = properties.limits;
  caps_.sub_pixel_bits = limits.subPixelPrecisionBits;
  caps_.max_anisotropy = features.samplerAnisotropy ? limits.maxSamplerAnisotropy : 1.0f;
  caps_.max_image_size =
      std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight});
  caps_.timestamp_ns = limits.timestampComputeAndGraphics ? static_cast<double>(limits.timestampPeriod) : 0.0;
  caps_.host_is_device = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  caps_.cube_edges_need_blit = driver.driverID == VK_DRIVER_ID_GOOGLE_SWIFTSHADER;
  VkFormatProperties float32{};
  vkGetPhysicalDeviceFormatProperties(physical_, VK_FORMAT_R32G32B32A32_SFLOAT, &float32);
  caps_.blends_float32 = (float32.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) != 0;
}

Device::Recorder& Device::free_recorder() {
  const auto found = std::find_if(recorders_.begin(), recorders_.end(), [](const Recorder& recorder) {
    return recorder.fence != VK_NULL_HANDLE && recorder.running == Submission{};
  });
  if (found != recorders_.end()) return *found;
  auto& recorder = recorders_.emplace_back();  // first: should a step fail, the destructor frees those before it
  const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                     .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                     .queueFamilyIndex = queue_family_};
  check(vkCreateCommandPool(device_, &pool, nullptr, &recorder.pool), "vkCreateCommandPool");
  const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                         .commandPool = recorder.pool,
                                         .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                         .commandBufferCount = 1};
  check(vkAllocateCommandBuffers(device_, &info, &recorder.commands), "vkAllocateCommandBuffers");
  const VkFenceCreateInfo fence{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  check(vkCreateFence(device_, &fence, nullptr, &recorder.fence), "vkCreateFence");
  return recorder;
}

VkCommandBuffer Device::begin() {
  const auto& recorder = free_recorder();
  check(vkResetCommandPool(device_, recorder.pool, 0), "vkResetCommandPool");
  const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                       .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  check(vkBeginCommandBuffer(recorder.commands, &begin), "vkBeginCommandBuffer");
  return recorder.commands;
}

Submission Device::submit(VkCommandBuffer commands) {
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  const auto recorder = std::find_if(recorders_.begin(), recorders_.end(),
                                     [&](const Recorder& candidate) { return candidate.commands == commands; });
  VEL_ASSERT(recorder != recorders_.end());
  const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                         .commandBuffer = commands};
  const VkSubmitInfo2 submit{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2, .commandBufferInfoCount = 1, .pCommandBufferInfos = &buffer};
  check(vkQueueSubmit2(queue_, 1, &submit, recorder->fence), "submitting work to the device");
  last_ = Submission{static_cast<std::uint64_t>(last_) + 1};
  return recorder->running = last_;
}

void Device::wait(Submission submission) {
  for (auto& recorder : recorders_) {
    if (recorder.running == Submission{} || recorder.running > submission) continue;
    check(vkWaitForFences(device_, 1, &recorder.fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
          "waiting for the device");
    check(vkResetFences(device_, 1, &recorder.fence), "vkResetFences");
    recorder.running = {};
  }
  refuse_validation_messages();
}

void Device::wait_idle() noexcept {
  vkDeviceWaitIdle(device_);
}

void Device::submit_and_wait(VkCommandBuffer commands) {
  wait(submit(commands));
}

void Device::refuse_validation_messages() {
  const auto messages = instance_->take_messages();
  if (messages.empty()) return;
  throw Error(ErrorCode::internal, fmt::format("validation: {} (and {} more)", messages.front(), messages.size() - 1));
}

std::uint64_t Device::driver_hash() const {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_, &properties);
  const std::uint64_t hash = content_hash(std::as_bytes(std::span(properties.pipelineCacheUUID)));
  return content_hash(std::as_bytes(std::span(&properties.driverVersion, 1)), hash);
}

void Device::load_pipeline_cache() {
  std::vector<std::byte> data;
  try {
    if (const auto folder = cache_directory(); !folder.empty())
      data = read_file(folder / pipeline_cache_name(*this), kMaxCacheBytes);
  } catch (const Error&) {
    data.clear();  // a cache that cannot be read is a cache miss
  }
  loaded_cache_bytes_ = data.size();
  const VkPipelineCacheCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                                       .initialDataSize = data.size(),
                                       .pInitialData = data.data()};
  check(vkCreatePipelineCache(device_, &info, nullptr, &pipeline_cache_), "vkCreatePipelineCache");
}

void Device::save_pipeline_cache() noexcept {
  try {
    const auto folder = cache_directory();
    std::size_t size = 0;
    if (folder.empty() || vkGetPipelineCacheData(device_, pipeline_cache_, &size, nullptr) != VK_SUCCESS) return;
    if (size <= loaded_cache_bytes_) return;
    std::vector<std::byte> data(size);
    if (vkGetPipelineCacheData(device_, pipeline_cache_, &size, data.data()) != VK_SUCCESS) return;
    std::filesystem::create_directories(folder);
    write_file(folder / pipeline_cache_name(*this), data);
  } catch (const std::exception& e) { log_debug("pipeline cache not written: {}", e.what()); }
}

}  // namespace velarium::gpu
