#include "verbs.hpp"

#include "compare_report.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "parse.hpp"
#include "report.hpp"
#include "view_flags.hpp"

#include <velarium/velarium.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace velarium::app {
namespace {

namespace fs = std::filesystem;

// In full precision: a share of 0.01 is within a threshold of 0.01.
double parse_threshold(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || std::isnan(value))
    throw Error(ErrorCode::usage, fmt::format("'{}' is not a number", text));
  return value;
}

PixelRegion parse_region(std::string_view text) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  std::array<std::uint32_t, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = text.find(',');
    const bool last = i + 1 == numbers.size();
    if (last != (comma == std::string_view::npos))
      throw Error(ErrorCode::usage, "four numbers X,Y,WIDTH,HEIGHT in pixels are expected");
    numbers[i] = parse_count(text.substr(0, comma), i < 2 ? 0 : 1, kMost);
    text.remove_prefix(last ? text.size() : comma + 1);
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::string metric_names() {
  std::vector<std::string_view> names;
  for (const MetricInfo& info : metric_table()) names.push_back(info.name);
  return fmt::format("{}", fmt::join(names, "|"));
}

class Compare {
 public:
  void declare(CLI::App& verb);
  void run();

 private:
  void check_outputs() const;
  void write_outputs(const Picture& picture, const Picture& reference, const Comparison& comparison) const;

  std::string layer_;
  fs::path mask_, error_map_, html_, json_;
  Decision decision_;
  std::optional<double> threshold_;
  CompareOptions options_;  // its names are those of the files
};

void Compare::declare(CLI::App& verb) {
  using Set = std::function<void(const std::string&)>;
  const auto add = [&verb](const std::string& name, const std::string& value, const std::string& help, const Set& set) {
    const auto named = [name, set](const std::string& text) {
      try {
        set(text);
      } catch (const Error& error) { throw Error(error.code(), fmt::format("{}: {}", name, error.what())); }
    };
    verb.add_option_function<std::string>(name, named, help)->type_name(value);
  };
  verb.add_option("PICTURE", options_.name, "a .png, .jpg, .webp, .exr or .hdr file, told by its content")
      ->type_name("FILE")
      ->required();
  verb.add_option("REFERENCE", options_.reference_name, "what it should be, of the same size")
      ->type_name("FILE")
      ->required();
  add("--metric", metric_names(), "which number decides [flip]",
      [this](const std::string& text) { decision_.metric = parse_metric(text); });
  add("--threshold", "X", "the worst value that is accepted [that of equal pictures]",
      [this](const std::string& text) { threshold_ = parse_threshold(text); });
  add("--tolerance", "X", "difference of a channel up to which a pixel does not count for `share`, from 0 [2/255]",
      [this](const std::string& text) { options_.tolerance = parse_number(text); });
  add("--crop", "X,Y,W,H", "compare this part alone, in pixels from the top left",
      [this](const std::string& text) { options_.crop = parse_region(text); });
  add("--mask", "FILE", "a picture of the same size: pixels lighter than half grey count",
      [this](const std::string& text) { mask_ = text; });
  add("--layer", "NAME", "part or layer of OpenEXR files [the first]",
      [this](const std::string& text) { layer_ = text; });
  verb.add_flag("--display", options_.as_display, "compare display values even of .exr and .hdr");
  add("--exposure", "STOPS", "multiplies linear light by 2^stops where it is shown or compared as display values [0]",
      [this](const std::string& text) { options_.exposure = parse_number(text); });
  add("--pixels-per-degree", "N", "of the observer for FLIP [67.02: a 4K display as wide as it is far]",
      [this](const std::string& text) { options_.pixels_per_degree = parse_number(text); });
  add("--error-map", "FILE", "save FLIP of each pixel: .png in colours, .exr as numbers",
      [this](const std::string& text) { error_map_ = text; });
  add("--json", "FILE|-", "write the numbers as JSON", [this](const std::string& text) { json_ = text; });
  add("--html", "FILE", "write a page with both pictures under a divider, the error map and the numbers",
      [this](const std::string& text) { html_ = text; });
  add_verbosity_flags(verb);
}

void Compare::check_outputs() const {
  if (!error_map_.empty()) Picture::check_destination(error_map_);
  if (!html_.empty()) check_writable(html_);
  if (!json_.empty() && json_ != "-") check_writable(json_);
}

void Compare::write_outputs(const Picture& picture, const Picture& reference, const Comparison& comparison) const {
  if (!error_map_.empty()) {
    Settings exact;
    exact.output.exr = ExrType::full;
    error_picture(comparison).save(error_map_, exact);
  }
  if (!html_.empty()) {
    write_text(html_, comparison_page(picture, reference, comparison, options_, decision_.metric, decision_.threshold));
  }
  if (!json_.empty()) write_json(json_, json_of(comparison, options_, decision_));
  if (json_ != "-" && verbosity() != Verbosity::quiet) print(text_of(comparison, options_, decision_));
}

void Compare::run() {
  decision_.threshold = threshold_.value_or(info_of(decision_.metric).best);
  check_outputs();
  const Picture picture = load_picture(options_.name, layer_);
  const Picture reference = load_picture(options_.reference_name, layer_);
  if (!mask_.empty()) options_.mask = load_picture(mask_);
  check_interrupt();

  const Comparison comparison = compare(picture, reference, options_);
  check_interrupt();
  for (const std::string& note : comparison.notes) say_note(note);
  write_outputs(picture, reference, comparison);
  const std::string verdict = verdict_of(comparison, decision_);
  if (!comparison.within(decision_.metric, decision_.threshold))
    throw Error(ErrorCode::comparison_differs, options_.name, fmt::format("{} ({})", verdict, options_.reference_name));
  if (verbosity() == Verbosity::verbose) say_note(verdict);
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto verb = std::make_shared<Compare>();
  verb->declare(
      add_verb(app, "compare", "tell how far a picture is from a reference; needs no GPU", [verb] { verb->run(); }));
}

}  // namespace velarium::app
