#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

// pi f / albedo at the angles of light and eye from the normal, and the azimuth between them; radians.
using Bracket = std::function<double(double, double, double)>;

// The full model of Oren-Nayar 1994; `bounces`: with the light that bounces once between facets of albedo 1.
double full_oren_nayar(double theta_i, double theta_r, double azimuth, double sigma, bool bounces) {
  const double a = std::max(theta_i, theta_r), b = std::min(theta_i, theta_r), q = sigma * sigma, c = std::cos(azimuth);
  const double c1 = 1.0 - 0.5 * q / (q + 0.33);
  const double c2 = 0.45 * q / (q + 0.09) * (c >= 0.0 ? std::sin(a) : std::sin(a) - std::pow(2.0 * b / kPiExact, 3));
  const double c3 = 0.125 * q / (q + 0.09) * std::pow(4.0 * a * b / (kPiExact * kPiExact), 2);
  double sum = c1 + c * c2 * std::tan(b) + (1.0 - std::abs(c)) * c3 * std::tan(0.5 * (a + b));
  if (bounces) sum += 0.17 * q / (q + 0.13) * (1.0 - c * std::pow(2.0 * b / kPiExact, 2));
  return sum;
}

Bracket at_angles(float (*model)(float, float, float, float), float parameter) {
  return [=](double theta_i, double theta_r, double azimuth) -> double {
    const double nl = std::cos(theta_i), nv = std::cos(theta_r);
    const double lv = nl * nv + std::sin(theta_i) * std::sin(theta_r) * std::cos(azimuth);
    return model(static_cast<float>(nl), static_cast<float>(nv), static_cast<float>(lv), parameter);
  };
}

double directional_albedo(const Bracket& bracket, double theta_r, int steps) {
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double theta_i = std::asin(std::sqrt((i + 0.5) / steps));
    for (int j = 0; j < steps; ++j) sum += bracket(theta_i, theta_r, kPiExact * (j + 0.5) / steps);
  }
  return sum / (steps * steps);
}

double weighted_rms(const Bracket& f, const Bracket& g) {
  constexpr int kSteps = 18;
  double error = 0.0, total = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double theta_i = radians(85.0 * (i + 0.5) / kSteps);
    for (int k = 0; k < kSteps; ++k) {
      const double theta_r = radians(85.0 * (k + 0.5) / kSteps);
      const double weight = std::cos(theta_i) * std::sin(theta_i) * std::cos(theta_r) * std::sin(theta_r);
      for (int j = 0; j < kSteps; ++j) {
        const double azimuth = kPiExact * (j + 0.5) / kSteps;
        error += weight * std::pow(f(theta_i, theta_r, azimuth) - g(theta_i, theta_r, azimuth), 2);
        total += weight;
      }
    }
  }
  return std::sqrt(error / total);
}

float fujii_weight_from_sigma(float sigma) {
  return fujii_weight_from_alpha(std::tan(sigma));
}

TEST(Diffuse, FujiiAlbedoIsTheClosedForm) {
  const Bracket fujii = at_angles(diffuse_fujii, 0.6f);
  const auto albedo = [&](double angle) { return directional_albedo(fujii, radians(angle), 200); };
  EXPECT_NEAR(albedo(0.001), 0.85275, 1e-4);
  EXPECT_NEAR(albedo(30.0), 0.86069, 1e-4);
  EXPECT_NEAR(albedo(60.0), 0.91126, 1e-4);
  EXPECT_NEAR(albedo(80.0), 0.96998, 1e-4);
}

TEST(Diffuse, FujiiMeanAlbedoIsTheClosedForm) {
  const Bracket fujii = at_angles(diffuse_fujii, 0.6f);
  constexpr int kSteps = 48;
  double mean = 0.0;
  for (int i = 0; i < kSteps; ++i) mean += directional_albedo(fujii, std::asin(std::sqrt((i + 0.5) / kSteps)), 60);
  EXPECT_NEAR(mean / kSteps, 0.88984, 1e-4);
}

struct ModelRow {
  float sigma;
  double gotanda, fujii, qualitative;  // RMS distance from the full model; Fujii's from the one with bounces
};

TEST(Diffuse, ModelsFollowTheFullOne) {
  for (const ModelRow& row : {ModelRow{0.2f, 0.010, 0.026, 0.042}, ModelRow{0.5f, 0.025, 0.033, 0.101},
                              ModelRow{0.7853982f, 0.029, 0.083, 0.120}}) {
    const Bracket single = [&](double i, double r, double d) { return full_oren_nayar(i, r, d, row.sigma, false); };
    const Bracket bounced = [&](double i, double r, double d) { return full_oren_nayar(i, r, d, row.sigma, true); };
    EXPECT_NEAR(weighted_rms(at_angles(diffuse_gotanda, row.sigma), single), row.gotanda, 6e-4);
    EXPECT_NEAR(weighted_rms(at_angles(diffuse_oren_nayar, row.sigma), single), row.qualitative, 6e-4);
    const float r = fujii_weight_from_sigma(row.sigma);
    EXPECT_NEAR(weighted_rms(at_angles(diffuse_fujii, r), bounced), row.fujii, 6e-4);
  }
}

TEST(Diffuse, SendsLightBackAtGrazingAngles) {
  const double angle = radians(80.0);
  EXPECT_NEAR(directional_albedo(at_angles(diffuse_fujii, fujii_weight_from_sigma(0.5f)), angle, 60), 0.9779, 5e-4);
  EXPECT_NEAR(directional_albedo(at_angles(diffuse_gotanda, 0.5f), angle, 60), 0.8603, 5e-4);
}

TEST(Diffuse, ModelsAreLambertWhereSmooth) {
  EXPECT_EQ(diffuse(kModelGltf, 0.3f, 0.7f, -0.2f, 1.0f), 1.0f);
  EXPECT_NEAR(diffuse(kModelRyse, 0.3f, 0.7f, -0.2f, 1e-4f), 1.0f, 1e-5);
  EXPECT_NEAR(fujii_weight_from_alpha(1.0f), 0.5826, 1e-3);  // B / A at sigma = pi / 4
}

TEST(Diffuse, IsNeverNegativeAndBoundedTimesCosine) {
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const vec3 l = random.hemisphere_direction(), v = random.hemisphere_direction();
    const float alpha = random.uniform();
    const float value = diffuse(kModelRyse, l.z, v.z, dot(l, v), alpha) * l.z;
    ASSERT_GE(value, 0.0f);
    ASSERT_LE(value, 1.5f);
  }
}

}  // namespace
}  // namespace velarium::shading
