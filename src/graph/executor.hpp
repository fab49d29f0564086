#pragma once

#include "gpu/timers.hpp"
#include "gpu/gpu_context.hpp"
#include "graph/graph.hpp"
#include "graph/plan.hpp"

#include <map>
#include <string>
#include <vector>

namespace velarium::graph {

struct PassTiming {
  std::string name;
  double ms = 0;
};

// Runs graphs: allocates what they declare (and keeps it for the next frame that declares the same), inserts the
// planned barriers, labels and times each pass.
class Executor {
 public:
  explicit Executor(gpu::GpuContext& tools) : tools_(tools), timers_(tools.device) {}

  // Records, submits and waits. `paranoid`: each barrier becomes a full one.
  // Throws Error(temporary) as gpu::Device::submit_and_wait does.
  void run(const Graph& graph, bool paranoid = false);

  // Of the last run.
  [[nodiscard]] std::vector<PassTiming> timings() const;
  [[nodiscard]] double frame_ms() const;
  [[nodiscard]] const gpu::Buffer& buffer(GraphBuffer handle) const { return *buffer_list_[handle.index]; }

  // An image of the last run by its full name ("gbuffer.depth"), or null; it stays until the next run.
  [[nodiscard]] gpu::Image* find_image(const std::string& name);
  [[nodiscard]] std::vector<std::string> image_names() const;

  // Device memory of an image that some run declared, which is kept for the next; 0 where there is none.
  [[nodiscard]] std::uint64_t kept_bytes(const std::string& name) const;
  // Gives back such an image. Between runs of different pictures: those of the last run can no longer be found.
  void drop(const std::string& name);

 private:
  void allocate(const Graph& graph);
  void record(const Graph& graph, VkCommandBuffer commands, bool paranoid);
  void barriers(VkCommandBuffer commands, const PlannedPass& planned, bool paranoid) const;
  void begin_label(VkCommandBuffer commands, const std::string& name) const;
  void end_label(VkCommandBuffer commands) const;

  gpu::GpuContext& tools_;
  gpu::Timers timers_;
  std::map<std::string, gpu::Image> images_;
  struct KeptBuffer {
    VkBufferUsageFlags usage = 0;
    gpu::MemoryUse use = gpu::MemoryUse::device;
    gpu::Buffer buffer;
  };
  std::map<std::string, KeptBuffer> buffers_;
  std::vector<gpu::Image*> image_list_;  // by index in the graph
  std::vector<gpu::Buffer*> buffer_list_;
  std::vector<std::string> pass_names_, image_names_;
};

}  // namespace velarium::graph
