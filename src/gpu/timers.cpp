#include "gpu/timers.hpp"

#include "gpu/check.hpp"

namespace velarium::gpu {

Timers::~Timers() {
  if (pool_ != VK_NULL_HANDLE) vkDestroyQueryPool(device_.vk(), pool_, nullptr);
}

void Timers::begin(VkCommandBuffer commands, std::uint32_t intervals) {
  intervals_ = device_.caps().timestamp_ns > 0.0 ? intervals : 0;
  if (intervals_ == 0) return;
  if (intervals_ > capacity_) {
    if (pool_ != VK_NULL_HANDLE) vkDestroyQueryPool(device_.vk(), pool_, nullptr);
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = 2 * intervals_};
    check(vkCreateQueryPool(device_.vk(), &info, nullptr, &pool_), "vkCreateQueryPool");
    capacity_ = intervals_;
  }
  vkCmdResetQueryPool(commands, pool_, 0, 2 * intervals_);
}

void Timers::start(VkCommandBuffer commands, std::uint32_t interval) {
  if (intervals_ != 0) vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, 2 * interval);
}

void Timers::stop(VkCommandBuffer commands, std::uint32_t interval) {
  if (intervals_ != 0) vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, 2 * interval + 1);
}

std::vector<double> Timers::read() const {
  if (intervals_ == 0) return {};
  std::vector<std::uint64_t> ticks(std::size_t{2} * intervals_);
  check(vkGetQueryPoolResults(device_.vk(), pool_, 0, 2 * intervals_, ticks.size() * sizeof(std::uint64_t),
                              ticks.data(), sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
  std::vector<double> ms(intervals_);
  for (std::uint32_t i = 0; i < intervals_; ++i)
    ms[i] = static_cast<double>(ticks[2 * std::size_t{i} + 1] - ticks[2 * std::size_t{i}]) *
            device_.caps().timestamp_ns * 1e-6;
  return ms;
}

}  // namespace velarium::gpu
