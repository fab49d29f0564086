#pragma once

#include "gpu/device.hpp"
#include "gpu/shared_samplers.hpp"
#include "gpu/specialization.hpp"
#include "gpu/spirv.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace velarium::gpu {

inline constexpr std::uint32_t kMaxSets = 4;  // pass, illumination, material, samplers

using Spirv = std::span<const std::uint32_t>;

struct VertexAttribute {
  std::uint32_t location = 0, binding = 0;
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t offset = 0;
  bool operator==(const VertexAttribute&) const = default;
};

struct VertexBinding {
  std::uint32_t binding = 0, stride = 0;
  bool operator==(const VertexBinding&) const = default;
};

enum class Blend {
  none,
  premultiplied,  // new + (1 - new.a) old
  translucency,   // rgb: new old; a: the larger
  add,            // rgb: new + old; a: the larger
};

// What becomes of the stencil.
enum class Stencil {
  none,
  replace,  // by the dynamic reference, where a fragment passes
  enclose,  // of a closed body drawn whole: not 0 where a surface is inside, wherever the eye is; 0 before
  consume,  // draws where it is not 0, and leaves 0
};

// Viewport, scissor, cull mode, front face, stencil reference and depth bias are always dynamic. Depth is reversed-Z.
struct RasterState {
  std::vector<VertexBinding> vertex_bindings;
  std::vector<VertexAttribute> vertex_attributes;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  std::vector<VkFormat> color_formats;
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  VkCompareOp depth_compare = VK_COMPARE_OP_GREATER_OR_EQUAL;
  bool depth_write = true;
  bool depth_clamp = false;  // what stands before the near plane is drawn on it, rather than cut off
  bool depth_bias = false;   // by vkCmdSetDepthBias
  Stencil stencil = Stencil::none;
  Blend blend = Blend::none;  // of every colour target
  Specialization fragment_constants;
  bool operator==(const RasterState&) const = default;
};

// A pipeline, its layout and its descriptor set layouts, all from the shaders' own SPIR-V.
class Pipeline {
 public:
  static Pipeline compute(Device& device, const SharedSamplers& samplers, Spirv shader,
                          const Specialization& constants = {});
  // `fragment`: empty where depth and stencil alone are drawn; colour targets then keep what they have.
  static Pipeline raster(Device& device, const SharedSamplers& samplers, Spirv vertex, Spirv fragment,
                         const RasterState& state);
  ~Pipeline();
  Pipeline(Pipeline&& other) noexcept;
  Pipeline& operator=(Pipeline&&) = delete;

  [[nodiscard]] VkPipeline vk() const { return pipeline_; }
  [[nodiscard]] VkPipelineLayout layout() const { return layout_; }
  [[nodiscard]] VkPipelineBindPoint bind_point() const { return bind_point_; }
  [[nodiscard]] VkDescriptorSetLayout set_layout(std::uint32_t set) const { return set_layouts_[set]; }
  // The type of a binding, for whoever writes its descriptor. Precondition: the shaders use it, or it is ignored:
  // then nullopt.
  [[nodiscard]] std::optional<VkDescriptorType> binding_type(std::uint32_t set, std::uint32_t binding) const;
  // The set to bind as SharedSamplers::kSet; null where the shaders use none of them.
  [[nodiscard]] VkDescriptorSet shared_samplers() const { return shared_samplers_; }

 private:
  Pipeline(Device& device, VkPipelineBindPoint bind_point) : device_(&device), bind_point_(bind_point) {}
  void make_layout(std::span<const Reflection> shaders, VkShaderStageFlags stages, const SharedSamplers& samplers);

  Device* device_;
  VkPipelineBindPoint bind_point_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  std::array<VkDescriptorSetLayout, kMaxSets> set_layouts_{};  // that of the samplers is not owned
  VkDescriptorSet shared_samplers_ = VK_NULL_HANDLE;
  std::vector<ReflectedBinding> bindings_;
};

}  // namespace velarium::gpu
