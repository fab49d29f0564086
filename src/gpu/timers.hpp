#pragma once

#include "gpu/device.hpp"

#include <vector>

namespace velarium::gpu {

// Timestamps around intervals of one submission. Does nothing, and says no times, on a device without timestamps.
class Timers {
 public:
  explicit Timers(Device& device) : device_(device) {}
  ~Timers();
  Timers(const Timers&) = delete;
  Timers& operator=(const Timers&) = delete;

  // Makes room for `intervals` and forgets the last submission's. First command of the submission.
  void begin(VkCommandBuffer commands, std::uint32_t intervals);
  void start(VkCommandBuffer commands, std::uint32_t interval);
  void stop(VkCommandBuffer commands, std::uint32_t interval);
  // Milliseconds of each interval, once the device has finished; empty without timestamps.
  [[nodiscard]] std::vector<double> read() const;

 private:
  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t capacity_ = 0, intervals_ = 0;
};

}  // namespace velarium::gpu
