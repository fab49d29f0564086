#include "results.hpp"

#include "api/display.hpp"

#include <velarium/files.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

// Enough for pictures that are looked at beside numbers: a strip of three takes some 30 kB.
constexpr int kQuality = 88;

// The linear picture as the program would show it.
Picture shown(const Picture& linear, const Row& row) {
  RenderRequest request = render_request(row);
  request.settings.display.dither = false;
  Picture picture = linear;
  api::display(picture, request);
  return picture;
}

Picture side_by_side(const std::vector<Picture>& pictures) {
  const std::uint32_t width = pictures.front().width, height = pictures.front().height;
  Picture strip{.width = width * static_cast<std::uint32_t>(pictures.size()), .height = height};
  for (std::uint32_t y = 0; y < height; ++y)
    for (const Picture& picture : pictures) {
      const auto line = picture.display.begin() + std::ptrdiff_t{4} * y * width;
      strip.display.insert(strip.display.end(), line, line + std::ptrdiff_t{4} * width);
    }
  return strip;
}

}  // namespace

fs::path results_folder() {
  const char* folder = std::getenv("VELARIUM_CONVERGENCE_OUT");
  return folder != nullptr ? fs::path(folder) : fs::current_path() / "convergence";
}

void write_results(const Row& row, const Picture& picture, const Picture& reference, const Comparison& comparison) {
  const fs::path folder = results_folder();
  fs::create_directories(folder);
  write_text(folder / (row.name + ".json"),
             fmt::format("{{\"flip\": {}, \"relmse\": {}}}\n", comparison.flip, comparison.relmse));
  Settings settings;
  settings.output.quality = kQuality;
  side_by_side({shown(picture, row), shown(reference, row), error_picture(comparison)})
      .save(folder / (row.name + ".jpg"), settings);
}

}  // namespace velarium::test
