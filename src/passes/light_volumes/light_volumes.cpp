#include "passes/light_volumes/light_volumes.hpp"

#include "passes/light_volumes/plan.hpp"

#include "upload/io.hpp"

#include <algorithm>

namespace velarium::light_volumes {
namespace {

namespace own {
using namespace shading;
#include "passes/light_volumes/light_volumes_io.glsl"
}  // namespace own

static_assert(static_cast<std::uint32_t>(Shape::screen) == own::kShapeScreen);
static_assert(static_cast<std::uint32_t>(Shape::quad) == own::kShapeQuad);
static_assert(static_cast<std::uint32_t>(Shape::sphere) == own::kShapeSphere);
static_assert(static_cast<std::uint32_t>(Shape::cone) == own::kShapeCone);

using graph::Access;

constexpr std::uint32_t kVertex[] =
#include "shaders/passes/light_volumes/light_volume.vert.inc"
    ;
constexpr std::uint32_t kFragment[] =
#include "shaders/passes/light_volumes/light_volume.frag.inc"
    ;

// Each light is added to this sum, and the sum to the picture once: in half floats every addition would round.
constexpr VkFormat kSumFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

bool is_body(Shape shape) {
  return shape == Shape::sphere || shape == Shape::cone;
}

gpu::RasterState mark_state(VkFormat depth_format) {
  return {.color_formats = {kSumFormat},
          .depth_format = depth_format,
          .depth_write = false,
          .depth_clamp = true,
          .stencil = gpu::Stencil::enclose};
}

// Strictly behind the surface, so that what lies at infinity covers no sky.
gpu::RasterState shade_state(VkFormat depth_format, const Inputs& in, const VolumeDraw& draw) {
  const bool body = is_body(draw.shape) && !draw.marked;
  auto constants = passes::specialization(in.illumination);
  constants.set(own::kKind, draw.kind);
  return {.topology = body ? VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
          .color_formats = {kSumFormat},
          .depth_format = depth_format,
          .depth_compare = VK_COMPARE_OP_LESS,
          .depth_write = false,
          .depth_clamp = body,
          .stencil = draw.marked ? gpu::Stencil::consume : gpu::Stencil::none,
          .blend = gpu::Blend::add,
          .fragment_constants = constants};
}

std::uint32_t vertex_count(Shape shape) {
  if (shape == Shape::sphere) return shading::kSphereVertices;
  return shape == Shape::cone ? shading::kConeVertices : 4;
}

// Records the draws of one frame.
class Recorder {
 public:
  Recorder(graph::Context& context, const Inputs& in, VkFormat depth_format)
      : c_(context), in_(in), depth_format_(depth_format) {
    vkCmdSetFrontFace(c_.commands(), VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdSetStencilReference(c_.commands(), VK_STENCIL_FACE_FRONT_AND_BACK, 0);
  }

  void draw(const VolumeDraw& draw) {
    if (draw.marked) {
      bind(c_.tools().pipelines.raster(kVertex, {}, mark_state(depth_format_)));
      record(draw.shape, VK_CULL_MODE_NONE, draw);
    }
    bind(c_.tools().pipelines.raster(kVertex, kFragment, shade_state(depth_format_, in_, draw)));
    const bool body = is_body(draw.shape) && !draw.marked;
    // The far sides: they are there wherever the eye is.
    record(draw.marked ? Shape::screen : draw.shape, body ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_NONE, draw);
  }

 private:
  void bind(const gpu::Pipeline& pipeline) {
    if (&pipeline == bound_) return;
    bound_ = &pipeline;
    c_.bind(pipeline);
    auto set = c_.set(pipeline, 0);
    set.buffer(upload::io::FrameBuffer, in_.illumination.scene.frame_buffer)
        .buffer(own::BoundsBuffer, in_.illumination.scene.view.light_bounds_buffer);
    gbuffer::bind(set, in_.gbuffer);
    set.bind();
    auto shared = c_.set(pipeline, 1);
    passes::bind(shared, in_.illumination);
    shared.bind();
  }

  void record(Shape shape, VkCullModeFlags cull, const VolumeDraw& draw) {
    vkCmdSetCullMode(c_.commands(), cull);
    c_.push(*bound_, own::VolumePush{static_cast<std::uint32_t>(shape)});
    vkCmdDraw(c_.commands(), vertex_count(shape), draw.light_count, 0, draw.first_light);
  }

  graph::Context& c_;
  const Inputs& in_;
  VkFormat depth_format_;
  const gpu::Pipeline* bound_ = nullptr;
};

// Shading samples depth and class, so that marks need another stencil, and with it another depth.
graph::GraphImage copy_depth(graph::Graph& graph, graph::GraphImage depth) {
  auto& pass = graph.pass("light_volume_depth");
  pass.read(depth, Access::transfer_read);
  const auto copy = pass.write(graph.image("depth", graph.desc(depth)), Access::transfer_write);
  pass.run([depth, copy](graph::Context& c) {
    const auto& desc = c.image(depth).desc();
    const VkImageSubresourceLayers layers{VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, 1};
    const VkImageCopy region{
        .srcSubresource = layers, .dstSubresource = layers, .extent = {desc.width, desc.height, 1}};
    vkCmdCopyImage(c.commands(), c.image(depth).vk(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, c.image(copy).vk(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  });
  return copy;
}

void clear_marks(const graph::Context& c, const gpu::ImageDesc& size) {
  const VkClearAttachment clear{.aspectMask = VK_IMAGE_ASPECT_STENCIL_BIT};
  const VkClearRect where{{{0, 0}, {size.width, size.height}}, 0, 1};
  vkCmdClearAttachments(c.commands(), 1, &clear, 1, &where);
}

}  // namespace

graph::GraphImage add(graph::Graph& graph, const Inputs& in) {
  const auto& scene = in.illumination.scene;
  const auto draws = plan(scene.tables.lights, scene.view.light_bounds, scene.frame);
  if (draws.empty()) return {};
  const bool marks = std::any_of(draws.begin(), draws.end(), [](const VolumeDraw& draw) { return draw.marked; });
  auto tested = in.gbuffer.depth;
  if (marks) tested = copy_depth(graph, in.gbuffer.depth);
  auto& pass = graph.pass("light_volumes");
  gbuffer::declare(pass, in.gbuffer, Access::fragment_sample);
  passes::declare(pass, in.illumination, Access::fragment_sample);
  if (marks)
    tested = pass.write(tested, Access::depth_attachment);
  else
    pass.read(tested, Access::depth_test);
  const auto size = graph.desc(in.gbuffer.depth);
  const auto sum = pass.write(graph.image("sum", {.format = kSumFormat, .width = size.width, .height = size.height}),
                              Access::color_attachment);
  pass.run([in, draws, marks, tested, sum, size](graph::Context& c) {
    c.begin_rendering({.colors = {{sum, true}}, .depth = tested, .depth_writable = marks});
    if (marks) clear_marks(c, size);
    Recorder recorder(c, in, size.format);
    for (const auto& draw : draws) recorder.draw(draw);
    c.end_rendering();
  });
  return sum;
}

}  // namespace velarium::light_volumes
