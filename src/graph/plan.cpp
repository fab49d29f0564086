#include "graph/plan.hpp"

#include "graph/state.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::graph {
namespace {

// What comes from outside was last used by anyone, and so is what the executor keeps while the graph before runs.
State start_of(bool imported, Before before) {
  if (!imported && before == Before::finished) return {};
  return {.write_stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, .write_access = VK_ACCESS_2_MEMORY_WRITE_BIT};
}

// Images from outside are in the layout that they were left in. What those of the executor contain matters to nobody.
StateTracker images_before(const Graph& graph, Before before) {
  StateTracker tracker(StateTracker::Kind::images);
  for (const auto& image : graph.images()) {
    State start = start_of(image.imported != nullptr, before);
    if (image.imported != nullptr) start.layout = image.imported->layout;
    tracker.add(start, image.desc.mips);
  }
  return tracker;
}

StateTracker buffers_before(const Graph& graph, Before before) {
  StateTracker tracker(StateTracker::Kind::buffers);
  for (const auto& buffer : graph.buffers()) tracker.add(start_of(buffer.imported != nullptr, before), 1);
  return tracker;
}

// A mip has one layout at a time: a pass that needs two of them could not run.
void refuse_two_layouts(const Pass& pass, const Graph::ImageResource& image, std::uint32_t mip, const CombinedUse& use,
                        const AccessInfo& info) {
  if (!use.used || use.info.layout == info.layout) return;
  const std::string which = image.desc.mips > 1 ? fmt::format("mip {} of ", mip) : std::string();
  throw Error(ErrorCode::internal,
              fmt::format("pass '{}' uses {}'{}' in two image layouts", pass.name(), which, image.name));
}

void refuse_unwritten_history(const Graph& graph) {
  for (const auto& history : graph.histories())
    for (const std::uint32_t version : graph.images()[history.current].mip_versions)
      if (version == 0)
        throw Error(
            ErrorCode::internal,
            fmt::format("history '{}' is not written, or not whole, by the graph that declares it", history.name));
}

void add_image_uses(const Graph& graph, const Pass& pass, StateTracker& images) {
  for (const auto& use : pass.image_uses()) {
    const auto& image = graph.images()[use.index];
    const AccessInfo info = access_info(use.access, gpu::has_depth(image.desc.format));
    const auto range = mips_of(use.mip, image.desc.mips);
    for (std::uint32_t mip = range.first; mip < range.first + range.count; ++mip) {
      auto& combined = images.use(use.index, mip);
      refuse_two_layouts(pass, image, mip, combined, info);
      combined.add(info, use.write);
    }
  }
}

}  // namespace

Plan plan(const Graph& graph, Before before) {
  refuse_unwritten_history(graph);
  auto images = images_before(graph, before);
  auto buffers = buffers_before(graph, before);
  Plan result;
  for (const auto& pass : graph.passes()) {
    add_image_uses(graph, pass, images);
    for (const auto& use : pass.buffer_uses()) buffers.use(use.index, 0).add(access_info(use.access, false), use.write);
    result.passes.push_back({images.barriers(), buffers.barriers()});
  }
  for (std::uint32_t i = 0; i < graph.images().size(); ++i)
    result.final_layouts.push_back(images.unify(i, result.closing));
  return result;
}

}  // namespace velarium::graph
