// What every reflectance model owes: no more light out than came in, the same both ways, and samples that add up to it.

#include "statistical/chi_squared.hpp"

#include "reference/brdf_sampling.hpp"
#include "reference/sequence.hpp"

#include <array>
#include <tuple>
#include <vector>

namespace velarium::statistical {
namespace {

using namespace shading;

constexpr std::array kModels{kModelGltf, kModelRyse, kModelBlinnPhong};
constexpr double kTolerance = 2e-3;  // of the tabled integrals

Surface make_surface(float albedo, float f0) {
  return {vec3(0.0f, 0.0f, 1.0f), vec3(albedo), vec3(f0), 0.5f, 1.0f, 0.0f, vec2(0.0f), kClassStandard};
}

vec3 at_cosine(float cosine, float azimuth = 0.4f) {
  const float r = std::sqrt(1.0f - cosine * cosine);
  return {r * std::cos(azimuth), r * std::sin(azimuth), cosine};
}

// Directional albedo: what a uniform environment of radiance 1 sends towards wo.
double sampled_albedo(const Surface& s, float alpha, const vec3& wo, uint model, const vec3& scale = vec3(1.0f)) {
  constexpr std::uint32_t kSamples = 1u << 14;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    reference::Sequence sequence({0, 0}, i, 1);
    const float u_lobe = sequence.next_1d();
    const auto sample = reference::sample_brdf(s, alpha, wo, scale, model, u_lobe, sequence.next_2d());
    if (sample) sum += sample->weight.y;
  }
  return sum / kSamples;
}

double integrated_albedo(const Surface& s, float alpha, const vec3& wo, uint model) {
  constexpr int kRings = 500, kSectors = 500;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j)
      sum +=
          evaluate_brdf(s, alpha, wo, at_cosine((i + 0.5f) / kRings, kTwoPi * (j + 0.5f) / kSectors), vec3(1.0f), model)
              .y;
  return sum * 2.0 * kPiExact / (kRings * kSectors);
}

// Directional albedo of the specular lobe for f0 = 0 and f0 = 1, f90 = 1: sums over 3000 x 3000 directions in double,
// or half vectors for the narrowest lobe, by an independent program.
struct SpecularRow {
  uint model;
  float smoothness, n_dot_v;
  double e0, e1;
};

const SpecularRow kSpecularRows[] = {
    {kModelRyse, 0.0f, 0.05f, 0.0078, 0.3096},        {kModelRyse, 0.0f, 0.25f, 0.0040, 0.2988},
    {kModelRyse, 0.0f, 0.5f, 0.0015, 0.2862},         {kModelRyse, 0.0f, 1.0f, 0.0000, 0.2640},
    {kModelRyse, 0.25f, 0.05f, 0.0253, 0.2502},       {kModelRyse, 0.25f, 0.5f, 0.0080, 0.4663},
    {kModelRyse, 0.5f, 0.05f, 0.0268, 0.0783},        {kModelRyse, 0.5f, 0.25f, 0.0461, 0.2614},
    {kModelRyse, 0.5f, 0.75f, 0.0011, 0.7827},        {kModelRyse, 1.0f, 0.05f, 0.0154, 0.0199},
    {kModelRyse, 1.0f, 0.25f, 0.0617, 0.2601},        {kModelRyse, 1.0f, 1.0f, 0.0000, 1.0000},
    {kModelGltf, 0.0f, 0.05f, 0.0321, 0.8478},        {kModelGltf, 0.0f, 0.25f, 0.0109, 0.5976},
    {kModelGltf, 0.0f, 0.5f, 0.0030, 0.4507},         {kModelGltf, 0.0f, 1.0f, 0.0000, 0.3069},
    {kModelGltf, 0.25f, 0.05f, 0.1287, 0.9305},       {kModelGltf, 0.25f, 0.5f, 0.0181, 0.8113},
    {kModelGltf, 0.5f, 0.05f, 0.4058, 0.9004},        {kModelGltf, 0.5f, 0.25f, 0.1917, 0.9476},
    {kModelGltf, 0.5f, 0.75f, 0.0017, 0.9908},        {kModelGltf, 1.0f, 0.05f, 0.7736, 0.9999},
    {kModelGltf, 1.0f, 0.25f, 0.2373, 1.0000},        {kModelGltf, 1.0f, 1.0f, 0.0000, 1.0000},
    {kModelBlinnPhong, 0.0f, 0.05f, 0.0061, 0.2500},  {kModelBlinnPhong, 0.0f, 0.5f, 0.0012, 0.2500},
    {kModelBlinnPhong, 0.25f, 0.05f, 0.0090, 0.0575}, {kModelBlinnPhong, 0.25f, 0.5f, 0.0046, 0.2752},
    {kModelBlinnPhong, 0.25f, 1.0f, 0.0000, 0.8192},  {kModelBlinnPhong, 0.5f, 0.05f, 0.0040, 0.0074},
    {kModelBlinnPhong, 0.5f, 0.25f, 0.0137, 0.0671},  {kModelBlinnPhong, 0.5f, 0.75f, 0.0006, 0.5586},
    {kModelBlinnPhong, 1.0f, 0.05f, 0.0019, 0.0025},  {kModelBlinnPhong, 1.0f, 0.5f, 0.0078, 0.2500}};

TEST(Brdf, SpecularLobeReflectsTheTabledShare) {
  for (const SpecularRow& row : kSpecularRows) {
    const float alpha = alpha_from_smoothness(row.smoothness);
    const vec3 wo = at_cosine(row.n_dot_v);
    EXPECT_NEAR(sampled_albedo(make_surface(0.0f, 1.0f), alpha, wo, row.model), row.e1, kTolerance)
        << row.model << ' ' << row.smoothness << ' ' << row.n_dot_v;
    // 2 % is the least reflectance that rises to 1 at grazing angles.
    EXPECT_NEAR(sampled_albedo(make_surface(0.0f, 0.02f), alpha, wo, row.model), 0.98 * row.e0 + 0.02 * row.e1,
                kTolerance)
        << row.model << ' ' << row.smoothness << ' ' << row.n_dot_v;
  }
}

// The white furnace: with what it loses to further bounces given back, a white metal reflects everything.
TEST(Brdf, CompensatedWhiteMetalVanishesInTheFurnace) {
  for (const SpecularRow& row : kSpecularRows) {
    if (row.model != kModelGltf) continue;
    const vec2 env_brdf(row.e0, row.e1);
    const float alpha = alpha_from_smoothness(row.smoothness);
    for (const float f0 : {0.04f, 0.5f, 1.0f}) {
      const vec3 scale = energy_compensation(vec3(f0), env_brdf);
      const double albedo = sampled_albedo(make_surface(0.0f, f0), alpha, at_cosine(row.n_dot_v), row.model, scale);
      if (f0 == 1.0f) { EXPECT_NEAR(albedo, 1.0, kTolerance / row.e1) << row.smoothness << ' ' << row.n_dot_v; }
      EXPECT_LE(albedo, 1.0 + kTolerance / row.e1) << row.smoothness << ' ' << row.n_dot_v;
    }
  }
}

// Ryse's masking does not fade with the width of the lobe: its white mirror reflects (n.v / (0.68 n.v + 0.32))^2. Nor
// does Blinn-Phong's, n.l n.v: its mirror reflects (n.v)^2.
TEST(Brdf, MirrorLimits) {
  for (const float n_dot_v : {0.05f, 0.25f, 0.5f, 0.75f, 1.0f}) {
    const double share = std::pow(n_dot_v / (0.68 * n_dot_v + 0.32), 2.0);
    const Surface mirror = make_surface(0.0f, 1.0f);
    EXPECT_NEAR(sampled_albedo(mirror, kMinAlpha, at_cosine(n_dot_v), kModelRyse), share, kTolerance) << n_dot_v;
    EXPECT_NEAR(sampled_albedo(mirror, kMinAlpha, at_cosine(n_dot_v), kModelGltf), 1.0, kTolerance) << n_dot_v;
    EXPECT_NEAR(sampled_albedo(mirror, kMinAlpha, at_cosine(n_dot_v), kModelBlinnPhong), n_dot_v * n_dot_v, kTolerance)
        << n_dot_v;
  }
}

// Albedo of Fujii's diffuse reflection in closed form: A' (1 + r G(n.v) / pi).
double fujii_albedo(double mu, double r) {
  const double s = std::sqrt(1.0 - mu * mu);
  const double g = s * (std::acos(mu) - s * mu) + 2.0 / 3.0 * (s / mu * (1.0 - s * s * s) - s);
  return (1.0 + r * g / kPiExact) / (1.0 + (0.5 - 2.0 / (3.0 * kPiExact)) * r);
}

TEST(Brdf, DiffuseLobesReflectTheirClosedForms) {
  EXPECT_NEAR(fujii_albedo(0.5, 0.6), 0.91126, 1e-5);  // tabled
  for (const float alpha : {0.1f, 0.5f, 1.0f}) {
    const Surface matt = make_surface(1.0f, 0.0f);
    for (const float n_dot_v : {0.05f, 0.5f, 1.0f}) {
      const vec3 wo = at_cosine(n_dot_v);
      EXPECT_NEAR(sampled_albedo(matt, alpha, wo, kModelGltf), 1.0, kTolerance);
      EXPECT_NEAR(sampled_albedo(matt, alpha, wo, kModelRyse), fujii_albedo(n_dot_v, fujii_weight_from_alpha(alpha)),
                  kTolerance);
    }
  }
}

// Where a published model gives out more than it takes in, for a white base, and the most that it gives: that of the
// narrowest lobe, at n.v = 0.01 in the glTF model and 0.236 in Ryse's, integrated by an independent program.
struct EnergyException {
  uint model;
  float f0;
  double most;
  const char* reason;
};

constexpr const char* kHalfVectorMix =
    "glTF 2.0, B.3.6.3, says it of itself: the share left to diffuse light is 1 - F of the half vector, which for "
    "light "
    "from elsewhere than the mirror direction does not know how much the specular lobe takes at grazing angles";
constexpr const char* kFlatShare =
    "Schulz 2014 leaves 1 - luminance(f0) to diffuse light at every angle; the masking hides it but for 3 %";

const EnergyException kEnergyExceptions[] = {{kModelGltf, 0.04f, 1.8827, kHalfVectorMix},
                                             {kModelGltf, 0.2f, 1.7350, kHalfVectorMix},
                                             {kModelGltf, 0.5f, 1.4582, kHalfVectorMix},
                                             {kModelRyse, 0.04f, 1.0299, kFlatShare}};

double most_reflected(uint model, float f0) {
  double most = 0.0;
  for (const float smoothness : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
    for (const float n_dot_v : {0.01f, 0.05f, 0.1f, 0.236f, 0.5f, 0.75f, 1.0f})
      most = std::max(
          most, sampled_albedo(make_surface(1.0f, f0), alpha_from_smoothness(smoothness), at_cosine(n_dot_v), model));
  return most;
}

TEST(Brdf, ReflectsNoMoreThanArrives) {
  for (const uint model : kModels) {
    for (const float f0 : {0.0f, 0.04f, 0.2f, 0.5f, 1.0f}) {
      const double most = most_reflected(model, f0);
      const auto* exception = std::find_if(std::begin(kEnergyExceptions), std::end(kEnergyExceptions),
                                           [&](const auto& e) { return e.model == model && e.f0 == f0; });
      if (exception == std::end(kEnergyExceptions))
        EXPECT_LE(most, 1.0 + kTolerance) << model << ' ' << f0;
      else
        EXPECT_NEAR(most, exception->most, kTolerance) << model << ' ' << f0 << ": " << exception->reason;
    }
  }
}

std::vector<vec3> grid_of_directions() {
  std::vector<vec3> directions;
  for (const float cosine : {0.05f, 0.2f, 0.5f, 0.8f, 1.0f})
    for (const float azimuth : {0.0f, 0.7f, 2.0f, 3.1f}) directions.push_back(at_cosine(cosine, azimuth));
  return directions;
}

// f without the cosine.
float reflectance(const Surface& s, float alpha, const vec3& wo, const vec3& wi, uint model, float scale) {
  return evaluate_brdf(s, alpha, wo, wi, vec3(scale), model).y / wi.z;
}

TEST(Brdf, IsReciprocal) {
  const auto directions = grid_of_directions();
  for (const uint model : kModels)
    for (const float alpha : {kMinAlpha, 0.0754f, 0.3f, 1.0f})
      for (const Surface& s :
           {make_surface(1.0f, 0.0f), make_surface(0.8f, 0.04f), make_surface(0.3f, 0.5f), make_surface(0.0f, 1.0f)})
        for (const vec3& a : directions)
          for (const vec3& b : directions) {
            const float forth = reflectance(s, alpha, a, b, model, 1.0f),
                        back = reflectance(s, alpha, b, a, model, 1.0f);
            // evaluate_brdf adds 1e-5 to n.v alone: 2e-4 of the smallest cosine.
            ASSERT_NEAR(forth, back, 5e-4f * std::max(forth, back)) << model << ' ' << alpha << ' ' << s.f0.x;
          }
}

// The one exception: what is given back to rough metals depends on the eye's side alone [Turquin 2019, who accepts it].
// Between grazing and head-on at alpha = 1 that is as E1 there to E1 here, 0.3069 / 0.8478, and never more.
TEST(Brdf, CompensationIsNotReciprocal) {
  const Surface metal = make_surface(0.0f, 1.0f);
  const vec3 grazing = at_cosine(0.05f), head_on = at_cosine(1.0f);
  const float scale_grazing = energy_compensation(vec3(1.0f), vec2(0.0321f, 0.8478f)).y;
  const float scale_head_on = energy_compensation(vec3(1.0f), vec2(0.0f, 0.3069f)).y;
  const float forth = reflectance(metal, 1.0f, grazing, head_on, kModelGltf, scale_grazing);
  const float back = reflectance(metal, 1.0f, head_on, grazing, kModelGltf, scale_head_on);
  EXPECT_NEAR(forth / back, 0.3069 / 0.8478, 1e-3);
}

// Samples add up to the integral: from above, from the edge, and from behind a shading normal.
TEST(Brdf, SamplesAddUpToTheIntegral) {
  for (const uint model : kModels)
    for (const float alpha : {0.3f, 1.0f})
      for (const Surface& s : {make_surface(0.8f, 0.04f), make_surface(0.4f, 0.5f), make_surface(0.0f, 1.0f)})
        for (const float n_dot_v : {0.9f, 0.3f, -0.1f, -0.6f}) {
          const vec3 wo = at_cosine(n_dot_v);
          EXPECT_NEAR(sampled_albedo(s, alpha, wo, model), integrated_albedo(s, alpha, wo, model), kTolerance)
              << model << ' ' << alpha << ' ' << s.f0.x << ' ' << n_dot_v;
        }
}

// A lobe's weight is at most 1 over the chance to choose it, which is at least 1/10; from behind as well as from above.
// Ryse's diffuse lobe is not chosen by its own shape: light that returns to a grazing eye weighs up to r / max(n.l,
// n.v) more, where Fujii's r is at most 0.58. Nor is Blinn-Phong's: it exceeds the GGX lobe of the same peak by 4/e.
float largest_weight(uint model, const Surface& s, const vec3& wo, const vec3& wi) {
  if (model == kModelGltf) return 10.1f;
  if (model == kModelBlinnPhong) return 10.1f * 4.0f / 2.71828f;
  const float cosine = std::max(std::abs(glm::dot(s.normal_ws, wo)), glm::dot(s.normal_ws, wi));
  return 10.1f * (1.0f + 0.6f / std::max(cosine, 1e-4f));
}

TEST(Brdf, WeightsAreBounded) {
  Random random(13);
  for (int i = 0; i < 400000; ++i) {
    const Surface s =
        make_surface(random.uniform() < 0.3f ? 0.0f : random.uniform(), random.uniform() * random.uniform());
    const float alpha = std::max(std::pow(random.uniform(), 3.0f), kMinAlpha);
    const vec3 wo = random.direction();
    const float u_lobe = random.uniform();
    const uint model = kModels[i % kModels.size()];
    const auto sample =
        reference::sample_brdf(s, alpha, wo, vec3(1.0f), model, u_lobe, {random.uniform(), random.uniform()});
    if (!sample) continue;
    ASSERT_GT(sample->pdf_sr, 0.0f);
    ASSERT_LE(sample->weight.y, largest_weight(model, s, wo, sample->wi)) << alpha << ' ' << wo.z << ' ' << s.f0.x;
    ASSERT_NEAR(reference::pdf_sr_brdf(s, alpha, wo, sample->wi, vec3(1.0f), model), sample->pdf_sr,
                1e-5f * sample->pdf_sr);
  }
}

// At the very edge, on both sides of it, about normals that round: everything stays a number, and bounded.
TEST(Brdf, GrazingViewsAreSampled) {
  Random random(15);
  int sampled = 0;
  for (int i = 0; i < 1000000; ++i) {
    Surface s = make_surface(i % 3 == 0 ? 0.0f : 0.8f, 0.04f);
    s.normal_ws = random.direction();
    const float height = (i % 5 < 3 ? 1.0f : -1.0f) * std::pow(10.0f, random.uniform(-9.0f, -2.0f));
    const vec3 wo = from_tangent_space(at_cosine(height, kTwoPi * random.uniform()), s.normal_ws);
    const float alpha = i % 2 == 0 ? kMinAlpha : random.uniform(kMinAlpha, 1.0f), u_lobe = random.uniform();
    const uint model = kModels[i / 7 % kModels.size()];
    const auto sample =
        reference::sample_brdf(s, alpha, wo, vec3(1.0f), model, u_lobe, {random.uniform(), random.uniform()});
    if (!sample) continue;
    ++sampled;
    ASSERT_TRUE(std::isfinite(sample->pdf_sr) && sample->pdf_sr > 0.0f) << alpha << ' ' << height;
    ASSERT_GE(sample->weight.y, 0.0f) << alpha << ' ' << height;
    ASSERT_LE(sample->weight.y, largest_weight(model, s, wo, sample->wi)) << alpha << ' ' << height;
  }
  EXPECT_GT(sampled, 500000);
}

TEST(Brdf, BlackSurfacesEndPaths) {
  EXPECT_FALSE(reference::sample_brdf(make_surface(0.0f, 0.0f), 0.3f, at_cosine(0.5f), vec3(1.0f), kModelGltf, 0.5f,
                                      {0.5f, 0.5f}));
  EXPECT_EQ(
      reference::pdf_sr_brdf(make_surface(0.0f, 0.0f), 0.3f, at_cosine(0.5f), at_cosine(0.5f), vec3(1.0f), kModelGltf),
      0.0f);
}

}  // namespace
}  // namespace velarium::statistical
