#include "graph/executor.hpp"

#include "core/assert.hpp"
#include "gpu/barrier.hpp"
#include "graph/context.hpp"

#include <algorithm>

namespace velarium::graph {

Executor::Executor(gpu::GpuContext& tools)
    : tools_(tools), slots_{Slot(tools.device), Slot(tools.device)}, kept_(tools.device) {}

Executor::~Executor() {
  tools_.device.wait_idle();
}

void Executor::run(const Graph& graph, bool paranoid) {
  wait();  // so that all runs share one slot and its buffers
  submit(graph, paranoid);
  wait();
}

gpu::Submission Executor::submit(const Graph& graph, bool paranoid) {
  history_.refuse_outdated(graph);
  tools_.nulls.make();
  const std::size_t index = free_slot();
  auto& slot = slots_[index];
  allocate(graph, index);
  tools_.descriptors.reset(index);
  const VkCommandBuffer commands = tools_.device.begin();
  const auto layouts = record(graph, slot, commands, paranoid);
  slot.submission = tools_.device.submit(commands);
  slot.running = true;
  last_slot_ = index;
  for (std::size_t i = 0; i < layouts.size(); ++i)
    if (layouts[i] != VK_IMAGE_LAYOUT_UNDEFINED) image_list_[i]->layout = layouts[i];
  history_.advance(graph);
  return slot.submission;
}

void Executor::wait() {
  if (std::none_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.running; })) return;
  tools_.device.wait();
  for (auto& slot : slots_) slot.running = false;
}

void Executor::wait(gpu::Submission submission) {
  tools_.device.wait(submission);
  for (auto& slot : slots_) slot.running = slot.running && slot.submission > submission;
}

std::size_t Executor::free_slot() {
  const auto by_age = [](const Slot& a, const Slot& b) { return a.submission < b.submission; };
  const auto free = std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return !slot.running; });
  const auto slot = free != slots_.end() ? free : std::min_element(slots_.begin(), slots_.end(), by_age);
  if (slot->running) wait(slot->submission);
  return static_cast<std::size_t>(slot - slots_.begin());
}

void Executor::allocate(const Graph& graph, std::size_t slot) {
  ++runs_;
  history_.allocate(tools_.device, graph, runs_);
  image_list_.clear();
  image_names_.clear();
  for (const auto& resource : graph.images()) {
    image_list_.push_back(resource.imported != nullptr ? resource.imported : &kept_.image(resource, runs_));
    image_names_.push_back(resource.name);
  }
  auto& buffers = slots_[slot].buffers;
  buffers.clear();
  for (const auto& resource : graph.buffers()) {
    buffers.push_back(resource.imported != nullptr ? resource.imported : &kept_.buffer(resource, slot, runs_));
    if (!resource.contents.empty()) std::ranges::copy(resource.contents, buffers.back()->mapped().begin());
  }
}

std::vector<VkImageLayout> Executor::record(const Graph& graph, Slot& slot, VkCommandBuffer commands, bool paranoid) {
  const auto pass_count = static_cast<std::uint32_t>(graph.passes().size());
  slot.timers.begin(commands, pass_count);
  slot.pass_names.clear();
  history_.clear_missing(graph, commands);
  const bool running = std::any_of(slots_.begin(), slots_.end(), [](const Slot& other) { return other.running; });
  auto planned = plan(graph, running ? Before::running : Before::finished);
  Context context(tools_, commands, image_list_, slot.buffers);
  for (std::uint32_t i = 0; i < pass_count; ++i) {
    const auto& pass = graph.passes()[i];
    slot.pass_names.push_back(pass.name());
    begin_label(commands, pass.name());
    // Before the barriers: a software driver may put a timestamp off until a barrier makes it finish what it has.
    slot.timers.start(commands, i);
    barriers(commands, planned.passes[i], paranoid, slot);
    if (pass.record()) pass.record()(context);
    slot.timers.stop(commands, i);
    end_label(commands);
  }
  barriers(commands, {planned.closing, {}}, false, slot);
  return std::move(planned.final_layouts);
}

void Executor::barriers(VkCommandBuffer commands, const PlannedPass& planned, bool paranoid, const Slot& slot) const {
  std::vector<VkImageMemoryBarrier2> images;
  for (const auto& b : planned.images) {
    const auto& image = *image_list_[b.index];
    const auto before = paranoid ? gpu::kAllWork : gpu::Scope{b.src_stages, b.src_access};
    const auto after = paranoid ? gpu::kAllWork : gpu::Scope{b.dst_stages, b.dst_access};
    images.push_back(gpu::image_barrier(image, before, after, {b.old_layout, b.new_layout}, b.mips));
  }
  std::vector<VkBufferMemoryBarrier2> buffers;
  for (const auto& b : planned.buffers)
    buffers.push_back({.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                       .srcStageMask = b.src_stages,
                       .srcAccessMask = b.src_access,
                       .dstStageMask = b.dst_stages,
                       .dstAccessMask = b.dst_access,
                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .buffer = slot.buffers[b.index]->vk(),
                       .size = VK_WHOLE_SIZE});
  if (!paranoid && images.empty() && buffers.empty()) return;
  constexpr VkMemoryBarrier2 kFull = gpu::memory_barrier(gpu::kAllWork, gpu::kAllWork);
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .memoryBarrierCount = paranoid ? 1u : 0u,
                              .pMemoryBarriers = &kFull,
                              .bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers.size()),
                              .pBufferMemoryBarriers = buffers.data(),
                              .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
                              .pImageMemoryBarriers = images.data()};
  vkCmdPipelineBarrier2(commands, &info);
}

void Executor::begin_label(VkCommandBuffer commands, const std::string& name) const {
  if (!tools_.device.has_labels()) return;
  const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = name.c_str()};
  vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void Executor::end_label(VkCommandBuffer commands) const {
  if (tools_.device.has_labels()) vkCmdEndDebugUtilsLabelEXT(commands);
}

const Executor::Slot& Executor::slot_of(gpu::Submission submission) const {
  const auto found = std::find_if(slots_.begin(), slots_.end(),
                                  [submission](const Slot& slot) { return slot.submission == submission; });
  VEL_ASSERT(found != slots_.end());
  return *found;
}

std::vector<PassTiming> Executor::timings_of(const Slot& slot) const {
  const auto ms = slot.timers.read();
  std::vector<PassTiming> result;
  for (std::size_t i = 0; i < ms.size(); ++i) result.push_back({slot.pass_names[i], ms[i]});
  return result;
}

std::vector<PassTiming> Executor::timings(gpu::Submission submission) const {
  return timings_of(slot_of(submission));
}

const gpu::Buffer& Executor::buffer(GraphBuffer handle, gpu::Submission submission) const {
  return *slot_of(submission).buffers[handle.index];
}

double Executor::frame_ms() const {
  double sum = 0;
  for (const auto& pass : timings()) sum += pass.ms;
  return sum;
}

gpu::Image* Executor::find_image(const std::string& name) {
  const auto found = std::find(image_names_.begin(), image_names_.end(), name);
  return found == image_names_.end() ? nullptr : image_list_[static_cast<std::size_t>(found - image_names_.begin())];
}

std::vector<std::string> Executor::image_names() const {
  return image_names_;
}

std::vector<KeptImage> Executor::images() const {
  auto result = kept_.images(runs_);
  for (const auto& [name, pair] : history_.pairs()) {
    const bool declared = pair.declared_in == runs_;
    const auto &newest = pair.images[1 - pair.current], &older = pair.images[pair.current];
    if (newest) result.push_back({name, newest.bytes(), declared});
    if (older) result.push_back({name + ".previous", older.bytes(), declared});
  }
  return result;
}

void Executor::sweep() {
  wait();
  if (swept_run_ == runs_) {  // the last graph's own go too
    image_list_.clear();
    image_names_.clear();
  }
  kept_.free_declared_until(swept_run_);
  history_.free_declared_until(swept_run_);
  swept_run_ = runs_;
}

}  // namespace velarium::graph
