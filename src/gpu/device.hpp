#pragma once

#include "gpu/instance.hpp"
#include "gpu/memory.hpp"
#include "gpu/vulkan.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace velarium::gpu {

// What this device can do beyond what is required. The one place that optional features are asked at.
struct Capabilities {
  float max_anisotropy = 1.0f;        // 1: none
  std::uint32_t sub_pixel_bits = 4;   // vertices snap to so many binary digits of a pixel
  std::uint32_t max_image_size = 0;   // width and height of 2-D images and of what is drawn to, pixels
  double timestamp_ns = 0.0;          // nanoseconds a tick; 0: no timestamps
  bool host_is_device = false;        // a CPU driver: all memory is the host's
  bool cube_edges_need_blit = false;  // see fill_cube_edges()
  bool blends_float32 = false;        // may targets of four 32-bit floats be blended?
};

// Names work that was handed to the device. Later work has larger numbers; 0 is none.
enum class Submission : std::uint64_t {};

// A logical device with its one queue. Not thread-safe.
class Device {
 public:
  // `choice`: see EngineOptions::device. Throws Error(no_device) that says for each device why it was refused.
  Device(const std::string& choice, bool validation);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] VkDevice vk() const { return device_; }
  [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
  [[nodiscard]] const DeviceInfo& info() const { return info_; }
  [[nodiscard]] const Capabilities& caps() const { return caps_; }
  [[nodiscard]] MemoryAllocator& memory() { return *memory_; }
  [[nodiscard]] VkPipelineCache pipeline_cache() const { return pipeline_cache_; }
  // Names this driver on this device, and its version: bits that one computes need not be another's.
  [[nodiscard]] std::uint64_t driver_hash() const;
  [[nodiscard]] bool has_labels() const { return instance_->has_debug_utils(); }

  // A command buffer that is recording, for one submission. Only one records at a time: to begin again gives up what
  // was recorded and not submitted.
  [[nodiscard]] VkCommandBuffer begin();
  // Ends and submits what begin() gave, and returns while the device may still work on it. Until wait(), nothing that
  // it uses may be changed or destroyed. Throws Error(temporary).
  [[nodiscard]] Submission submit(VkCommandBuffer commands);
  // Waits until the device has finished this submission and all before it. Throws Error(temporary), and Error(internal)
  // with the text of what the validation layers said.
  void wait(Submission submission);
  // The same for all that was submitted: before something is changed or freed that running work may use.
  void wait() { wait(last_); }
  // Waits for all work. For destructors: what went wrong is not said.
  void wait_idle() noexcept;
  // Both. Throws as they do.
  void submit_and_wait(VkCommandBuffer commands);
  void refuse_validation_messages();

 private:
  // What one submission needs until it has finished.
  struct Recorder {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    Submission running{};  // 0: free
  };
  void create_device();
  [[nodiscard]] Recorder& free_recorder();
  void read_capabilities();
  void load_pipeline_cache();
  void save_pipeline_cache() noexcept;

  std::unique_ptr<Instance> instance_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  DeviceInfo info_;
  Capabilities caps_;
  std::uint32_t queue_family_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::vector<Recorder> recorders_;  // as many as ever ran at once
  Submission last_{};
  VkPipelineCache pipeline_cache_ = VK_NULL_HANDLE;
  std::size_t loaded_cache_bytes_ = 0;
  std::unique_ptr<MemoryAllocator> memory_;
};

}  // namespace velarium::gpu
