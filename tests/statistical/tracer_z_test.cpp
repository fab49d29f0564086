// A scene without a closed form, against a mean and a variance that are stored: no change of the tracer may move its
// pictures by more than chance does [Subr & Arvo 2007, "Statistical hypothesis testing for assessing Monte Carlo
// estimators"]. The stored picture may be made again only where a change is meant to move it.

#include "statistical/tracer_scene.hpp"

#include "scene/builtin.hpp"
#include "upload/lights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace velarium::statistical {
namespace {

constexpr std::uint32_t kSize = 12;  // pixels a side, of the stored picture

struct Stored {
  double mean, variance;  // of a pixel
};

std::vector<Stored> stored_picture() {
  std::ifstream file(VELARIUM_TRACER_CORNELL);
  std::vector<Stored> pixels;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    Stored& pixel = pixels.emplace_back();
    std::istringstream(line) >> pixel.mean >> pixel.variance;
  }
  return pixels;
}

Tracing cornell() {
  Tracing t{.scene = scene::builtin_scene("cornell"), .camera = {}};
  const scene::SceneSnapshot snapshot = scene::snapshot_at(t.scene, 0.0f, "");
  t.camera = scene::choose_camera(snapshot, "", 1.0f);
  t.lights = upload::gpu_lights(snapshot.lights, glm::dvec3(t.camera.world_from_view[3]), {});
  t.settings.reference.spp = 2048;
  t.size = kSize;
  return t;
}

// In standard deviations.
struct Deviations {
  double pixel;    // the largest of all pixels
  double picture;  // of the sum of all pixels
};

// Of the picture, brightened by a factor, from the stored one.
Deviations deviations(const Traced& traced, double factor) {
  const std::vector<Stored> stored = stored_picture();
  const auto beauty = traced.film.beauty(), variance = traced.film.variance();
  EXPECT_EQ(stored.size(), beauty.size() / 4);
  double largest = 0.0, off_sum = 0.0, variance_sum = 0.0;
  for (std::size_t i = 0; i < std::min(stored.size(), beauty.size() / 4); ++i) {
    const double spread2 = stored[i].variance + factor * factor * static_cast<double>(variance[3 * i + 1]);
    const double off = factor * static_cast<double>(beauty[4 * i + 1]) - stored[i].mean;
    off_sum += off;
    variance_sum += spread2;
    constexpr double kDigits = 1e-6;  // of the stored values: what has no noise still is rounded
    largest = std::max(largest, std::abs(off) / std::max(std::sqrt(spread2), kDigits));
  }
  return {largest, std::abs(off_sum) / std::sqrt(variance_sum)};
}

// A right tracer exceeds each once in some 2500 seeds: 144 pixels at 4.7 standard deviations, one sum at 3.5.
constexpr double kPixel = 4.7, kPicture = 3.5;

TEST(TracerZTest, CornellBoxIsWhatItWas) {
  const Deviations found = deviations(cornell().run(), 1.0);
  EXPECT_LT(found.pixel, kPixel);
  EXPECT_LT(found.picture, kPicture);
}

TEST(TracerZTest, NoticesTwoPerCent) {
  const Traced traced = cornell().run();
  EXPECT_GT(deviations(traced, 1.02).picture, kPicture);
  EXPECT_GT(deviations(traced, 0.98).picture, kPicture);
}

}  // namespace
}  // namespace velarium::statistical
