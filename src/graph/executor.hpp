#pragma once

#include "gpu/timers.hpp"
#include "gpu/gpu_context.hpp"
#include "graph/graph.hpp"
#include "graph/kept.hpp"
#include "graph/plan.hpp"

#include <array>
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
  explicit Executor(gpu::GpuContext& tools);
  // Waits for what runs.
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  // Records, submits and waits. `paranoid`: each barrier becomes a full one.
  // Throws Error(temporary) as gpu::Device::wait() does, and Error(internal) as plan() does and for a history that has
  // changed since the graph was declared.
  void run(const Graph& graph, bool paranoid = false);

  // Records and submits, and returns while the device may still work: for loops, which record a frame while the one
  // before runs. At most kMaxRunning run at once: the next waits for the first of them. Throws as run(). What the graph
  // imports must stay as it is until the submission has finished, and only this executor may use its toolbox until
  // then.
  gpu::Submission submit(const Graph& graph, bool paranoid = false);
  // Waits for all that was submitted, or for one submission and those before it. Throws as gpu::Device::wait().
  void wait();
  void wait(gpu::Submission submission);

  // Times of the passes, and a buffer, of the last submission, or of one of the last kMaxRunning. Times wait for the
  // device; whoever reads a buffer must have waited. A buffer stays as it is until its slot comes round again.
  [[nodiscard]] std::vector<PassTiming> timings() const { return timings_of(slots_[last_slot_]); }
  [[nodiscard]] std::vector<PassTiming> timings(gpu::Submission submission) const;
  [[nodiscard]] double frame_ms() const;
  [[nodiscard]] const gpu::Buffer& buffer(GraphBuffer handle) const {
    return *slots_[last_slot_].buffers[handle.index];
  }
  [[nodiscard]] const gpu::Buffer& buffer(GraphBuffer handle, gpu::Submission submission) const;

  // Against which graphs that ask for images of the frame before are declared: Graph graph(executor.history()).
  [[nodiscard]] HistoryStore* history() { return &history_; }
  // For a new picture: from here on there is no frame before.
  void forget_history() { history_.forget(); }

  // An image of the last graph by its full name ("gbuffer.depth"), or null; it stays until the next one.
  [[nodiscard]] gpu::Image* find_image(const std::string& name);
  [[nodiscard]] std::vector<std::string> image_names() const;

  // Every image that is kept, by full name: those of graphs, then those of the frame before and after.
  [[nodiscard]] std::vector<KeptImage> images() const;
  // Frees the images and buffers that no graph since the last sweep declared. Waits for what runs.
  void sweep();

 private:
  // What a submission has for itself until it has finished.
  struct Slot {
    explicit Slot(gpu::Device& device) : timers(device) {}
    gpu::Timers timers;
    gpu::Submission submission{};
    bool running = false;
    std::vector<std::string> pass_names;
    std::vector<gpu::Buffer*> buffers;  // by index in the graph
  };
  [[nodiscard]] std::size_t free_slot();
  [[nodiscard]] const Slot& slot_of(gpu::Submission submission) const;
  [[nodiscard]] std::vector<PassTiming> timings_of(const Slot& slot) const;
  void allocate(const Graph& graph, std::size_t slot);
  // Returns the layouts in which the images are left.
  std::vector<VkImageLayout> record(const Graph& graph, Slot& slot, VkCommandBuffer commands, bool paranoid);
  void barriers(VkCommandBuffer commands, const PlannedPass& planned, bool paranoid, const Slot& slot) const;
  void begin_label(VkCommandBuffer commands, const std::string& name) const;
  void end_label(VkCommandBuffer commands) const;

  gpu::GpuContext& tools_;
  std::array<Slot, kMaxRunning> slots_;
  std::size_t last_slot_ = 0;
  KeptResources kept_;
  HistoryStore history_;
  std::uint64_t runs_ = 0, swept_run_ = 0;  // numbers of the last run, and of the last before the last sweep
  std::vector<gpu::Image*> image_list_;     // of the last graph, by index
  std::vector<std::string> image_names_;
};

}  // namespace velarium::graph
