#include "frame/renderer.hpp"

#include "core/huge_pages.hpp"
#include "frame/check_request.hpp"
#include "frame/dump.hpp"
#include "frame/timings.hpp"

#include <velarium/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace velarium::frame {
namespace {

// Each doubling of frames lets textures be half a level sharper. Past four frames' worth they would alias.
constexpr float kMaxSharpening = 2.0f;

std::optional<std::array<float, 3>> background_color(const RenderRequest& request) {
  if (request.background != Background::color) return std::nullopt;
  return request.background_color;
}

// Frame `index` of those that are averaged.
upload::FrameSample frame_sample(std::uint32_t index, const Settings::frame_settings& settings) {
  const auto count = static_cast<std::uint32_t>(settings.spp);
  return {.index = index,
          .seed = static_cast<std::uint32_t>(settings.seed),
          .jitter = count == 1 ? glm::vec2(0.0f) : shading::pixel_jitter(index, count),
          .rounding = shading::rounding_shift(index, count)};
}

upload::FrameSample last_sample(const Settings::frame_settings& settings) {
  return frame_sample(static_cast<std::uint32_t>(settings.spp) - 1, settings);
}

void check_device(const gpu::Device& device, const Settings& settings) {
  if (settings.lighting.path == LightingPath::volumes && !device.caps().blends_float32)
    throw Error(
        ErrorCode::unsupported,
        "this device cannot blend 32-bit floats, in which lighting.path=volumes adds light; lighting.path=tiled "
        "gives the same picture");
}

}  // namespace

Renderer::Renderer(gpu::GpuContext& tools, FrameRecipe recipe)
    : tools_(tools), recipe_(std::move(recipe)), executor_(tools), constants_(tools.device) {}

RenderResult Renderer::render(const Job& job) {
  const auto& request = job.request;
  check_request(request, tools_.device.caps().max_image_size);
  check_device(tools_.device, request.settings);
  fit_sum(request.width, request.height);
  const bool looks_back = recipe_.looks_back(request.settings);
  const Shot now = shoot(job, job.snapshot, job.camera);
  std::optional<Shot> earlier;
  if (looks_back && job.before) earlier = shoot(job, job.before->snapshot, job.before->camera);
  const Shot& before = earlier ? *earlier : now;
  const bool continues = job.before && job.before->key != 0 && job.before->key == last_key_;
  last_key_ = 0;  // until the picture is made
  if (looks_back && !continues) warm_up(job, before);

  RenderResult result;
  const auto prepared = prepare(state_, tools_.device, now.tables, now.view, request.settings);
  result.report.notes = prepared.notes;
  run_frames(job, inputs_of(job, now, before, prepared.settings), result.report);
  for (const auto& name : request.dumps) result.dumps.push_back(dump_image(tools_.device, executor_, name));
  read_picture(job, result);
  executor_.sweep();  // what earlier pictures needed and this one did not
  last_key_ = job.key;
  result.report.shadow_maps = shadow_maps(state_, executor_.images());
  result.report.device_bytes = tools_.device.memory().peak_bytes();
  result.report.device = tools_.device.info().name;
  return result;
}

Renderer::Shot Renderer::shoot(const Job& job, const scene::SceneSnapshot& snapshot,
                               const scene::CameraInstance& camera) {
  const auto& request = job.request;
  const float aspect = static_cast<float>(request.width) / static_cast<float>(request.height);
  const auto matrices = upload::view_matrices(camera, aspect);
  Shot shot{.tables = upload::make_tables(tools_.device, job.scene, snapshot, matrices.eye)};
  shot.tables.texture_quality.lod_bias =
      -std::min(0.5f * std::log2(static_cast<float>(request.settings.frame.spp)), kMaxSharpening);
  shot.view = upload::make_view(tools_.device, shot.tables, snapshot, matrices, {request.width, request.height},
                                static_cast<std::size_t>(request.settings.forward.sorted_triangles));
  return shot;
}

FrameInputs Renderer::inputs_of(const Job& job, const Shot& shot, const Shot& before, const Settings& settings) {
  return {.tables = shot.tables,
          .view = shot.view,
          .state = state_,
          .environment = job.environment,
          .brdf_table = constants_.brdf_table(settings.lighting.model),
          .normal_lengths = constants_.normal_lengths(),
          .sum = sum_,
          .before = {&before.tables, &before.view, last_sample(settings.frame)},
          .background = job.request.background,
          .settings = settings};
}

// As the last frame of the picture before would leave history. What it adds to the sum, the first frame replaces.
void Renderer::warm_up(const Job& job, const Shot& before) {
  executor_.forget_history();
  const auto prepared = prepare(state_, tools_.device, before.tables, before.view, job.request.settings);
  FrameInputs inputs = inputs_of(job, before, before, prepared.settings);
  inputs.sample = last_sample(prepared.settings.frame);
  run_frame(inputs, prepared.settings.frame.sync);
}

void Renderer::fit_sum(std::uint32_t width, std::uint32_t height) {
  const gpu::ImageDesc desc{VK_FORMAT_R32G32B32A32_SFLOAT, width, height};
  if (sum_ && sum_.desc() == desc) return;
  sum_ = gpu::Image(tools_.device, desc,
                    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
}

void Renderer::run_frame(const FrameInputs& inputs, Sync sync) {
  graph::Graph graph(executor_.history());
  recipe_.add(graph, inputs);
  executor_.run(graph, sync == Sync::paranoid);
}

void Renderer::run_frames(const Job& job, const FrameInputs& inputs, RenderReport& report) {
  const auto& settings = job.request.settings;
  const auto count = static_cast<std::uint32_t>(settings.frame.spp);
  Timings timings;
  for (std::uint32_t i = 0; i < count; ++i) {
    FrameInputs frame = inputs;
    frame.first = i == 0;
    frame.sample = frame_sample(i, settings.frame);
    if (i > 0) frame.before = {&inputs.tables, &inputs.view, frame_sample(i - 1, settings.frame)};
    run_frame(frame, settings.frame.sync);
    timings.add_frame(executor_.timings());
    if (i == 0) check_dump_names(executor_, job.request.dumps);
    if (job.request.on_frame) job.request.on_frame(i + 1, count);
  }
  timings.write(report);
}

void Renderer::read_picture(const Job& job, RenderResult& result) {
  const auto& request = job.request;
  graph::Graph graph;
  const auto out = add_display(graph, {.sum = sum_,
                                       .frames = static_cast<std::uint32_t>(request.settings.frame.spp),
                                       .settings = request.settings,
                                       .background = background_color(request),
                                       .want_linear = request.want_linear,
                                       .want_display = request.want_display});
  if (graph.passes().empty()) return;
  executor_.run(graph, request.settings.frame.sync == Sync::paranoid);
  for (const auto& pass : executor_.timings()) result.report.passes.push_back({pass.name, pass.ms});

  auto& picture = result.picture;
  picture.width = request.width;
  picture.height = request.height;
  picture.display_bits = request.settings.output.bits;
  const std::size_t values = std::size_t{4} * request.width * request.height;
  if (request.want_linear) {
    const auto mapped = executor_.buffer(out.linear).mapped_as<float>().first(values);
    reserve_on_huge_pages(picture.linear, values);
    picture.linear.assign(mapped.begin(), mapped.end());
  }
  if (request.want_display) {
    const auto mapped = executor_.buffer(out.display).mapped_as<std::uint16_t>().first(values);
    reserve_on_huge_pages(picture.display, values);
    picture.display.assign(mapped.begin(), mapped.end());
  }
}

}  // namespace velarium::frame
