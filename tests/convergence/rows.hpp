#pragma once

// The table of convergence: what is rendered, against which reference, and how far it may be.

#include <velarium/compare.hpp>
#include <velarium/engine.hpp>
#include <velarium/reference.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace velarium::test {

// Distance of two pictures of linear light: HDR-FLIP, and the mean of (a - b)^2 / (b^2 + 0.01).
struct Errors {
  double flip = 0.0, relmse = 0.0;
};

// A row of budgets.csv.
struct Row {
  std::string name;
  std::string scene;  // "builtin:NAME", a file of tests/data, or "assets:" and a file of the folder VELARIUM_ASSETS
  std::string camera, environment;  // as RenderRequest has them; environments may be "assets:" files
  std::uint32_t width = 0, height = 0;
  std::string settings;            // KEY=VALUE, parted by spaces, of the renderer and the path tracer alike
  std::string transport, shadows;  // of the reference alone
  std::string reference;           // its name: rows of the same light share one
  Errors budget;
  std::string cause;  // of what is left
};

// A row of references.csv: what distance is expected of a perfect picture, because the reference has noise itself.
struct Noise {
  std::string name;           // of the reference
  std::uint32_t samples = 0;  // paths a pixel
  Errors errors;
};

// Throw Error(input_missing, input_invalid) where the table cannot be read.
[[nodiscard]] std::vector<Row> read_rows(const std::filesystem::path& file);
[[nodiscard]] std::vector<Noise> read_noise(const std::filesystem::path& file);

// Precondition: needs_assets() is false, or VELARIUM_ASSETS is set.
[[nodiscard]] Scene load_scene(const Row& row);
[[nodiscard]] RenderRequest render_request(const Row& row);
[[nodiscard]] ReferenceRequest reference_request(const Row& row);

// Whether the row shows files that are not in the repository.
[[nodiscard]] bool needs_assets(const Row& row);
[[nodiscard]] bool has_assets();

[[nodiscard]] std::filesystem::path reference_file(const std::string& name);
[[nodiscard]] Errors errors_of(const Picture& picture, const Picture& reference);

}  // namespace velarium::test
