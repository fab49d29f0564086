#include "rows.hpp"

#include "support/settings.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

// Frames of the renderer: their 16 places in a pixel leave less noise at edges than the references have.
constexpr int kFrames = 16;
constexpr std::string_view kAssets = "assets:";

using Fields = std::vector<std::string>;

// Commas inside double quotes belong to the field; there are no quotes inside quotes.
Fields fields_of(const std::string& line) {
  Fields fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

// The lines below the heading, `count` fields each.
std::vector<Fields> read_table(const fs::path& file, std::size_t count) {
  std::ifstream stream(file);
  if (!stream) throw Error(ErrorCode::input_missing, file, "the table of convergence cannot be opened");
  std::vector<Fields> table;
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number) {
    table.push_back(fields_of(line));
    if (table.back().size() != count)
      throw Error(ErrorCode::input_invalid, file,
                  fmt::format("line {} has {} fields, not {}", number, table.back().size(), count));
  }
  return table;
}

template <class Number>
Number number_of(const fs::path& file, const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  throw Error(ErrorCode::input_invalid, file, fmt::format("'{}' is no number", text));
}

fs::path assets() {
  const char* folder = std::getenv("VELARIUM_ASSETS");
  return folder != nullptr ? fs::path(folder) : fs::path();
}

std::string resolved(const std::string& name) {
  return name.starts_with(kAssets) ? (assets() / name.substr(kAssets.size())).string() : name;
}

}  // namespace

std::vector<Row> read_rows(const fs::path& file) {
  std::vector<Row> rows;
  for (const Fields& f : read_table(file, 13))
    rows.push_back({.name = f[0],
                    .scene = f[1],
                    .camera = f[2],
                    .environment = f[3],
                    .width = number_of<std::uint32_t>(file, f[4]),
                    .height = number_of<std::uint32_t>(file, f[5]),
                    .settings = f[6],
                    .transport = f[7],
                    .shadows = f[8],
                    .reference = f[9],
                    .budget = {number_of<double>(file, f[10]), number_of<double>(file, f[11])},
                    .cause = f[12]});
  return rows;
}

std::vector<Noise> read_noise(const fs::path& file) {
  std::vector<Noise> rows;
  for (const Fields& f : read_table(file, 4))
    rows.push_back({.name = f[0],
                    .samples = number_of<std::uint32_t>(file, f[1]),
                    .errors = {number_of<double>(file, f[2]), number_of<double>(file, f[3])}});
  return rows;
}

Scene load_scene(const Row& row) {
  const bool elsewhere = row.scene.starts_with("builtin:") || row.scene.starts_with(kAssets);
  return Scene::load(elsewhere ? fs::path(resolved(row.scene)) : fs::path(VELARIUM_TEST_DATA) / row.scene);
}

RenderRequest render_request(const Row& row) {
  RenderRequest request;
  request.width = row.width;
  request.height = row.height;
  request.camera = row.camera;
  request.environment = resolved(row.environment);
  request.want_display = false;
  request.settings.frame.spp = kFrames;
  set_options(request.settings, row.settings);
  return request;
}

ReferenceRequest reference_request(const Row& row) {
  ReferenceRequest request{.view = render_request(row)};
  set_option(request.view.settings, "reference.transport", row.transport);
  set_option(request.view.settings, "reference.shadows", row.shadows);
  return request;
}

bool needs_assets(const Row& row) {
  return row.scene.starts_with(kAssets) || row.environment.starts_with(kAssets);
}

bool has_assets() {
  return !assets().empty();
}

fs::path reference_file(const std::string& name) {
  return fs::path(VELARIUM_CONVERGENCE) / "references" / (name + ".exr");
}

Errors errors_of(const Picture& picture, const Picture& reference) {
  const Comparison comparison = compare(picture, reference);
  return {comparison.flip, comparison.relmse};
}

}  // namespace velarium::test
