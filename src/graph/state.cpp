#include "graph/state.hpp"

#include "gpu/barrier.hpp"

#include <algorithm>

namespace velarium::graph {
namespace {

bool already_visible(const State& state, const AccessInfo& info) {
  return std::any_of(state.seen.begin(), state.seen.end(), [&](const Visibility& seen) {
    return (info.stages & ~seen.stages) == 0 && (info.reads & ~seen.access) == 0;
  });
}

// The barrier that `use` needs in this state, if any; `layouts`: the resource is an image.
bool transition(State& state, const CombinedUse& use, bool layouts, PlannedBarrier& out) {
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

// Adds the barrier of one mip, or lets the barrier of the mips before it, where that is the same, serve it too.
void add_barrier(std::vector<PlannedBarrier>& barriers, const PlannedBarrier& one) {
  if (!barriers.empty()) {
    auto& last = barriers.back();
    PlannedBarrier alike = one;
    alike.mips = last.mips;
    if (alike == last && last.mips.first + last.mips.count == one.mips.first) {
      ++last.mips.count;
      return;
    }
  }
  barriers.push_back(one);
}

}  // namespace

void CombinedUse::add(const AccessInfo& another, bool writes) {
  info.stages |= another.stages;
  info.reads |= another.reads;
  info.layout = another.layout;
  if (writes) info.writes |= another.writes;
  write |= writes;
  used = true;
}

void StateTracker::add(const State& start, std::uint32_t mips) {
  const auto index = static_cast<std::uint32_t>(first_parts_.size());
  first_parts_.push_back(parts_.size());
  for (std::uint32_t mip = 0; mip < mips; ++mip) parts_.push_back({index, mip, start, {}});
}

CombinedUse& StateTracker::use(std::uint32_t index, std::uint32_t mip) {
  const std::size_t place = first_parts_[index] + mip;
  auto& use = parts_[place].use;
  if (!use.used) used_parts_.push_back(place);
  return use;
}

std::vector<PlannedBarrier> StateTracker::barriers() {
  std::sort(used_parts_.begin(), used_parts_.end());
  std::vector<PlannedBarrier> result;
  for (const std::size_t place : used_parts_) {
    auto& part = parts_[place];
    PlannedBarrier barrier{.index = part.index, .mips = {part.mip, 1}};
    if (transition(part.state, part.use, layouts_, barrier)) add_barrier(result, barrier);
    part.use = {};
  }
  used_parts_.clear();
  return result;
}

VkImageLayout StateTracker::unify(std::uint32_t index, std::vector<PlannedBarrier>& out) const {
  const auto first = parts_.begin() + static_cast<std::ptrdiff_t>(first_parts_[index]);
  const auto last = std::find_if(first, parts_.end(), [&](const Part& part) { return part.index != index; });
  const auto known =
      std::find_if(first, last, [](const Part& part) { return part.state.layout != VK_IMAGE_LAYOUT_UNDEFINED; });
  if (known == last) return VK_IMAGE_LAYOUT_UNDEFINED;
  const VkImageLayout target = known->state.layout;
  for (auto part = first; part != last; ++part) {
    const auto& state = part->state;
    if (state.layout == target) continue;
    add_barrier(out, {.index = index,
                      .mips = {part->mip, 1},
                      .src_stages = state.write_stages | state.read_stages,
                      .dst_stages = gpu::kAllWork.stages,
                      .src_access = state.write_access,
                      .dst_access = gpu::kAllWork.access,
                      .old_layout = state.layout,
                      .new_layout = target});
  }
  return target;
}

}  // namespace velarium::graph
