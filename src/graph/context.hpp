#pragma once

#include "gpu/gpu_context.hpp"
#include "graph/graph.hpp"

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace velarium::graph {

struct ColorTarget {
  GraphImage image;    // one of its mips where it has several, all targets of one size
  bool clear = false;  // to zero; else loaded
};

// Part of the targets, pixels from their upper left corner.
struct Area {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

struct RenderTargets {
  std::vector<ColorTarget> colors;
  GraphImage depth;          // version 0: none
  bool clear_depth = false;  // to 0, the far plane of reversed-Z; stencil to 0
  bool depth_writable = true;
  std::uint32_t layer = 0;  // of all targets
};

class SetWriter;

// What a pass records with: its command buffer, and the images and buffers behind the handles.
class Context {
 public:
  Context(gpu::GpuContext& tools, VkCommandBuffer commands, std::span<gpu::Image* const> images,
          std::span<gpu::Buffer* const> buffers)
      : tools_(tools), commands_(commands), images_(images), buffers_(buffers) {}

  [[nodiscard]] gpu::GpuContext& tools() const { return tools_; }
  [[nodiscard]] VkCommandBuffer commands() const { return commands_; }
  [[nodiscard]] const gpu::Image& image(GraphImage handle) const { return *images_[handle.index]; }
  [[nodiscard]] const gpu::Buffer& buffer(GraphBuffer handle) const { return *buffers_[handle.index]; }

  // With the shared samplers (gpu/samplers.glsl) that its shaders use.
  void bind(const gpu::Pipeline& pipeline) const;
  // Collects and binds one descriptor set: c.set(p, 0).sampled(io::depth, depth).storage(io::out, out).bind();
  [[nodiscard]] SetWriter set(const gpu::Pipeline& pipeline, std::uint32_t set) const;
  void bind_set(const gpu::Pipeline& pipeline, std::uint32_t set, const gpu::Bindings& bindings) const;
  void push(const gpu::Pipeline& pipeline, std::span<const std::byte> bytes) const;
  template <class T>
  void push(const gpu::Pipeline& pipeline, const T& values) const {
    static_assert(sizeof(T) <= gpu::kPushConstantBytes);
    push(pipeline, std::as_bytes(std::span(&values, 1)));
  }
  // One thread a pixel of a width x height picture, in groups of group_x by group_y.
  void dispatch(std::uint32_t width, std::uint32_t height, std::uint32_t group_x, std::uint32_t group_y) const;
  // One thread a texel of a volume: c.dispatch({64, 64, 32}, {4, 4, 4}).
  void dispatch(VkExtent3D threads, VkExtent3D group) const;

  // Between these, draws go to the targets, with viewport and scissor set to their whole size.
  void begin_rendering(const RenderTargets& targets) const;
  // Draws go to this part alone, from here on.
  void set_area(const Area& area) const;
  // Clears the depth of this part to the far plane.
  void clear_depth(const Area& area) const;
  // Clears this part of the first colour target.
  void clear_color(const Area& area, const std::array<float, 4>& value) const;
  void end_rendering() const;

 private:
  gpu::GpuContext& tools_;
  VkCommandBuffer commands_;
  std::span<gpu::Image* const> images_;
  std::span<gpu::Buffer* const> buffers_;
};

// Fills the bindings of one descriptor set by the names that shaders know them by. A handle of version 0 binds the
// device's null resource of the slot's type: what it stands for is off, and specialisation keeps it from being read.
class SetWriter {
 public:
  SetWriter(const Context& context, const gpu::Pipeline& pipeline, std::uint32_t set)
      : context_(context), pipeline_(pipeline), set_(set) {}

  // The depth of a depth image, the colour of any other.
  SetWriter& sampled(const gpu::Slot& slot, GraphImage image);
  SetWriter& stencil(const gpu::Slot& slot, GraphImage image);
  SetWriter& storage(const gpu::Slot& slot, GraphImage image);
  SetWriter& buffer(const gpu::Slot& slot, GraphBuffer buffer);
  // Resources from outside the graph, ready to be read; a null image or buffer as a handle of version 0.
  SetWriter& sampled(const gpu::Slot& slot, const gpu::Image* image);
  SetWriter& sampled(const gpu::Slot& slot, const gpu::Image& image, const gpu::SamplerDesc& sampler);
  SetWriter& buffer(const gpu::Slot& slot, const gpu::Buffer& buffer);
  void bind();

 private:
  // Asserts that the slot is of this set.
  [[nodiscard]] const gpu::Slot& checked(const gpu::Slot& slot) const;
  const Context& context_;
  const gpu::Pipeline& pipeline_;
  std::uint32_t set_;
  gpu::Bindings bindings_;
};

}  // namespace velarium::graph
