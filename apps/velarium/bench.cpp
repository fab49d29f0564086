#include "verbs.hpp"

#include "bench_compare.hpp"
#include "bench_figures.hpp"
#include "bench_sweep.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "parse.hpp"
#include "report.hpp"
#include "view_flags.hpp"

#include <velarium/velarium.hpp>

#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace velarium::app {
namespace {

constexpr std::uint32_t kMostFrames = 100'000, kMostRounds = 1000;

// Measurements with a name, so that two of them are of the same things. "quick" takes under a minute on two cores.
struct Suite {
  const char* name;
  std::uint32_t width, height, frames, rounds;
  std::vector<const char*> scenes;
};

const std::array<Suite, 2> kSuites{{
    {"quick",
     640,
     360,
     6,
     2,
     {"builtin:atrium", "builtin:atrium?sun=off", "builtin:spheres", "builtin:knots", "builtin:terrain"}},
    {"full",
     1920,
     1080,
     16,
     3,
     {"builtin:atrium", "builtin:atrium?sun=off", "builtin:atrium?sun=off&lights=0",
      "builtin:atrium?sun=off&lights=256", "builtin:spheres", "builtin:cornell", "builtin:knots",
      "builtin:knots?instances=4096", "builtin:terrain", "builtin:terrain?triangles=2000000"}},
}};

class Bench {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  void add_measuring_flags();
  void settle_suite();
  void settle_scenes();
  void check() const;
  void measure_all();
  void measure(Engine& engine, std::size_t index);
  RenderReport render(Engine& engine, const Scene& scene, const SweepPoint& point, std::uint32_t frames,
                      std::vector<double>& clock_ms) const;
  void print_tables() const;
  void write_files() const;
  [[nodiscard]] std::vector<Growth> growth() const { return growth_of(points_, figures_); }

  std::vector<std::string> scenes_;
  std::uint32_t frames_ = 16;  // a steady median in seconds, even on a software device
  std::uint32_t warm_up_ = 2;  // the first builds pipelines and uploads, the second fills histories
  std::uint32_t rounds_ = 1;
  std::filesystem::path json_, csv_, compare_;
  std::optional<float> fail_above_;
  std::optional<SweepKind> sweep_;
  std::vector<std::uint32_t> sweep_values_;
  bool list_ = false;
  View view_;
  std::unique_ptr<Flags> flags_;

  std::vector<SweepPoint> points_;  // what is measured
  std::vector<Samples> samples_;    // parallel to points_
  std::vector<Figures> figures_;    // likewise
  std::vector<Figures> before_;
};

void Bench::declare(CLI::App& verb) {
  verb.add_option("SCENE", scenes_, "files or builtin:NAME, or a suite: quick, full [every built-in scene]");
  verb.add_flag("--list", list_, "print the names of the scenes, and measure nothing");
  flags_ = std::make_unique<Flags>(verb, view_.request.settings);
  add_measuring_flags();
  flags_->add({"--json", "FILE|-", "write the figures as JSON", [this](const std::string& text) { json_ = text; }});
  flags_->add({"--csv", "FILE|-", "write the table of a sweep", [this](const std::string& text) { csv_ = text; }});
  flags_->add({"--compare", "OLD.json", "print beside the figures of an earlier --json, and mark what is beyond noise",
               [this](const std::string& text) { compare_ = text; }});
  flags_->add({"--fail-above", "RATIO", "exit with 1 where something takes more than RATIO times what it took",
               [this](const std::string& text) { fail_above_ = parse_number(text); }});
  add_view_flags(*flags_, view_);
  add_verbosity_flags(verb);
}

void Bench::add_measuring_flags() {
  flags_->add({"--frames", "N", "frames a scene and round, the first not counted, instead of frame.spp [16]",
               [this](const std::string& text) { frames_ = parse_count(text, 2, kMostFrames); }});
  flags_->add({"--warm-up", "N", fmt::format("frames rendered before [{}]", warm_up_),
               [this](const std::string& text) { warm_up_ = parse_count(text, 0, kMostFrames); }});
  flags_->add({"--rounds", "N", "how often the scenes are measured in turn; medians are over all rounds [1]",
               [this](const std::string& text) { rounds_ = parse_count(text, 1, kMostRounds); }});
  flags_->add({"--sweep", "resolution|lights|triangles|instances|OPTION",
               "measure how times grow with one thing, or with the value of an option",
               [this](const std::string& text) { sweep_ = find_sweep(text); }});
  flags_->add({"--points", "N,N,...",
               "values of the sweep, of resolution the heights of the picture [4 or 5; of an option none]",
               [this](const std::string& text) { sweep_values_ = parse_sweep_points(text); }});
}

// A suite sets what flags then may change.
void Bench::settle_suite() {
  if (scenes_.size() != 1) return;
  for (const Suite& suite : kSuites) {
    if (scenes_.front() != suite.name) continue;
    view_.request.width = suite.width;
    view_.request.height = suite.height;
    frames_ = suite.frames;
    rounds_ = suite.rounds;
    scenes_.assign(suite.scenes.begin(), suite.scenes.end());
    return;
  }
}

void Bench::settle_scenes() {
  const std::uint32_t width = view_.request.width, height = view_.request.height;
  if (sweep_) {
    if (!scenes_.empty() && (sweep_->subject == SweepKind::Subject::scene || scenes_.size() > 1))
      throw Error(ErrorCode::usage,
                  "a sweep has a scene of its own; that of resolution or of an option takes one SCENE");
    if (sweep_->points.empty() && sweep_values_.empty())
      throw Error(ErrorCode::usage, "a sweep of an option needs --points");
    const std::string scene = scenes_.empty() ? "builtin:atrium" : scenes_.front();
    points_ = points_of(*sweep_, sweep_values_.empty() ? sweep_->points : sweep_values_, scene, width, height);
  } else {
    for (const std::string& scene : scenes_) points_.push_back({scene, width, height, 0.0});
  }
}

void Bench::check() const {
  if (!sweep_ && !sweep_values_.empty()) throw Error(ErrorCode::usage, "--points needs --sweep");
  if (!sweep_ && !csv_.empty()) throw Error(ErrorCode::usage, "--csv needs --sweep");
  if (fail_above_ && compare_.empty()) throw Error(ErrorCode::usage, "--fail-above needs --compare");
  if (json_ == "-" && csv_ == "-") throw Error(ErrorCode::usage, "--json and --csv cannot share standard output");
  for (const auto& file : {json_, csv_}) {
    if (!file.empty() && file != "-") check_writable(file);
  }
}

RenderReport Bench::render(Engine& engine, const Scene& scene, const SweepPoint& point, std::uint32_t frames,
                           std::vector<double>& clock_ms) const {
  RenderRequest request = view_.request;
  request.width = point.width;
  request.height = point.height;
  request.settings.frame.spp = static_cast<int>(frames);
  request.want_linear = false;
  if (!point.option.empty()) set_option(request.settings, point.option, fmt::format("{:.0f}", point.x));
  Stopwatch stopwatch;
  request.on_frame = [&](std::uint32_t done, std::uint32_t) {
    check_interrupt();
    const double ms = stopwatch.lap_ms();
    if (done > 1) clock_ms.push_back(ms);  // the first frame's also holds what is done once a picture
  };
  return engine.render(scene, request).report;
}

void Bench::measure(Engine& engine, std::size_t index) {
  const SweepPoint& point = points_[index];
  Phases phases;
  Stopwatch stopwatch;
  const Scene scene = Scene::load(point.scene, view_.load);
  phases.emplace_back("load", stopwatch.lap_ms());
  std::vector<double> unused, clock_ms;
  if (warm_up_ > 0) (void)render(engine, scene, point, warm_up_, unused);
  phases.emplace_back("warm_up", stopwatch.lap_ms());
  samples_[index].add(render(engine, scene, point, frames_, clock_ms), clock_ms);
  figures_[index] = samples_[index].figures();
  figures_[index].scene = point.scene;
  figures_[index].width = point.width;
  figures_[index].height = point.height;
  figures_[index].phases = std::move(phases);
}

void Bench::measure_all() {
  Engine engine(view_.engine);
  samples_.resize(points_.size());
  figures_.resize(points_.size());
  for (std::uint32_t round = 0; round < rounds_; ++round) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      check_interrupt();
      measure(engine, i);
      if (round == 0 && i == 0) say_note("device: " + figures_.front().device);
    }
  }
}

void Bench::print_tables() const {
  if (json_ == "-" || csv_ == "-") return;
  if (sweep_) {
    print(table_of(*sweep_, points_, growth()));
  } else {
    for (const Figures& figures : figures_) print(table_of(figures));
  }
  print(fmt::format("\nprocess memory, peak: {}\n", size_text(peak_process_bytes())));
}

void Bench::write_files() const {
  if (!csv_.empty()) {
    const std::string text = csv_of(points_, growth());
    csv_ == "-" ? print(text) : write_text(csv_, text);
  }
  if (json_.empty()) return;
  nlohmann::ordered_json json{{"velarium", kVersion}, {"frames", frames_}, {"warm_up", warm_up_}, {"rounds", rounds_}};
  for (const Figures& figures : figures_) json["scenes"].push_back(json_of(figures));
  if (sweep_) json["sweep"] = json_of(*sweep_, points_, growth());
  json["process_peak_bytes"] = peak_process_bytes();
  write_json(json_, json);
}

void Bench::run() {
  settle_suite();
  flags_->apply();
  finish_view(view_);
  if (scenes_.empty() && !sweep_) {
    for (const std::string& name : Scene::builtin_names()) scenes_.push_back("builtin:" + name);
  }
  settle_scenes();
  if (list_) {
    for (const SweepPoint& point : points_) print(point.scene + "\n");
    return;
  }
  check();
  if (!compare_.empty()) before_ = read_figures(compare_);

  measure_all();
  print_tables();
  write_files();
  if (compare_.empty()) return;
  const std::vector<Change> all = changes(before_, figures_);
  if (all.empty()) throw Error(ErrorCode::usage, compare_, "holds no scene at a size that was measured now");
  if (before_.front().device != figures_.front().device)
    say_warning("the earlier figures are of another device: " + before_.front().device);
  if (json_ != "-" && csv_ != "-") print(table_of(all));
  if (fail_above_) check_changes(all, *fail_above_);
}

}  // namespace

void add_bench(CLI::App& app) {
  const auto bench = std::make_shared<Bench>();
  bench->declare(add_verb(app, "bench", "measure passes, frames and memory", [bench] { bench->run(); }));
}

}  // namespace velarium::app
