#include <velarium/reference.hpp>

#include "api/display.hpp"
#include "api/view.hpp"
#include "bake/environment_brdf.hpp"
#include "frame/check_request.hpp"
#include "reference/tracer.hpp"
#include "scene/snapshot.hpp"
#include "upload/clip_volumes.hpp"
#include "upload/lights.hpp"
#include "upload/projectors.hpp"

#include <velarium/options.hpp>
#include <velarium/version.hpp>

#include <fmt/core.h>

#include <chrono>

namespace velarium {
namespace {

using Clock = std::chrono::steady_clock;

// As the renderer's pictures: the largest that image readers take.
constexpr std::uint32_t kLargestSide = 16384;
// As the renderer's table of the same values.
constexpr std::uint32_t kEnergyTableSize = 64;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<PictureLayer> layers_of(const reference::Film& film) {
  return {{"variance", {"R", "G", "B"}, film.variance(), true}, {"albedo", {"R", "G", "B"}, film.albedo()},
          {"normal", {"X", "Y", "Z"}, film.normal()},           {"depth", {"Z"}, film.depth(), true},
          {"direct", {"R", "G", "B"}, film.direct()},           {"indirect", {"R", "G", "B"}, film.indirect()}};
}

std::vector<std::pair<std::string, std::string>> attributes_of(const Scene& scene, const ReferenceRequest& request,
                                                               const ReferenceReport& report) {
  const Settings& s = request.view.settings;
  return {{"Software", fmt::format("velarium {}", kVersion)},
          {"velarium:scene", scene.info().source},
          {"velarium:samples", std::to_string(report.samples)},
          {"velarium:seed", std::to_string(s.frame.seed)},
          {"velarium:transport", get_option(s, "reference.transport")},
          {"velarium:shadows", get_option(s, "reference.shadows")},
          {"velarium:finished", report.finished ? "yes" : "no"}};
}

}  // namespace

ReferenceResult render_reference(const Scene& scene, const ReferenceRequest& request) {
  const auto start = Clock::now();
  const RenderRequest& view = request.view;
  frame::check_request(view, kLargestSide);
  ReferenceResult result;
  ReferenceReport& report = result.report;
  auto snapshot = scene::snapshot_at(scene.tables(), view.time_s, view.animation);
  const auto environment =
      api::environment_pixels(api::environment_choice(scene.tables(), snapshot, view, report.notes));
  api::set_lights(view, snapshot);
  const auto pictures = upload::projector_pictures(scene.tables());
  const auto projectors = upload::projector_layers(scene.tables(), pictures);
  const auto camera = api::camera_of(snapshot, view);
  const auto volumes = upload::make_clip_volumes(scene.tables(), snapshot, glm::dvec3(camera.world_from_view[3]));
  const auto model = static_cast<std::uint32_t>(view.settings.lighting.model);
  const auto energy = bake::cached_environment_brdf(kEnergyTableSize, shading::environment_model(model));
  const reference::Job job{
      .scene = scene.tables(),
      .snapshot = snapshot,
      .camera = camera,
      .lights = upload::gpu_lights(snapshot.lights, glm::dvec3(camera.world_from_view[3]), pictures),
      .clip_records = volumes.records,
      .projectors = projectors,
      .environment = environment ? &*environment : nullptr,
      .energy = energy,
      .energy_size = kEnergyTableSize,
      .width = view.width,
      .height = view.height,
      .background = view.background == Background::environment,
      .opaque_background = view.background == Background::environment,
      .settings = view.settings,
      .on_progress = [&](const reference::Progress& p) {
        return !request.on_progress || request.on_progress({p.share, p.elapsed_s});
      }};
  const reference::Result traced = reference::trace(job);
  const reference::Film& film = traced.film;
  report.notes.insert(report.notes.end(), traced.notes.begin(), traced.notes.end());
  report.finished = traced.finished;
  report.seconds = traced.seconds;
  report.prepare_seconds = seconds_since(start) - traced.seconds;
  report.paths = traced.paths;
  report.samples = film.finished_samples();
  report.threads = traced.threads;
  report.relative_error = film.relative_error();
  result.picture.width = view.width;
  result.picture.height = view.height;
  result.picture.linear = film.beauty();
  result.picture.attributes = attributes_of(scene, request, report);
  if (view.want_display) api::display(result.picture, view);
  if (view.want_linear) result.picture.layers = layers_of(film);
  return result;
}

}  // namespace velarium
