#include "passes/far_shadows/far_shadows.hpp"

#include "core/assert.hpp"
#include "graph/context.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::far_shadows {
namespace {

using graph::Access;

constexpr std::uint32_t kBlur[] =
#include "shaders/far_blur.comp.inc"
    ;
constexpr std::uint32_t kGroup = 8;

constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
// Each moment in a layer of its own, as every device can store to one channel of 32 bits. Half floats are too coarse: a
// square below 1/4 is rounded by 2^-14, hence a deviation of 2^-7 of what the map spans, 8 m of a kilometre, is noise.
constexpr VkFormat kMomentFormat = VK_FORMAT_R32_SFLOAT;
// With the depth that they are made of, and what is blurred along rows alone.
constexpr std::uint64_t kMomentBytes = 8 + 4 + 8;
constexpr VkFormat kStaticFormat = VK_FORMAT_D16_UNORM;
constexpr std::uint64_t kStaticBytes = 2;

// The deviation that rounding may feign, as a share of what the map spans: squares below 1/4 have steps of 2^-26, and a
// blur adds up some tens of them.
constexpr double kMomentRounding = 0x1p-12;
// A surface is not flat within a texel.
constexpr double kLeastDeviation = 0.5;  // texels
// The blur reaches as far as penumbrae of blockers of mean distance. Less than a texel would show texels, more than a
// few costs more than a smaller map.
constexpr double kMeanBlockerShare = 0.1;  // of the farthest distance
constexpr double kLeastBlur = 0.7, kMostBlur = 4.0;
// Deviations after which the bell curve is cut off, at a twentieth of its height.
constexpr double kBlurEnd = 2.5;

// As long as the last cascade of the talk, which is drawn for every eighth picture [Crytek 2011].
constexpr int kMomentPictures = 8;

// What a depth of 16 bits is rounded by when it is stored, and when it is compared: a step each at most.
constexpr double kDepthStep = 1.0 / 65535.0;
constexpr double kStaticSteps = 2.0;

constexpr double kSmallestSide = 1e-6;  // metres
// Space before and behind what a map sees, as a share of it, so that rounding cuts nothing off.
constexpr double kDepthGuard = 1e-3;

constexpr VkImageUsageFlags kRead = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

int blur_radius(double deviation) {
  return static_cast<int>(std::ceil(kBlurEnd * deviation));
}

constexpr std::size_t kMostTexels = 11;  // far_blur.comp.glsl
struct BlurPush {
  std::int32_t radius = 0;
  std::array<float, kMostTexels> weights{};
};

BlurPush blur_push(float deviation) {
  BlurPush push{.radius = blur_radius(static_cast<double>(deviation))};
  VEL_ASSERT(push.radius < static_cast<std::int32_t>(kMostTexels));
  float sum = 0.0f;
  for (std::int32_t i = -push.radius; i <= push.radius; ++i)
    sum += shading::blur_weight(static_cast<float>(i), deviation);
  for (std::int32_t i = 0; i <= push.radius; ++i)
    push.weights[static_cast<std::size_t>(i)] = shading::blur_weight(static_cast<float>(i), deviation) / sum;
  return push;
}

graph::GraphImage add_blur(graph::Graph& graph, graph::GraphImage source, graph::GraphImage target, bool columns,
                           float deviation) {
  auto& pass = graph.pass(columns ? "far_shadows_columns" : "far_shadows_rows");
  pass.read(source, Access::compute_sample);
  const auto blurred = pass.write(target, Access::compute_storage);
  const BlurPush push = blur_push(deviation);
  pass.run([=](graph::Context& c) {
    const auto& pipeline = c.tools().pipelines.compute(kBlur, {columns ? 1u : 0u});
    c.bind(pipeline);
    c.set(pipeline, 0).sampled(0, source).storage(1, blurred).bind();
    c.push(pipeline, push);
    const auto& size = c.image(blurred).desc();
    c.dispatch(size.width, size.height, kGroup, kGroup);
  });
  return blurred;
}

graph::GraphImage add_depth(graph::Graph& graph, const Inputs& in, graph::GraphImage target,
                            const passes::SunMapDraw& how, float slope_bias) {
  auto& pass = graph.pass("far_shadows");
  const auto depth = pass.write(target, Access::depth_attachment);
  pass.run([in, depth, how, slope_bias](graph::Context& c) {
    c.begin_rendering({.depth = depth, .clear_depth = true});
    // Away from the sun, which is towards 0: depth is reversed.
    vkCmdSetDepthBias(c.commands(), 0.0f, 0.0f, -slope_bias);
    passes::draw_sun_map(c, in.scene, in.map.map(), in.map.eye(), how);
    c.end_rendering();
  });
  return depth;
}

graph::GraphImage add_moments(graph::Graph& graph, const Inputs& in, graph::GraphImage moments) {
  const auto side = static_cast<std::uint32_t>(in.map.map().size);
  // No bias, as a plane's moments are its own.
  const auto depth =
      add_depth(graph, in, graph.image("depth", {.format = kDepthFormat, .width = side, .height = side, .array = true}),
                {.depth_format = kDepthFormat}, 0.0f);
  const auto half_blurred =
      graph.image("moments", {.format = kMomentFormat, .width = side, .height = side, .layers = 2, .array = true});
  const auto rows = add_blur(graph, depth, half_blurred, false, in.map.blur_deviation());
  return add_blur(graph, rows, moments, true, in.map.blur_deviation());
}

}  // namespace

passes::SunMap fit_to(const glm::dmat3& axes, const passes::LightBox& casters, int size, double guard) {
  const glm::dvec3 extent = casters.high - casters.low;
  passes::SunMap map{.axes = axes, .size = size};
  map.side = std::max({extent.x, extent.y, kSmallestSide}) * size / (size - 2.0 * guard);
  map.corner = 0.5 * (glm::dvec2(casters.low) + glm::dvec2(casters.high) - map.side);
  const double depth_guard = kDepthGuard * std::max(extent.z, map.side / size);
  map.z_near = casters.high.z + depth_guard;
  map.z_far = casters.low.z - depth_guard;
  return map;
}

std::uint64_t texel_bytes(FarSun kind) {
  if (kind == FarSun::off) return 0;
  return kind == FarSun::vsm ? kMomentBytes : kStaticBytes;
}

FarSun possible_kind(FarSun wanted, const upload::CasterTable& casters) {
  return wanted == FarSun::static_map && !upload::has_still(casters) ? FarSun::off : wanted;
}

int possible_size(int wanted, std::uint32_t largest_image) {
  while (static_cast<std::uint32_t>(wanted) > largest_image) wanted /= 2;
  return wanted;
}

void Map::allocate(gpu::Device& device, const gpu::ImageDesc& desc, VkImageUsageFlags usage) {
  if (image_ && image_.desc() == desc) return;
  stale_ = true;
  image_ = {};  // first: the old one and the new one need not fit beside each other
  image_ = gpu::Image(device, desc, usage | kRead);
}

void Map::keep_or_draw(const Contents& contents, bool may_keep) {
  stale_ = !may_keep || contents != contents_;
  age_ = stale_ ? 1 : age_ + 1;
  contents_ = contents;
}

void Map::fit_moments(gpu::Device& device, upload::SceneTables& scene, const Settings& settings) {
  const glm::dmat3 axes = passes::sun_axes(scene);
  const auto box = passes::light_box(axes, upload::bounds_of(scene.casters));
  wanted_size_ = settings.far_size;
  const int size = possible_size(wanted_size_, device.caps().max_image_size);
  const auto map = fit_to(axes, box, size, passes::kGuardTexels + blur_radius(kMostBlur));
  const double reach = passes::blocker_reach(box, static_cast<double>(settings.reach));
  const auto penumbra = passes::widest_penumbra(scene, settings.soft, kMeanBlockerShare * reach, 0.5 * map.side);
  // A disc's deviation along one axis is half its radius.
  const double blur = std::clamp(0.5 * penumbra.radius / map.texel(), kLeastBlur, kMostBlur);
  keep_or_draw({.scene_id = scene.gpu->id(), .map = map, .blur_deviation = static_cast<float>(blur)},
               settings.update == MapUpdate::staggered && age_ < kMomentPictures);
  auto& cascade = scene.host_sun_shadows.beyond;
  cascade = passes::gpu_cascade(map, eye_, penumbra);
  cascade.soft.w =
      static_cast<float>(std::max(kLeastDeviation * map.texel(), kMomentRounding * (map.z_near - map.z_far)));
  const auto side = static_cast<std::uint32_t>(size);
  allocate(device, {.format = kMomentFormat, .width = side, .height = side, .layers = 2, .array = true},
           VK_IMAGE_USAGE_STORAGE_BIT);
}

void Map::fit_static(gpu::Device& device, upload::SceneTables& scene, const Settings& settings) {
  const glm::dmat3 axes = passes::sun_axes(scene);
  const auto box = passes::light_box(axes, upload::bounds_of(scene.casters, upload::CasterChoice::still));
  wanted_size_ = settings.static_size;
  const int size = possible_size(wanted_size_, device.caps().max_image_size);
  const auto map = fit_to(axes, box, size, passes::kGuardTexels);
  keep_or_draw({.scene_id = scene.gpu->id(), .map = map, .slope_bias = settings.slope_bias},
               settings.update == MapUpdate::staggered);
  const double reach = passes::blocker_reach(box, static_cast<double>(settings.reach));
  auto& cascade = scene.host_sun_shadows.beyond;
  cascade = passes::gpu_cascade(map, eye_, passes::widest_penumbra(scene, settings.soft, reach, 0.5 * map.side));
  cascade.soft.w = static_cast<float>(kStaticSteps * kDepthStep * (map.z_near - map.z_far));
  const auto side = static_cast<std::uint32_t>(size);
  allocate(device, {.format = kStaticFormat, .width = side, .height = side, .array = true},
           VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

void Map::fit(gpu::Device& device, upload::SceneTables& scene, const glm::dvec3& eye, bool wanted,
              const Settings& settings) {
  const FarSun kind = wanted ? possible_kind(settings.far, scene.casters) : FarSun::off;
  if (settings.far == FarSun::off || (!wanted && settings.update == MapUpdate::all)) *this = Map();
  kind_ = kind;
  eye_ = eye;
  if (kind == FarSun::vsm) fit_moments(device, scene, settings);
  if (kind == FarSun::static_map) fit_static(device, scene, settings);
}

passes::FarSunMap add(graph::Graph& graph, const Inputs& in) {
  if (in.map.kind() == FarSun::off) return {};
  const bool draws = in.first && in.map.is_stale();
  // What is drawn is drawn whole, so that a new image counts as initialised.
  auto image = graph.import("far_shadows.map", in.map.image(), true);
  if (draws && in.map.kind() == FarSun::vsm) image = add_moments(graph, in, image);
  if (draws && in.map.kind() == FarSun::static_map)
    image = add_depth(graph, in, image, {.depth_format = kStaticFormat, .casters = upload::CasterChoice::still},
                      in.slope_bias);
  return {image, in.map.kind()};
}

}  // namespace velarium::far_shadows
