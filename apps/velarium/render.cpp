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
#include <atomic>
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <utility>

namespace velarium::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultScene = "builtin:atrium";

// An engine that is made, and prepared for a picture, on a thread of its own. Where the scene fails meanwhile, its
// error is the one that is heard: nobody asks for the engine's.
class EngineAhead {
 public:
  // Where the system has no thread to give, the engine is made in get().
  EngineAhead(const EngineOptions& options, const RenderRequest& request)
      : engine_(std::async([this, options, request] {
          Engine engine(options);
          if (wanted_) engine.prepare(request);
          return engine;
        })) {}
  ~EngineAhead() { wanted_ = false; }
  EngineAhead(const EngineAhead&) = delete;
  EngineAhead& operator=(const EngineAhead&) = delete;

  [[nodiscard]] Engine get() { return engine_.get(); }

 private:
  std::atomic<bool> wanted_ = true;
  std::future<Engine> engine_;  // waits for its thread when it is destroyed
};

class Render {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  struct Dump {
    std::string image;  // "pass.image"
    fs::path file;
  };

  void check_outputs() const;
  [[nodiscard]] RenderRequest picture_request() const;
  RenderResult render_frames(Engine engine, const Scene& scene, RenderRequest request);
  void save_dumps(const std::vector<DumpedImage>& images) const;
  void write_timings(const RenderReport& report) const;
  void say_summary(const RenderReport& report) const;

  std::string scene_ = kDefaultScene;
  fs::path output_, timings_;
  std::vector<Dump> dumps_;
  ProgressStyle progress_ = parse_progress("auto");
  View view_;
  std::unique_ptr<Flags> flags_;
  Stopwatch total_, phase_;
  Phases phases_;
};

void Render::declare(CLI::App& verb) {
  verb.add_option("SCENE", scene_, fmt::format("a .gltf or .glb file, or builtin:NAME [{}]", kDefaultScene));
  flags_ = std::make_unique<Flags>(verb, view_.request.settings);
  flags_->add({"--output,-o", "FILE", "the picture: .png .jpg .webp .exr .hdr [the scene's name, .png]",
               [this](const std::string& text) { output_ = text; }});
  add_view_flags(*flags_, view_);
  flags_->add_option("--spp", "frame.spp", "N");
  flags_->add_option("--sync", "frame.sync");
  flags_->add({"--timings", "FILE|-", "write what each pass took, as JSON",
               [this](const std::string& text) { timings_ = text; }});
  flags_->add(
      {"--dump", "PASS.IMAGE=FILE", "save an image from inside the last frame", [this](const std::string& text) {
         const auto [image, file] = parse_pair(text);
         dumps_.push_back({image, file});
       }});
  flags_->add({"--progress", "auto|bar|plain|json|none", "how to say how far it is [auto]",
               [this](const std::string& text) { progress_ = parse_progress(text); }});
  add_verbosity_flags(verb);
}

void Render::run() {
  flags_->apply();
  finish_view(view_);
  if (output_.empty()) output_ = picture_name(scene_);
  check_outputs();

  const RenderRequest request = picture_request();
  EngineAhead ahead(view_.engine, request);
  const Scene scene = Scene::load(scene_, view_.load);
  for (const std::string& warning : scene.info().warnings) say_warning(warning);
  phases_.emplace_back("load", phase_.lap_ms());
  check_interrupt();

  Engine engine = ahead.get();
  phases_.emplace_back("device", phase_.lap_ms());
  check_interrupt();

  const RenderResult result = render_frames(std::move(engine), scene, request);
  for (const std::string& note : result.report.notes) say_note(note);
  result.picture.save(output_, view_.request.settings);
  save_dumps(result.dumps);
  phases_.emplace_back("save", phase_.lap_ms());
  if (!timings_.empty()) write_timings(result.report);
  say_summary(result.report);
}

void Render::check_outputs() const {
  const auto [width, height] = std::pair(view_.request.width, view_.request.height);
  Picture::check_destination(output_, width, height);
  for (const Dump& dump : dumps_) Picture::check_destination(dump.file, width, height);
  if (!timings_.empty() && timings_ != "-") check_writable(timings_);
}

RenderRequest Render::picture_request() const {
  RenderRequest request = view_.request;
  request.want_linear = Picture::stores_linear(output_);
  request.want_display = !request.want_linear;
  for (const Dump& dump : dumps_) request.dumps.push_back(dump.image);
  return request;
}

RenderResult Render::render_frames(Engine engine, const Scene& scene, RenderRequest request) {
  Progress progress(verbosity() == Verbosity::quiet ? ProgressStyle::none : progress_);
  request.on_frame = [&progress](std::uint32_t done, std::uint32_t of) {
    check_interrupt();
    progress.update(done, of);
  };
  RenderResult result = engine.render(scene, request);
  check_interrupt();
  phases_.emplace_back("render", phase_.lap_ms());
  return result;
}

void Render::save_dumps(const std::vector<DumpedImage>& images) const {
  Settings exact = view_.request.settings;
  exact.output.exr = ExrType::full;
  for (const Dump& dump : dumps_) {
    const auto image = std::find_if(images.begin(), images.end(), [&](const auto& i) { return i.name == dump.image; });
    if (image == images.end()) throw Error(ErrorCode::internal, "the engine left out the image " + dump.image);
    Picture picture{image->width, image->height, image->rgba, {}};
    // Formats of display values show what lies from 0 to 1, without a transfer function.
    for (const float value : image->rgba) {
      const float unit = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
      picture.display.push_back(static_cast<std::uint16_t>(std::lround(unit * 65535.0f)));
    }
    picture.save(dump.file, exact);
  }
}

void Render::write_timings(const RenderReport& report) const {
  nlohmann::ordered_json json = json_of(report);
  json["width"] = view_.request.width;
  json["height"] = view_.request.height;
  json["spp"] = view_.request.settings.frame.spp;
  json["phases"] = json_of(phases_);
  json["process_peak_bytes"] = peak_process_bytes();
  write_json(timings_, json);
}

void Render::say_summary(const RenderReport& report) const {
  if (verbosity() == Verbosity::quiet) return;
  double total_ms = 0;
  for (const auto& [name, ms] : phases_) total_ms += ms;
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(output_, unknown);
  const std::string text = fmt::format(
      "wrote {}: {} x {}, {}{} of {} in {} on {}\n", output_.string(), view_.request.width, view_.request.height,
      unknown ? "" : size_text(bytes) + ", ", report.frames == 1 ? "1 frame" : fmt::format("{} frames", report.frames),
      time_text(report.frame_ms), time_text(total_ms), report.device);
  // Standard output belongs to the timings where they go there.
  timings_ == "-" ? fmt::print(stderr, "{}", text) : print(text);
}

}  // namespace

void add_render(CLI::App& app) {
  const auto render = std::make_shared<Render>();
  render->declare(add_verb(app, "render", "draw a picture of a scene", [render] { render->run(); }));
}

}  // namespace velarium::app
