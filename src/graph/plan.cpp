#include "graph/plan.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace velarium::graph {
namespace {

// Stages and accesses of one barrier, which only together say who sees a write.
struct Visibility {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;
};

// What the device has done to a resource so far.
struct State {
  VkPipelineStageFlags2 write_stages = 0;  // of the last write, and of barriers since, to chain on
  VkAccessFlags2 write_access = 0;
  VkPipelineStageFlags2 read_stages = 0;  // that read since the last write: the next write waits for them
  std::vector<Visibility> seen;           // to which the last write was made visible
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

// A pass may use a resource in several ways at once (test depth and sample it): one barrier serves all.
struct Combined {
  AccessInfo info{};
  bool write = false, used = false;
};

// An image has one layout at a time: a pass that needs two of them could not run.
void refuse_two_layouts(const Pass& pass, const std::string& image, const Combined& combined, const AccessInfo& info) {
  if (combined.used && combined.info.layout != info.layout)
    throw Error(ErrorCode::internal, fmt::format("pass '{}' uses '{}' in two image layouts", pass.name(), image));
}

void add_use(Combined& combined, const AccessInfo& info, bool write) {
  combined.info.stages |= info.stages;
  combined.info.reads |= info.reads;
  combined.info.layout = info.layout;
  if (write) combined.info.writes |= info.writes;
  combined.write |= write;
  combined.used = true;
}

bool already_visible(const State& state, const AccessInfo& info) {
  return std::any_of(state.seen.begin(), state.seen.end(), [&](const Visibility& seen) {
    return (info.stages & ~seen.stages) == 0 && (info.reads & ~seen.access) == 0;
  });
}

// The barrier that `use` needs in this state, if any; `layouts`: the resource is an image.
bool transition(State& state, const Combined& use, bool layouts, PlannedBarrier& out) {
  const bool relayout = layouts && state.layout != use.info.layout;
  const bool untouched = state.write_stages == 0 && state.read_stages == 0;
  const bool needed = relayout || (use.write ? !untouched : !untouched && !already_visible(state, use.info));
  const VkAccessFlags2 access = use.info.reads | use.info.writes;
  if (needed) {
    out.src_stages = state.write_stages;
    // A relayout writes, and so does a write: both wait for those who still read.
    if (use.write || relayout) out.src_stages |= state.read_stages;
    // Whoever has read made a barrier that flushed the write: to wait for the readers is then enough.
    const bool flushed = use.write && state.read_stages != 0;
    out.src_access = flushed ? 0 : state.write_access;
    out.dst_stages = use.info.stages;
    out.dst_access = access;
    out.old_layout = state.layout;
    out.new_layout = layouts ? use.info.layout : VK_IMAGE_LAYOUT_UNDEFINED;
  }
  if (use.write) {
    state = {.write_stages = use.info.stages, .write_access = use.info.writes};
  } else {
    if (relayout) {
      state.seen.clear();
      state.read_stages = 0;
    }
    // Later barriers must chain on this one, which carried the write (and the relayout) to these stages.
    if (needed) {
      state.write_stages |= use.info.stages;
      state.seen.push_back({use.info.stages, use.info.reads});
    }
    state.read_stages |= use.info.stages;
  }
  if (layouts) state.layout = use.info.layout;
  return needed;
}

void plan_uses(const std::vector<Combined>& uses, std::vector<State>& states, bool layouts,
               std::vector<PlannedBarrier>& out) {
  for (std::uint32_t i = 0; i < uses.size(); ++i) {
    PlannedBarrier barrier{.index = i};
    if (uses[i].used && transition(states[i], uses[i], layouts, barrier)) out.push_back(barrier);
  }
}

// Images from before this frame were last used by anyone, in the layout that the executor left them in.
std::vector<State> initial_image_states(const Graph& graph) {
  std::vector<State> states(graph.images().size());
  for (std::size_t i = 0; i < states.size(); ++i)
    if (graph.images()[i].imported != nullptr)
      states[i] = {.write_stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, .write_access = VK_ACCESS_2_MEMORY_WRITE_BIT};
  return states;
}

}  // namespace

std::vector<PlannedPass> plan(const Graph& graph) {
  auto images = initial_image_states(graph);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto* imported = graph.images()[i].imported;
    if (imported != nullptr) images[i].layout = imported->layout;
  }
  std::vector<State> buffers(graph.buffers().size());
  std::vector<PlannedPass> result;
  for (const auto& pass : graph.passes()) {
    std::vector<Combined> image_uses(images.size()), buffer_uses(buffers.size());
    for (const auto& use : pass.image_uses()) {
      const auto& image = graph.images()[use.index];
      const AccessInfo info = access_info(use.access, gpu::has_depth(image.desc.format));
      refuse_two_layouts(pass, image.name, image_uses[use.index], info);
      add_use(image_uses[use.index], info, use.write);
    }
    for (const auto& use : pass.buffer_uses())
      add_use(buffer_uses[use.index], access_info(use.access, false), use.write);
    auto& planned = result.emplace_back();
    plan_uses(image_uses, images, true, planned.images);
    plan_uses(buffer_uses, buffers, false, planned.buffers);
  }
  return result;
}

}  // namespace velarium::graph
