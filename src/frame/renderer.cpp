#include "frame/renderer.hpp"

#include "bake/environment_brdf.hpp"
#include "bake/normal_lengths.hpp"
#include "core/huge_pages.hpp"
#include "frame/check_request.hpp"
#include "frame/dump.hpp"
#include "frame/timings.hpp"
#include "upload/transfer.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/gtc/packing.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::frame {
namespace {

// 512^2: a mean error of 0.040 degrees against 0.032 for four times the memory.
constexpr std::uint32_t kNormalTableSize = 512;
// The functions are smooth: 32^2 would do, 64^2 costs nothing.
constexpr std::uint32_t kBrdfTableSize = 64;
// Each doubling of frames lets textures be half a level sharper. Past four frames' worth they would alias.
constexpr float kMaxSharpening = 2.0f;

// Images of the frame that count as maps: what the blurred far map is drawn through, and the sun's mask.
constexpr std::array kFarSteps{"far_shadows.depth", "far_shadows_rows.moments"};
constexpr const char* kSunMask = "sun_mask.occlusion";

gpu::Image make_image(gpu::Device& device, const gpu::ImageDesc& desc, std::span<const std::byte> texels) {
  const std::array sources{upload::ImageSource{desc, texels}};
  return std::move(upload::make_images(device, sources).front());
}

gpu::Image make_brdf_table(gpu::Device& device, std::uint32_t model) {
  const auto values = bake::cached_environment_brdf(kBrdfTableSize, model);
  std::vector<std::uint32_t> packed;
  for (const auto& value : values)
    packed.push_back(glm::packHalf1x16(value.x) | std::uint32_t{glm::packHalf1x16(value.y)} << 16u);
  return make_image(device, {.format = VK_FORMAT_R16G16_SFLOAT, .width = kBrdfTableSize, .height = kBrdfTableSize},
                    std::as_bytes(std::span(packed)));
}

// Depth that nobody has written, in the layout of what is only read.
gpu::Image make_no_map(gpu::Device& device) {
  gpu::Image image(device, {.format = VK_FORMAT_D32_SFLOAT}, VK_IMAGE_USAGE_SAMPLED_BIT);
  image.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  const VkCommandBuffer commands = device.begin();
  gpu::record(commands, gpu::image_barrier(image, {}, upload::kSampledByShaders,
                                           {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}));
  device.submit_and_wait(commands);
  return image;
}

void note_lights_without_map(std::uint32_t lights, RenderReport& report) {
  if (lights > 0)
    report.notes.push_back(
        fmt::format("{} lights cast no shadow: local_shadows.atlas has no room for their maps, or "
                    "local_shadows.updates no time",
                    lights));
}

void note_reduced_map(const far_shadows::Map& map, RenderReport& report) {
  if (map.kind() != FarSun::off && map.is_reduced())
    report.notes.push_back(
        fmt::format("the map of sun_shadows.far={} has {} texels a side, as images of this device can have no more",
                    map.kind() == FarSun::vsm ? "vsm" : "static_map", map.map().size));
}

std::optional<std::array<float, 3>> background_color(const RenderRequest& request) {
  if (request.background != Background::color) return std::nullopt;
  return request.background_color;
}

// What of the frame does not change between the frames of a picture.
upload::FrameUniforms picture_uniforms(const Job& job, const upload::LightRanges& lights) {
  const auto& settings = job.request.settings;
  upload::FrameUniforms u{};
  const float turn = glm::radians(settings.environment.rotation);
  const bool shown = job.request.background == Background::environment && job.environment != nullptr;
  u.environment = {settings.environment.intensity, std::cos(turn), std::sin(turn), shown ? 1.0f : 0.0f};
  // Without an environment to show, the background of that name is black and opaque.
  if (job.request.background == Background::environment) u.background = {0.0f, 0.0f, 0.0f, 1.0f};
  if (job.environment != nullptr) std::copy(job.environment->sh.begin(), job.environment->sh.end(), u.sh);
  u.first_point = lights.first_point;
  u.first_spot = lights.first_spot;
  u.light_count = lights.count;
  u.sun_light = lights.sun;
  u.normal_variance = settings.specular_aa.baked ? 1.0f : 0.0f;
  u.seed = static_cast<std::uint32_t>(settings.frame.seed);
  return u;
}

}  // namespace

Renderer::Renderer(gpu::Toolbox& tools) : tools_(tools), executor_(tools) {
  const auto lengths = bake::cached_best_fit_normal_lengths(kNormalTableSize);
  normal_lengths_ = make_image(tools.device, {VK_FORMAT_R8_UNORM, kNormalTableSize, kNormalTableSize},
                               std::as_bytes(std::span(lengths)));
  const std::array<std::byte, 6 * 4> zeros{};
  black_ = make_image(tools.device, {VK_FORMAT_R8G8B8A8_UNORM}, std::span(zeros).first(4));
  black_cube_ = make_image(tools.device, {.format = VK_FORMAT_R8G8B8A8_UNORM, .layers = 6, .cube = true}, zeros);
  no_map_ = make_no_map(tools.device);
}

const gpu::Image& Renderer::brdf_table(ShadingModel model) {
  const std::uint32_t tabled = shading::environment_model(static_cast<std::uint32_t>(model));
  auto& table = brdf_tables_[tabled];
  if (!table) table = make_brdf_table(tools_.device, tabled);
  return table;
}

RenderResult Renderer::render(const Job& job) {
  const auto& request = job.request;
  check_request(request, tools_.device.caps().max_image_size);
  if (request.settings.lighting.path == LightingPath::volumes && !tools_.device.caps().blends_float32)
    throw Error(
        ErrorCode::unsupported,
        "this device cannot blend 32-bit floats, in which lighting.path=volumes adds light; lighting.path=tiled "
        "gives the same picture");
  const float aspect = static_cast<float>(request.width) / static_cast<float>(request.height);
  const auto view = upload::view_matrices(job.camera, aspect);
  auto scene = upload::make_scene_tables(tools_.device, job.scene, job.moment, view,
                                         static_cast<std::size_t>(request.settings.forward.sorted_triangles));
  scene.texture_lod_bias = -std::min(0.5f * std::log2(static_cast<float>(request.settings.frame.spp)), kMaxSharpening);

  const auto [settings, note] = fit_shadows(scene, view, request);
  const auto unshadowed = local_shadows::prepare(local_shadows_, tools_.device, scene,
                                                 {view, {request.width, request.height}}, settings.local_shadows);
  fit_sun_maps(scene, view, settings.sun_shadows);

  const gpu::ImageDesc sum_desc{VK_FORMAT_R32G32B32A32_SFLOAT, request.width, request.height};
  if (!sum_ || sum_.desc() != sum_desc)
    sum_ = gpu::Image(tools_.device, sum_desc,
                      VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  const bool lit = job.environment != nullptr;
  const passes::Environment environment{lit ? job.environment->background : black_,
                                        lit ? job.environment->specular : black_cube_,
                                        lit ? job.environment->irradiance : black_cube_,
                                        brdf_table(request.settings.lighting.model),
                                        request.settings.environment.diffuse,
                                        lit};
  const FrameInputs inputs{.scene = scene,
                           .environment = environment,
                           .normal_lengths = normal_lengths_,
                           .no_map = no_map_,
                           .local_shadows = local_shadows_,
                           .sun_maps = sun_maps_,
                           .far_map = far_map_,
                           .sum = sum_,
                           .width = request.width,
                           .height = request.height,
                           .settings = settings};
  RenderResult result;
  if (!note.empty()) result.report.notes.push_back(note);
  note_lights_without_map(unshadowed, result.report);
  note_reduced_map(far_map_, result.report);
  run_frames(job, inputs, picture_uniforms(job, scene.light_ranges), view, result.report);
  for (const auto& name : request.dumps) result.dumps.push_back(dump_image(tools_.device, executor_, name));
  read_picture(job, result);
  result.report.shadow_maps = shadow_maps();
  result.report.device_bytes = tools_.device.memory().peak_bytes();
  result.report.device = tools_.device.info().name;
  return result;
}

FittedShadows Renderer::fit_shadows(const upload::SceneTables& scene, const upload::ViewMatrices& view,
                                    const RenderRequest& request) {
  const auto needs =
      shadow_needs(scene, view, request.settings, std::uint64_t{request.width} * std::uint64_t{request.height});
  if (needs.far != FarSun::vsm)
    for (const char* name : kFarSteps) executor_.drop(name);
  if (needs.sun_maps == 0) executor_.drop(kSunMask);
  return fit_to_budget(request.settings, needs);
}

// As dumps name them. What has one texel stands for no map.
std::vector<MapMemory> Renderer::shadow_maps() {
  std::vector<MapMemory> maps;
  const auto add = [&maps](const char* name, std::uint64_t bytes) {
    if (bytes > 0) maps.push_back({name, bytes});
  };
  if (!sun_maps_.empty()) add("sun_shadows.cascades", sun_maps_.depths().bytes());
  add("sun_veils.cascades", sun_maps_.veils().bytes());
  add("far_shadows.map", far_map_.image().bytes());
  add("local_shadows.atlas", local_shadows_.atlas.bytes());
  add("local_veils.atlas", local_shadows_.veils.bytes());
  for (const char* name : kFarSteps) add(name, executor_.kept_bytes(name));
  add(kSunMask, executor_.kept_bytes(kSunMask));
  return maps;
}

void Renderer::fit_sun_maps(upload::SceneTables& scene, const upload::ViewMatrices& view,
                            const Settings::sun_shadows_settings& settings) {
  sun_maps_.fit(tools_.device, scene, view, settings);
  far_map_.fit(tools_.device, scene, view.eye, !sun_maps_.empty() && !sun_maps_.hold_scene(), settings);
  scene.sun_shadows =
      upload::make_buffer(tools_.device, std::vector{scene.host_sun_shadows}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

void Renderer::run_frames(const Job& job, const FrameInputs& inputs, upload::FrameUniforms uniforms,
                          const upload::ViewMatrices& view, RenderReport& report) {
  const auto& settings = job.request.settings;
  const auto count = static_cast<std::uint32_t>(settings.frame.spp);
  Timings timings;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec2 jitter = count == 1 ? glm::vec2(0.0f) : shading::pixel_jitter(i, count);
    upload::set_camera(uniforms, view, {inputs.width, inputs.height}, jitter);
    uniforms.frame_index = i;
    uniforms.rounding = shading::rounding_shift(i, count);
    inputs.scene.frame.mapped_as<upload::FrameUniforms>().front() = uniforms;

    FrameInputs frame = inputs;
    frame.first = i == 0;
    graph::Graph graph;
    add_frame(graph, frame);
    executor_.run(graph, settings.frame.sync == Sync::paranoid);
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
