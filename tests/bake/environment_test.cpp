// The baked environment on a device, against what is known of it and against integrals on the CPU.

#include "support/device_choice.hpp"

#include "bake/environment.hpp"
#include "bake/environment_transfer.hpp"
#include "bake/studio.hpp"
#include "core/files.hpp"
#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <velarium/error.hpp>

#include <glm/gtc/packing.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>
#include <unistd.h>

namespace velarium::bake {
namespace {

using glm::vec3;

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kFaceSize = 256;
constexpr std::uint32_t kPlusX = 0, kMinusX = 1, kPlusY = 2, kMinusY = 3, kPlusZ = 4, kMinusZ = 5;

// The specular cube on the host.
class Cube {
 public:
  explicit Cube(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] static std::uint32_t size(std::uint32_t level) { return kFaceSize >> level; }
  [[nodiscard]] vec3 at(std::uint32_t level, std::uint32_t face, std::uint32_t x, std::uint32_t y) const {
    std::size_t texel = (std::size_t{face} * size(level) + y) * size(level) + x;
    for (std::uint32_t i = 0; i < level; ++i) texel += std::size_t{6} * size(i) * size(i);
    return vec3(glm::unpackHalf4x16(reinterpret_cast<const std::uint64_t*>(bytes_.data())[texel]));
  }
  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

vec3 texel_direction(std::uint32_t level, std::uint32_t face, std::uint32_t x, std::uint32_t y) {
  const auto size = static_cast<float>(Cube::size(level));
  return shading::cube_direction(face, {(static_cast<float>(x) + 0.5f) / size, (static_cast<float>(y) + 0.5f) / size});
}

// Exact: the corner at (x, y) of a face [-1, 1]^2 at distance 1 sees this much from its middle.
double corner_solid_angle(double x, double y) {
  return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
}

double texel_solid_angle(std::uint32_t level, std::uint32_t x, std::uint32_t y) {
  const double step = 2.0 / Cube::size(level), left = x * step - 1.0, top = y * step - 1.0;
  return corner_solid_angle(left, top) - corner_solid_angle(left, top + step) - corner_solid_angle(left + step, top) +
         corner_solid_angle(left + step, top + step);
}

void for_each_texel(std::uint32_t level, const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& body) {
  for (std::uint32_t face = 0; face < 6; ++face)
    for (std::uint32_t y = 0; y < Cube::size(level); ++y)
      for (std::uint32_t x = 0; x < Cube::size(level); ++x) body(face, x, y);
}

image::FloatImage constant(std::uint32_t width, std::uint32_t height, vec3 value) {
  image::FloatImage image{.width = width, .height = height};
  image.rgba.resize(std::size_t{4} * width * height, 1.0f);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) std::copy_n(&value.x, 3, &image.rgba[i]);
  return image;
}

void set(image::FloatImage& image, std::uint32_t x, std::uint32_t y, float value) {
  std::fill_n(&image.rgba[4 * (std::size_t{y} * image.width + x)], 3, value);
}

// What a level should hold along `axis`: the integral over all pixels of the picture, each a point.
double convolved(const image::FloatImage& image, vec3 axis, float alpha) {
  double sum = 0.0, weight_sum = 0.0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const double row_weight = std::sin((y + 0.5) / image.height * kPi);
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const vec3 d = shading::equirect_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                                  (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)});
      const float n_dot_l = glm::dot(d, axis);
      if (n_dot_l <= 0.0f) continue;
      const vec3 off = d - axis;  // of length 2 sin(theta / 2)
      const double w = row_weight * n_dot_l * shading::d_ggx_from_sin2(0.25f * glm::dot(off, off), alpha);
      weight_sum += w;
      sum += w * image.rgba[4 * (std::size_t{y} * image.width + x)];
    }
  }
  return sum / weight_sum;
}

// Relative root mean square error of some texels of a level.
double level_error(const Cube& cube, const image::FloatImage& image, std::uint32_t level) {
  constexpr std::uint32_t kDirections = 24;
  const float alpha = shading::alpha_from_smoothness(shading::smoothness_of_level(static_cast<float>(level)));
  const std::uint32_t size = Cube::size(level), texels = 6 * size * size;
  std::vector<double> errors(kDirections), references(kDirections);
  parallel_for(kDirections, [&](std::size_t i) {
    const auto texel = static_cast<std::uint32_t>((i * texels + texels / 2) / kDirections);
    const std::uint32_t face = texel / (size * size), y = texel / size % size, x = texel % size;
    references[i] = convolved(image, texel_direction(level, face, x, y), alpha);
    errors[i] = static_cast<double>(cube.at(level, face, x, y).x) - references[i];
  });
  double error = 0.0, reference = 0.0;
  for (std::size_t i = 0; i < kDirections; ++i) {
    error += errors[i] * errors[i];
    reference += references[i] * references[i];
  }
  return std::sqrt(error / reference);
}

class EnvironmentTest : public ::testing::Test {
 protected:
  void SetUp() override {
    cache_ = std::filesystem::temp_directory_path() / ("velarium-bake-test-" + std::to_string(getpid()));
    std::filesystem::remove_all(cache_);
    setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove_all(cache_); }

  static gpu::GpuContext& tools() {
    static gpu::Device device(test::device_choice(), true);
    static gpu::GpuContext toolbox(device);
    return toolbox;
  }

  static Cube specular(Environment& environment) {
    std::vector<std::byte> bytes(half_image_bytes(environment.specular.desc()));
    download_half_image(tools().device, environment.specular, bytes);
    return Cube(std::move(bytes));
  }

  static Cube baked_cube(const image::FloatImage& image) {
    auto environment = bake_environment(tools(), image);
    return specular(environment);
  }

  [[nodiscard]] std::vector<std::filesystem::path> cached_environments() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(cache_))
      if (entry.path().filename().string().starts_with("environment-")) files.push_back(entry.path());
    return files;
  }

  std::filesystem::path cache_;
};

TEST_F(EnvironmentTest, AConstantStaysConstant) {
  const vec3 value(0.75f, 1.25f, 5.0f);  // halves
  for (const auto& [width, height] : {std::pair{3u, 2u}, std::pair{512u, 256u}}) {
    auto environment = bake_environment(tools(), constant(width, height, value));
    const Cube cube = specular(environment);
    for (std::uint32_t level = 0; level < shading::kPrefilterLevels; ++level)
      for_each_texel(level, [&](auto face, auto x, auto y) {
        const vec3 error = glm::abs(cube.at(level, face, x, y) / value - 1.0f);
        ASSERT_LT(std::max({error.x, error.y, error.z}), 1e-4f) << level << " " << face << " " << x << " " << y;
      });
    vec3 coefficients[9];
    for (std::size_t i = 0; i < 9; ++i) coefficients[i] = vec3(environment.sh[i]);
    for (const vec3 n : {vec3(0, 1, 0), vec3(0.6f, -0.8f, 0), vec3(0, 0.6f, -0.8f)})
      EXPECT_LT(glm::length(shading::sh_irradiance(coefficients, n) - value), 1e-4f);
  }
}

TEST_F(EnvironmentTest, ABrightTexelKeepsItsPowerAtEveryLevel) {
  constexpr std::uint32_t kWidth = 1024, kHeight = 512;
  for (const auto& [column, row] : {std::pair{100u, 256u}, std::pair{513u, 130u}, std::pair{700u, 480u}}) {
    auto image = constant(kWidth, kHeight, vec3(0.0f));
    set(image, column, row, 20000.0f);
    const double step = kPi / kHeight;
    const double power = 20000.0 * (std::cos(row * step) - std::cos((row + 1) * step)) * 2.0 * kPi / kWidth;
    const Cube cube = baked_cube(image);
    for (std::uint32_t level = 0; level < shading::kPrefilterLevels; ++level) {
      double sum = 0.0;
      for_each_texel(level, [&](auto face, auto x, auto y) {
        sum += texel_solid_angle(level, x, y) * static_cast<double>(cube.at(level, face, x, y).x);
      });
      EXPECT_NEAR(sum / power, 1.0, 0.03) << "level " << level << " row " << row;
    }
  }
}

TEST_F(EnvironmentTest, LevelsAgreeWithIntegrals) {
  const auto image = studio_environment();
  const Cube cube = baked_cube(image);
  for (std::uint32_t level = 2; level < shading::kPrefilterLevels; ++level)
    EXPECT_LT(level_error(cube, image, level), 0.01) << level;
}

TEST_F(EnvironmentTest, LevelsOfAPhotographAgreeWithIntegrals) {
  const char* assets = std::getenv("VELARIUM_ASSETS");
  if (assets == nullptr) GTEST_SKIP() << "VELARIUM_ASSETS is not set";
  const auto image = image::load_radiance(std::filesystem::path(assets) / "hdri" / "studio_small_03_1k.hdr");
  const Cube cube = baked_cube(image);
  for (std::uint32_t level = 3; level < shading::kPrefilterLevels; ++level)
    EXPECT_LT(level_error(cube, image, level), 0.015) << level;
}

TEST_F(EnvironmentTest, DirectionsAreThoseOfTheEquirectangularPicture) {
  struct Marker {
    std::uint32_t x, y;  // of its first pixel
    std::uint32_t face;  // that it must appear on, in the middle
    float radiance;
  };
  constexpr std::uint32_t kWidth = 256, kHeight = 128, kSize = 8;
  const std::array markers{Marker{124, 60, kPlusX, 1.0f}, Marker{252, 60, kMinusX, 2.0f}, Marker{60, 60, kMinusZ, 4.0f},
                           Marker{188, 60, kPlusZ, 8.0f}};
  auto image = constant(kWidth, kHeight, vec3(0.0f));
  for (const auto& marker : markers)
    for (std::uint32_t i = 0; i < kSize * kSize; ++i)
      set(image, (marker.x + i % kSize) % kWidth, marker.y + i / kSize, marker.radiance);
  for (std::uint32_t i = 0; i < kWidth * kSize; ++i) {
    set(image, i % kWidth, i / kWidth, 16.0f);                // straight up
    set(image, i % kWidth, kHeight - 1 - i / kWidth, 32.0f);  // straight down
  }
  const Cube cube = baked_cube(image);
  // The tails of level 2's lobe, 1.7 degrees wide, lose a sixth of a marker of 11.
  for (const std::uint32_t level : {0u, 1u, 2u}) {
    const std::uint32_t middle = Cube::size(level) / 2;
    const auto seen = [&](std::uint32_t face) { return cube.at(level, face, middle, middle).x; };
    for (const auto& marker : markers) EXPECT_NEAR(seen(marker.face) / marker.radiance, 1.0f, 0.2f) << level;
    EXPECT_NEAR(seen(kPlusY) / 16.0f, 1.0f, 0.2f);
    EXPECT_NEAR(seen(kMinusY) / 32.0f, 1.0f, 0.2f);
    // Between the markers there is nothing.
    EXPECT_LT(cube.at(level, kPlusX, middle, middle / 2).x, 0.1f);
  }
}

TEST_F(EnvironmentTest, BackgroundIsThePictureClampedToHalves) {
  auto image = constant(4, 2, vec3(0.5f));
  set(image, 3, 1, 1e6f);
  auto environment = bake_environment(tools(), image);
  const auto& desc = environment.background.desc();
  EXPECT_EQ(desc.mips, 3u);
  std::vector<std::uint64_t> texels(half_image_bytes(desc) / sizeof(std::uint64_t));
  download_half_image(tools().device, environment.background, std::as_writable_bytes(std::span(texels)));
  EXPECT_EQ(glm::unpackHalf4x16(texels[0]), glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
  EXPECT_EQ(glm::unpackHalf4x16(texels[7]), glm::vec4(65504.0f, 65504.0f, 65504.0f, 1.0f));
  // One of eight equal solid angles: the coefficients know all of its light.
  EXPECT_NEAR(environment.sh[0].x, 1e6 * (4.0 * kPi / 8.0) / std::sqrt(4.0 * kPi), 1e6 * 1e-3);
}

TEST_F(EnvironmentTest, ASecondBakeGivesTheSameBytes) {
  const auto image = studio_environment();
  auto first = bake_environment(tools(), image);
  ASSERT_EQ(cached_environments().size(), 1u);
  auto second = bake_environment(tools(), image);
  EXPECT_EQ(specular(first).bytes(), specular(second).bytes());
  EXPECT_EQ(first.sh, second.sh);
}

TEST_F(EnvironmentTest, TheCacheIsRead) {
  const auto bright = constant(8, 4, vec3(2.0f)), dim = constant(8, 4, vec3(1.0f));
  const auto bright_bytes = baked_cube(bright).bytes();
  const auto stored = cached_environments();
  ASSERT_EQ(stored.size(), 1u);
  EXPECT_NE(baked_cube(dim).bytes(), bright_bytes);
  for (const auto& file : cached_environments())
    if (file != stored.front())
      std::filesystem::copy_file(stored.front(), file, std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(baked_cube(dim).bytes(), bright_bytes) << "the dim picture's file now holds the bright one's bake";
}

TEST_F(EnvironmentTest, ADamagedCacheIsAMiss) {
  const auto image = constant(8, 4, vec3(2.0f));
  const auto bytes = baked_cube(image).bytes();
  const auto file = cached_environments().at(0);
  const auto good = read_file(file, 1u << 26);
  auto flipped = good;
  flipped[flipped.size() / 2] ^= std::byte{1};
  write_file(file, flipped);
  EXPECT_EQ(baked_cube(image).bytes(), bytes);
  EXPECT_EQ(read_file(file, 1u << 26), good) << "a miss stores the bake again";
}

TEST_F(EnvironmentTest, WorksWithoutACache) {
  setenv("XDG_CACHE_HOME", "/dev/null/nowhere", 1);
  EXPECT_EQ(baked_cube(constant(2, 1, vec3(1.0f))).at(6, 0, 0, 0), vec3(1.0f));
}

TEST_F(EnvironmentTest, RefusesPicturesLargerThanTheDevicesImages) {
  const std::uint32_t width = tools().device.caps().max_image_size + 1;
  try {
    static_cast<void>(bake_environment(tools(), constant(width, 1, vec3(1.0f))));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) { EXPECT_EQ(error.code(), ErrorCode::input_invalid); }
}

}  // namespace
}  // namespace velarium::bake
