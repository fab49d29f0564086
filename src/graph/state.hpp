#pragma once

#include "graph/plan.hpp"

#include <vector>

namespace velarium::graph {

// Stages and accesses of one barrier, which only together say who sees a write.
struct Visibility {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;
};

// What the device has done so far to what is tracked by itself: one mip of an image, or a buffer.
struct State {
  VkPipelineStageFlags2 write_stages = 0;  // of the last write, and of barriers since, to chain on
  VkAccessFlags2 write_access = 0;
  VkPipelineStageFlags2 read_stages = 0;  // that read since the last write: the next write waits for them
  std::vector<Visibility> seen;           // to which the last write was made visible
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

// A pass may use a resource in several ways at once (test depth and sample it): one barrier serves all.
struct CombinedUse {
  AccessInfo info{};
  bool write = false, used = false;

  void add(const AccessInfo& another, bool writes);
};

// The states of all images of a graph, mip by mip, or of all its buffers, while passes are planned in order.
class StateTracker {
 public:
  enum class Kind { images, buffers };
  explicit StateTracker(Kind kind) : layouts_(kind == Kind::images) {}

  // The next resource, of so many mips (1 for a buffer).
  void add(const State& start, std::uint32_t mips);
  // How the pass that is planned uses a mip, to be added to.
  [[nodiscard]] CombinedUse& use(std::uint32_t index, std::uint32_t mip);
  // What all uses since the last call need. Neighbouring mips that need the same share a barrier.
  [[nodiscard]] std::vector<PlannedBarrier> barriers();
  // What brings the mips of an image into one layout, added to `out`; returns that layout.
  VkImageLayout unify(std::uint32_t index, std::vector<PlannedBarrier>& out) const;

 private:
  struct Part {
    std::uint32_t index = 0, mip = 0;
    State state;
    CombinedUse use;
  };
  bool layouts_;
  std::vector<Part> parts_;
  std::vector<std::size_t> first_parts_;  // of each resource
  std::vector<std::size_t> used_parts_;   // by the pass that is planned
};

}  // namespace velarium::graph
