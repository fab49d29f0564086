#include "gpu/pipeline.hpp"

#include "core/assert.hpp"
#include "gpu/check.hpp"
#include "gpu/image.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace velarium::gpu {
namespace {

// A shader module that lives as long as its pipeline is being made.
class Module {
 public:
  Module(VkDevice device, Spirv code) : device_(device) {
    const VkShaderModuleCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = code.size_bytes(), .pCode = code.data()};
    check(vkCreateShaderModule(device, &info, nullptr, &module_), "vkCreateShaderModule");
  }
  ~Module() { vkDestroyShaderModule(device_, module_, nullptr); }
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  [[nodiscard]] VkShaderModule vk() const { return module_; }

 private:
  VkDevice device_;
  VkShaderModule module_ = VK_NULL_HANDLE;
};

// Specialisation constants in the form Vulkan wants, pointing into `constants`.
class SpecializationInfo {
 public:
  explicit SpecializationInfo(const Specialization& constants) {
    const auto values = constants.entries();
    for (std::uint32_t i = 0; i < values.size(); ++i) {
      constexpr std::uint32_t kStride = sizeof(Specialization::Entry), kBits = offsetof(Specialization::Entry, bits);
      entries_.push_back({values[i].id, i * kStride + kBits, sizeof(std::uint32_t)});
    }
    info_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(), values.size_bytes(), values.data()};
  }
  [[nodiscard]] const VkSpecializationInfo* get() const { return entries_.empty() ? nullptr : &info_; }

 private:
  std::vector<VkSpecializationMapEntry> entries_;
  VkSpecializationInfo info_{};
};

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, const Module& module,
                                           const VkSpecializationInfo* constants) {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
          .stage = stage,
          .module = module.vk(),
          .pName = "main",
          .pSpecializationInfo = constants};
}

struct BlendFactors {
  VkBlendFactor source, destination;
};

BlendFactors blend_factors(Blend blend) {
  switch (blend) {
    case Blend::none:
      return {VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ZERO};
    case Blend::premultiplied:
      return {VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA};
    case Blend::translucency:
      return {VK_BLEND_FACTOR_ZERO, VK_BLEND_FACTOR_SRC_COLOR};
    case Blend::add:
      return {VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE};
  }
  return {VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ZERO};
}

VkPipelineColorBlendAttachmentState blend_state(Blend blend, bool write) {
  constexpr VkColorComponentFlags kAll =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  const auto [source, destination] = blend_factors(blend);
  const bool largest_alpha = blend == Blend::translucency || blend == Blend::add;
  return {.blendEnable = blend != Blend::none,
          .srcColorBlendFactor = source,
          .dstColorBlendFactor = destination,
          .colorBlendOp = VK_BLEND_OP_ADD,
          .srcAlphaBlendFactor = source,
          .dstAlphaBlendFactor = destination,
          .alphaBlendOp = largest_alpha ? VK_BLEND_OP_MAX : VK_BLEND_OP_ADD,  // MAX knows no factors
          .colorWriteMask = write ? kAll : 0};
}

struct StencilFaces {
  VkStencilOpState front, back;
};

StencilFaces stencil_faces(Stencil stencil) {
  VkStencilOpState op{.failOp = VK_STENCIL_OP_KEEP,
                      .passOp = VK_STENCIL_OP_KEEP,
                      .depthFailOp = VK_STENCIL_OP_KEEP,
                      .compareOp = VK_COMPARE_OP_ALWAYS,
                      .compareMask = 0xff,
                      .writeMask = 0xff};
  StencilFaces faces{op, op};
  switch (stencil) {
    case Stencil::none:
      break;
    case Stencil::replace:
      faces.front.passOp = faces.back.passOp = VK_STENCIL_OP_REPLACE;
      break;
    case Stencil::enclose:
      // What lies behind the surface is counted, as what lies before it may be cut off by the near plane.
      faces.front.depthFailOp = VK_STENCIL_OP_DECREMENT_AND_WRAP;
      faces.back.depthFailOp = VK_STENCIL_OP_INCREMENT_AND_WRAP;
      break;
    case Stencil::consume:
      op.compareOp = VK_COMPARE_OP_NOT_EQUAL;  // of the dynamic reference, 0
      op.passOp = VK_STENCIL_OP_ZERO;
      faces = {op, op};
      break;
  }
  return faces;
}

VkPipelineDepthStencilStateCreateInfo depth_state(const RasterState& state) {
  const auto [front, back] = stencil_faces(state.stencil);
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
          .depthTestEnable = state.depth_format != VK_FORMAT_UNDEFINED,
          .depthWriteEnable = state.depth_write,
          .depthCompareOp = state.depth_compare,
          .stencilTestEnable = state.stencil != Stencil::none,
          .front = front,
          .back = back};
}

struct VertexInput {
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  VkPipelineVertexInputStateCreateInfo info{};

  explicit VertexInput(const RasterState& state) {
    for (const auto& b : state.vertex_bindings) bindings.push_back({b.binding, b.stride, VK_VERTEX_INPUT_RATE_VERTEX});
    for (const auto& a : state.vertex_attributes) attributes.push_back({a.location, a.binding, a.format, a.offset});
    info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
            .vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size()),
            .pVertexBindingDescriptions = bindings.data(),
            .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
            .pVertexAttributeDescriptions = attributes.data()};
  }
};

VkPipeline create_raster(Device& device, VkPipelineLayout layout,
                         std::span<const VkPipelineShaderStageCreateInfo> stages, const RasterState& state) {
  const VertexInput vertex_input(state);
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = state.topology};
  const VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  const VkPipelineRasterizationStateCreateInfo raster{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .depthClampEnable = state.depth_clamp,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .depthBiasEnable = state.depth_bias,
      .lineWidth = 1.0f};
  const VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO, .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  const auto depth = depth_state(state);
  const bool has_fragment = stages.size() > 1;
  const std::vector<VkPipelineColorBlendAttachmentState> targets(state.color_formats.size(),
                                                                 blend_state(state.blend, has_fragment));
  const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                  .attachmentCount = static_cast<std::uint32_t>(targets.size()),
                                                  .pAttachments = targets.data()};
  const std::array dynamic_states{VK_DYNAMIC_STATE_VIEWPORT,   VK_DYNAMIC_STATE_SCISSOR,
                                  VK_DYNAMIC_STATE_CULL_MODE,  VK_DYNAMIC_STATE_FRONT_FACE,
                                  VK_DYNAMIC_STATE_DEPTH_BIAS, VK_DYNAMIC_STATE_STENCIL_REFERENCE};
  const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                 .dynamicStateCount = static_cast<std::uint32_t>(dynamic_states.size()),
                                                 .pDynamicStates = dynamic_states.data()};
  const VkPipelineRenderingCreateInfo rendering{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
      .colorAttachmentCount = static_cast<std::uint32_t>(state.color_formats.size()),
      .pColorAttachmentFormats = state.color_formats.data(),
      .depthAttachmentFormat = state.depth_format,
      .stencilAttachmentFormat = has_stencil(state.depth_format) ? state.depth_format : VK_FORMAT_UNDEFINED};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .stageCount = static_cast<std::uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertex_input.info,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &raster,
                                          .pMultisampleState = &multisample,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic,
                                          .layout = layout};
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device.vk(), device.pipeline_cache(), 1, &info, nullptr, &pipeline),
        "vkCreateGraphicsPipelines");
  return pipeline;
}

}  // namespace

Pipeline Pipeline::compute(Device& device, const SharedSamplers& samplers, Spirv shader,
                           const Specialization& constants) {
  Pipeline result(device, VK_PIPELINE_BIND_POINT_COMPUTE);
  const std::array reflections{reflect(shader)};
  result.make_layout(reflections, VK_SHADER_STAGE_COMPUTE_BIT, samplers);
  const Module module(device.vk(), shader);
  const SpecializationInfo specialization(constants);
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = stage_info(VK_SHADER_STAGE_COMPUTE_BIT, module, specialization.get()),
                                         .layout = result.layout_};
  check(vkCreateComputePipelines(device.vk(), device.pipeline_cache(), 1, &info, nullptr, &result.pipeline_),
        "vkCreateComputePipelines");
  return result;
}

Pipeline Pipeline::raster(Device& device, const SharedSamplers& samplers, Spirv vertex, Spirv fragment,
                          const RasterState& state) {
  Pipeline result(device, VK_PIPELINE_BIND_POINT_GRAPHICS);
  std::vector<Reflection> reflections{reflect(vertex)};
  if (!fragment.empty()) reflections.push_back(reflect(fragment));
  result.make_layout(reflections, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, samplers);
  const Module vertex_module(device.vk(), vertex);
  std::vector stages{stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex_module, nullptr)};
  std::optional<Module> fragment_module;
  const SpecializationInfo specialization(state.fragment_constants);
  if (!fragment.empty()) {
    fragment_module.emplace(device.vk(), fragment);
    stages.push_back(stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, *fragment_module, specialization.get()));
  }
  result.pipeline_ = create_raster(device, result.layout_, stages, state);
  return result;
}

void Pipeline::make_layout(std::span<const Reflection> shaders, VkShaderStageFlags stages,
                           const SharedSamplers& samplers) {
  for (const auto& shader : shaders)
    for (const auto& binding : shader.bindings)
      if (!binding_type(binding.set, binding.binding)) bindings_.push_back(binding);

  for (std::uint32_t set = 0; set < SharedSamplers::kSet; ++set) {
    std::vector<VkDescriptorSetLayoutBinding> entries;
    for (const auto& b : bindings_) {
      VEL_ASSERT(b.set < kMaxSets);
      if (b.set == set) entries.push_back({b.binding, b.type, b.count, stages, nullptr});
    }
    const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                               .bindingCount = static_cast<std::uint32_t>(entries.size()),
                                               .pBindings = entries.data()};
    check(vkCreateDescriptorSetLayout(device_->vk(), &info, nullptr, &set_layouts_[set]),
          "vkCreateDescriptorSetLayout");
  }
  set_layouts_[SharedSamplers::kSet] = samplers.layout();
  const auto is_sampler = [](const auto& b) { return b.set == SharedSamplers::kSet; };
  if (std::ranges::any_of(bindings_, is_sampler)) shared_samplers_ = samplers.set();
  const VkPushConstantRange push{stages, 0, kPushConstantBytes};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = kMaxSets,
                                        .pSetLayouts = set_layouts_.data(),
                                        .pushConstantRangeCount = 1,
                                        .pPushConstantRanges = &push};
  check(vkCreatePipelineLayout(device_->vk(), &info, nullptr, &layout_), "vkCreatePipelineLayout");
}

std::optional<VkDescriptorType> Pipeline::binding_type(std::uint32_t set, std::uint32_t binding) const {
  const auto found = std::find_if(bindings_.begin(), bindings_.end(),
                                  [&](const auto& b) { return b.set == set && b.binding == binding; });
  if (found == bindings_.end()) return std::nullopt;
  return found->type;
}

Pipeline::~Pipeline() {
  if (pipeline_ == VK_NULL_HANDLE && layout_ == VK_NULL_HANDLE) return;
  vkDestroyPipeline(device_->vk(), pipeline_, nullptr);
  vkDestroyPipelineLayout(device_->vk(), layout_, nullptr);
  for (std::uint32_t set = 0; set < SharedSamplers::kSet; ++set)
    vkDestroyDescriptorSetLayout(device_->vk(), set_layouts_[set], nullptr);
}

Pipeline::Pipeline(Pipeline&& other) noexcept
    : device_(other.device_),
      bind_point_(other.bind_point_),
      pipeline_(std::exchange(other.pipeline_, VK_NULL_HANDLE)),
      layout_(std::exchange(other.layout_, VK_NULL_HANDLE)),
      set_layouts_(std::exchange(other.set_layouts_, {})),
      shared_samplers_(other.shared_samplers_),
      bindings_(std::move(other.bindings_)) {}

}  // namespace velarium::gpu
