#include "verbs.hpp"

#include "console.hpp"
#include "interrupt.hpp"
#include "parse.hpp"
#include "report.hpp"
#include "view_flags.hpp"

#include <velarium/velarium.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <memory>

namespace velarium::app {
namespace {

constexpr std::uint32_t kMostFrames = 100'000;

// What one scene took.
struct Measured {
  std::string scene;
  Phases phases;
  double wall_ms_per_frame = 0;
  RenderReport report;
};

class Bench {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  Measured measure(Engine& engine, const std::string& scene_name);
  RenderResult render(Engine& engine, const Scene& scene, std::uint32_t frames) const;
  [[nodiscard]] nlohmann::ordered_json json_of_all(const std::vector<Measured>& all) const;

  std::vector<std::string> scenes_;
  std::uint32_t frames_ = 16;  // a steady median in seconds, even on a software device
  std::uint32_t warm_up_ = 2;  // the first builds pipelines and uploads, the second fills histories
  std::filesystem::path json_;
  bool list_ = false;
  View view_;
  std::unique_ptr<Flags> flags_;
};

void Bench::declare(CLI::App& verb) {
  verb.add_option("SCENE", scenes_, "files or builtin:NAME [every built-in scene]");
  verb.add_flag("--list", list_, "print the names of the scenes, and measure nothing");
  flags_ = std::make_unique<Flags>(verb, view_.request.settings);
  flags_->add({"--frames", "N",
               fmt::format("frames measured a scene, the first excluded, instead of frame.spp [{}]", frames_),
               [this](const std::string& text) { frames_ = parse_count(text, 2, kMostFrames); }});
  flags_->add({"--warm-up", "N", fmt::format("frames rendered before [{}]", warm_up_),
               [this](const std::string& text) { warm_up_ = parse_count(text, 0, kMostFrames); }});
  flags_->add({"--json", "FILE|-", "write the figures as JSON", [this](const std::string& text) { json_ = text; }});
  add_view_flags(*flags_, view_);
  add_verbosity_flags(verb);
}

RenderResult Bench::render(Engine& engine, const Scene& scene, std::uint32_t frames) const {
  RenderRequest request = view_.request;
  request.settings.frame.spp = static_cast<int>(frames);
  request.want_linear = false;
  request.on_frame = [](std::uint32_t, std::uint32_t) { check_interrupt(); };
  return engine.render(scene, request);
}

Measured Bench::measure(Engine& engine, const std::string& scene_name) {
  Measured measured;
  measured.scene = scene_name;
  Stopwatch stopwatch;
  const Scene scene = Scene::load(scene_name, view_.load);
  measured.phases.emplace_back("load", stopwatch.lap_ms());
  if (warm_up_ > 0) (void)render(engine, scene, warm_up_);
  measured.phases.emplace_back("warm_up", stopwatch.lap_ms());
  measured.report = render(engine, scene, frames_).report;
  measured.wall_ms_per_frame = stopwatch.lap_ms() / frames_;
  return measured;
}

std::string table_of(const Measured& measured) {
  const RenderReport& report = measured.report;
  std::string text = fmt::format("\n{}\n", measured.scene);
  const auto row = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<32} {:>12}\n", name, value);
  };
  for (const PassTime& pass : report.passes) row(pass.name, fmt::format("{:.3f} ms", pass.ms));
  row("frame on the device", fmt::format("{:.3f} ms", report.frame_ms));
  row("frame by the clock", fmt::format("{:.3f} ms", measured.wall_ms_per_frame));
  row("device memory, peak", size_text(report.device_bytes));
  for (const auto& [phase, ms] : measured.phases) row(phase, time_text(ms));
  return text;
}

nlohmann::ordered_json Bench::json_of_all(const std::vector<Measured>& all) const {
  nlohmann::ordered_json scenes = nlohmann::ordered_json::array();
  for (const Measured& measured : all) {
    nlohmann::ordered_json scene{{"scene", measured.scene}};
    scene.update(json_of(measured.report));
    scene["wall_ms_per_frame"] = measured.wall_ms_per_frame;
    scene["phases"] = json_of(measured.phases);
    scenes.push_back(std::move(scene));
  }
  return {{"velarium", kVersion},
          {"width", view_.request.width},
          {"height", view_.request.height},
          {"frames", frames_},
          {"warm_up", warm_up_},
          {"scenes", std::move(scenes)},
          {"process_peak_bytes", peak_process_bytes()}};
}

void Bench::run() {
  if (scenes_.empty()) {
    for (const std::string& name : Scene::builtin_names()) scenes_.push_back("builtin:" + name);
  }
  if (list_) {
    for (const std::string& scene : scenes_) print(scene + "\n");
    return;
  }
  flags_->apply();
  finish_view(view_);
  if (!json_.empty() && json_ != "-") check_writable(json_);

  Engine engine(view_.engine);
  std::vector<Measured> all;
  for (const std::string& scene : scenes_) {
    check_interrupt();
    all.push_back(measure(engine, scene));
    if (all.size() == 1) say_note("device: " + all.front().report.device);
    if (json_ != "-") print(table_of(all.back()));
  }
  if (json_ != "-") print(fmt::format("\nprocess memory, peak: {}\n", size_text(peak_process_bytes())));
  if (!json_.empty()) write_json(json_, json_of_all(all));
}

}  // namespace

void add_bench(CLI::App& app) {
  const auto bench = std::make_shared<Bench>();
  bench->declare(add_verb(app, "bench", "measure passes, frames and memory", [bench] { bench->run(); }));
}

}  // namespace velarium::app
