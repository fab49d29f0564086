#include "graph/context.hpp"

#include "core/assert.hpp"

namespace velarium::graph {
namespace {

VkRenderingAttachmentInfo color_attachment(VkImageView view, bool clear) {
  return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
          .imageView = view,
          .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
          .loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD,
          .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
}

VkRenderingAttachmentInfo depth_attachment(VkImageView view, const RenderTargets& targets) {
  return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
          .imageView = view,
          .imageLayout = targets.depth_writable ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL
                                                : VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL,
          .loadOp = targets.clear_depth ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD,
          .storeOp = targets.depth_writable ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE};
}

VkRect2D rect(const Area& area) {
  return {{static_cast<std::int32_t>(area.x), static_cast<std::int32_t>(area.y)}, {area.width, area.height}};
}

}  // namespace

void Context::bind(const gpu::Pipeline& pipeline) const {
  vkCmdBindPipeline(commands_, pipeline.bind_point(), pipeline.vk());
  if (const VkDescriptorSet samplers = pipeline.shared_samplers(); samplers != VK_NULL_HANDLE)
    vkCmdBindDescriptorSets(commands_, pipeline.bind_point(), pipeline.layout(), gpu::SharedSamplers::kSet, 1,
                            &samplers, 0, nullptr);
}

SetWriter Context::set(const gpu::Pipeline& pipeline, std::uint32_t set) const {
  return {*this, pipeline, set};
}

void Context::bind_set(const gpu::Pipeline& pipeline, std::uint32_t set, const gpu::Bindings& bindings) const {
  const VkDescriptorSet descriptors = tools_.descriptors.make(pipeline, set, bindings);
  vkCmdBindDescriptorSets(commands_, pipeline.bind_point(), pipeline.layout(), set, 1, &descriptors, 0, nullptr);
}

void Context::push(const gpu::Pipeline& pipeline, std::span<const std::byte> bytes) const {
  const VkShaderStageFlags stages = pipeline.bind_point() == VK_PIPELINE_BIND_POINT_COMPUTE
                                        ? VK_SHADER_STAGE_COMPUTE_BIT
                                        : VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  vkCmdPushConstants(commands_, pipeline.layout(), stages, 0, static_cast<std::uint32_t>(bytes.size()), bytes.data());
}

void Context::dispatch(std::uint32_t width, std::uint32_t height, std::uint32_t group_x, std::uint32_t group_y) const {
  dispatch({width, height, 1}, {group_x, group_y, 1});
}

void Context::dispatch(VkExtent3D threads, VkExtent3D group) const {
  vkCmdDispatch(commands_, (threads.width + group.width - 1) / group.width,
                (threads.height + group.height - 1) / group.height, (threads.depth + group.depth - 1) / group.depth);
}

void Context::begin_rendering(const RenderTargets& targets) const {
  const auto view = [&](GraphImage target) { return image(target).layer_view(targets.layer, target.target_mip()); };
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const auto& color : targets.colors) colors.push_back(color_attachment(view(color.image), color.clear));
  const bool has_depth = targets.depth.version != 0;
  VkRenderingAttachmentInfo depth{};
  if (has_depth) depth = depth_attachment(view(targets.depth), targets);
  const bool has_stencil = has_depth && gpu::has_stencil(image(targets.depth).desc().format);

  const GraphImage sized = has_depth ? targets.depth : targets.colors.front().image;
  const VkExtent3D size = gpu::mip_extent(image(sized).desc(), sized.target_mip());
  const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                             .renderArea = {{0, 0}, {size.width, size.height}},
                             .layerCount = 1,
                             .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                             .pColorAttachments = colors.data(),
                             .pDepthAttachment = has_depth ? &depth : nullptr,
                             .pStencilAttachment = has_stencil ? &depth : nullptr};
  vkCmdBeginRendering(commands_, &info);
  set_area({0, 0, size.width, size.height});
}

void Context::set_area(const Area& area) const {
  const VkViewport viewport{static_cast<float>(area.x),
                            static_cast<float>(area.y),
                            static_cast<float>(area.width),
                            static_cast<float>(area.height),
                            0.0f,
                            1.0f};
  const VkRect2D scissor = rect(area);
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &scissor);
}

void Context::clear_depth(const Area& area) const {
  const VkClearAttachment clear{.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT};
  const VkClearRect where{rect(area), 0, 1};
  vkCmdClearAttachments(commands_, 1, &clear, 1, &where);
}

void Context::clear_color(const Area& area, const std::array<float, 4>& value) const {
  const VkClearAttachment clear{.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                                .clearValue = {.color = {.float32 = {value[0], value[1], value[2], value[3]}}}};
  const VkClearRect where{rect(area), 0, 1};
  vkCmdClearAttachments(commands_, 1, &clear, 1, &where);
}

void Context::end_rendering() const {
  vkCmdEndRendering(commands_);
}

const gpu::Slot& SetWriter::checked(const gpu::Slot& slot) const {
  VEL_ASSERT(slot.set == set_);
  return slot;
}

SetWriter& SetWriter::sampled(const gpu::Slot& slot, GraphImage handle) {
  if (handle.version == 0) return sampled(slot, nullptr);
  const auto& image = context_.image(handle);
  const bool depth = gpu::has_depth(image.desc().format);
  bindings_.image(checked(slot), image.sampled_view(handle.mip), access_info(Access::compute_sample, depth).layout);
  return *this;
}

SetWriter& SetWriter::stencil(const gpu::Slot& slot, GraphImage handle) {
  bindings_.image(checked(slot), context_.image(handle).stencil_view(),
                  access_info(Access::compute_sample, true).layout);
  return *this;
}

SetWriter& SetWriter::storage(const gpu::Slot& slot, GraphImage handle) {
  bindings_.storage(checked(slot), context_.image(handle).mip_view(handle.target_mip()));
  return *this;
}

SetWriter& SetWriter::buffer(const gpu::Slot& slot, GraphBuffer handle) {
  return buffer(slot, handle.version == 0 ? context_.tools().nulls.buffer() : context_.buffer(handle));
}

SetWriter& SetWriter::sampled(const gpu::Slot& slot, const gpu::Image* image) {
  bindings_.image(checked(slot), (image != nullptr ? *image : context_.tools().nulls.image(slot.type)).view());
  return *this;
}

SetWriter& SetWriter::sampled(const gpu::Slot& slot, const gpu::Image& image, const gpu::SamplerDesc& sampler) {
  bindings_.sampled(checked(slot), image.view(), context_.tools().samplers.get(sampler));
  return *this;
}

SetWriter& SetWriter::buffer(const gpu::Slot& slot, const gpu::Buffer& buffer) {
  bindings_.buffer(checked(slot), buffer ? buffer : context_.tools().nulls.buffer());
  return *this;
}

void SetWriter::bind() {
  context_.bind_set(pipeline_, set_, bindings_);
}

}  // namespace velarium::graph
