#include "verbs.hpp"

#include "console.hpp"
#include "interrupt.hpp"
#include "parse.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "view_flags.hpp"

#include <velarium/velarium.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace velarium::app {
namespace {

namespace fs = std::filesystem;

std::string counted(std::uint32_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

class Reference {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  void add_reference_flags();
  ReferenceResult trace(const Scene& scene);
  void write_timings(const ReferenceReport& report) const;
  void say_summary(const ReferenceReport& report) const;

  std::string scene_;
  fs::path output_, timings_;
  ProgressStyle progress_ = parse_progress("auto");
  View view_;
  std::unique_ptr<Flags> flags_;
};

void Reference::declare(CLI::App& verb) {
  verb.add_option("SCENE", scene_, "a .gltf or .glb file, or builtin:NAME")->required();
  flags_ = std::make_unique<Flags>(verb, view_.request.settings);
  flags_->add({"--output,-o", "FILE",
               "the picture: .exr with all its parts, .png .jpg .webp .hdr [the scene's name, .png]",
               [this](const std::string& text) { output_ = text; }});
  add_view_flags(*flags_, view_);
  add_reference_flags();
  flags_->add(
      {"--timings", "FILE|-", "write what it took, as JSON", [this](const std::string& text) { timings_ = text; }});
  flags_->add({"--progress", "auto|bar|plain|json|none", "how to say how far it is [auto]",
               [this](const std::string& text) { progress_ = parse_progress(text); }});
  add_verbosity_flags(verb);
}

void Reference::add_reference_flags() {
  flags_->add_option("--spp", "reference.spp", "N");
  flags_->add_option("--time-limit", "reference.time_limit", "SECONDS");
  flags_->add_option("--noise", "reference.noise", "X");
  flags_->add_option("--seed", "frame.seed", "N");
  flags_->add_option("--max-bounces", "reference.max_bounces", "N");
  flags_->add({"--transport", "direct|direct+env|one-bounce|full", option_help("reference.transport"),
               [this](std::string text) {
                 std::replace_if(
                     text.begin(), text.end(), [](char c) { return c == '+' || c == '-'; }, '_');
                 set_option(view_.request.settings, "reference.transport", text);
               }});
  flags_->add_option("--shadows", "reference.shadows", "on|off");
  flags_->add_option("--emissive-lighting", "reference.emissive_lighting", "on|off");
  flags_->add({"--glow", "on|off", "the old name of --emissive-lighting, until 0.2",
               [this](const std::string& text) { set_option(view_.request.settings, "reference.glow", text); }});
  flags_->add_option("--threads", "reference.threads", "N");
}

void Reference::run() {
  flags_->apply();
  finish_view(view_);
  if (output_.empty()) output_ = picture_name(scene_);
  Picture::check_destination(output_, view_.request.width, view_.request.height);
  if (!timings_.empty() && timings_ != "-") check_writable(timings_);

  const Scene scene = Scene::load(scene_, view_.load);
  for (const std::string& warning : scene.info().warnings) say_warning(warning);
  check_interrupt();

  const ReferenceResult result = trace(scene);
  for (const std::string& note : result.report.notes) say_note(note);
  result.picture.save(output_, view_.request.settings);
  if (!timings_.empty()) write_timings(result.report);
  say_summary(result.report);
  if (!result.report.finished) throw Interrupted{take_interrupt(), "what there was is written, marked as unfinished"};
}

ReferenceResult Reference::trace(const Scene& scene) {
  ReferenceRequest request{.view = view_.request};
  request.view.want_linear = Picture::stores_linear(output_);
  request.view.want_display = !request.view.want_linear;
  Progress progress(verbosity() == Verbosity::quiet ? ProgressStyle::none : progress_);
  request.on_progress = [&progress](const ReferenceProgress& p) {
    progress.update(p.share);
    return take_interrupt() == 0;
  };
  ReferenceResult result = render_reference(scene, request);
  if (result.report.finished)
    progress.update(1.0);  // limits may have ended it early, or it was over before it was asked
  return result;
}

void Reference::write_timings(const ReferenceReport& report) const {
  nlohmann::ordered_json json;
  json["width"] = view_.request.width;
  json["height"] = view_.request.height;
  json["finished"] = report.finished;
  json["samples"] = report.samples;
  json["paths"] = report.paths;
  json["threads"] = report.threads;
  json["seconds"] = report.seconds;
  json["prepare_seconds"] = report.prepare_seconds;
  json["paths_per_second"] = report.seconds > 0.0 ? static_cast<double>(report.paths) / report.seconds : 0.0;
  json["relative_error"] = report.relative_error;
  json["process_peak_bytes"] = peak_process_bytes();
  write_json(timings_, json);
}

void Reference::say_summary(const ReferenceReport& report) const {
  if (verbosity() == Verbosity::quiet) return;
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(output_, unknown);
  const double rate = report.seconds > 0.0 ? 1e-6 * static_cast<double>(report.paths) / report.seconds : 0.0;
  const std::string error =
      std::isfinite(report.relative_error) ? fmt::format(", error about {:.2g} %", 100.0 * report.relative_error) : "";
  const std::string text = fmt::format(
      "wrote {}: {} x {}, {}{} in {}, {:.2f} million a second on {}{}\n", output_.string(), view_.request.width,
      view_.request.height, unknown ? "" : size_text(bytes) + ", ", counted(report.samples, "path") + " a pixel",
      time_text(1e3 * report.seconds), rate, counted(report.threads, "thread"), error);
  // Standard output belongs to the timings where they go there.
  timings_ == "-" ? fmt::print(stderr, "{}", text) : print(text);
}

}  // namespace

void add_reference(CLI::App& app) {
  const auto reference = std::make_shared<Reference>();
  reference->declare(add_verb(app, "reference", "trace the picture that light itself would make of a scene",
                              [reference] { reference->run(); }));
}

}  // namespace velarium::app
