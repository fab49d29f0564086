// Each sampler of directions and places, against the density that goes with it.

#include "statistical/chi_squared.hpp"

#include "reference/brdf_sampling.hpp"

#include <string>
#include <vector>

namespace velarium::statistical {
namespace {

using namespace shading;

vec2 uniform_2d(Random& random) {
  const float x = random.uniform();
  return {x, random.uniform()};
}

vec3 at_cosine(float n_dot_v, float azimuth = 0.4f) {
  const float r = std::sqrt(1.0f - n_dot_v * n_dot_v);
  return {r * std::cos(azimuth), r * std::sin(azimuth), n_dot_v};
}

float sin2_to_z(const vec3& h) {
  return std::min(h.x * h.x + h.y * h.y, 1.0f);
}

TEST(Samplers, Disc) {
  // Radius and angle, squared and unrolled so that the disc becomes a square of density 1.
  const auto sampler = [](Random& random) -> std::optional<vec2> {
    const vec2 p = sample_disc(uniform_2d(random));
    return vec2(glm::dot(p, p), 0.5f + std::atan2(p.y, p.x) / kTwoPi);
  };
  EXPECT_TRUE(agrees(test_on_square(sampler, [](const vec2&) { return 1.0; }, {}), 1));
}

TEST(Samplers, DiscKeepsToItsEdgeAndMiddle) {
  for (const vec2 corner : {vec2(0.0f), vec2(0.99999994f), vec2(0.0f, 0.99999994f), vec2(0.5f, 0.0f)})
    EXPECT_LE(length(sample_disc(corner)), 1.0f + 1e-6f);
  EXPECT_EQ(sample_disc(vec2(0.5f)), vec2(0.0f));
}

TEST(Samplers, CosineHemisphere) {
  const auto sampler = [](Random& random) { return std::optional(sample_cosine_hemisphere(uniform_2d(random))); };
  const auto pdf_sr = [](const vec3& d) { return std::max(d.z, 0.0f) / kPiExact; };
  EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, {}, {}), 1));
}

TEST(Samplers, CosineDirectionsAreUnit) {
  Random random(14);
  for (int i = 0; i < 10000; ++i) {
    vec2 u = uniform_2d(random);
    if (i % 4 == 0) u.x = i % 8 == 0 ? 0.0f : 0.99999994f;  // the rim
    const vec3 d = sample_cosine_hemisphere(u);
    ASSERT_NEAR(glm::length(d), 1.0f, 1e-6);
    ASSERT_GE(d.z, 0.0f);
  }
}

// The hemisphere about the normal, finer where lobes are narrow.
SphereBins half_vector_bins(float alpha) {
  return {.axis = {0.0f, 0.0f, 1.0f}, .focus = alpha < 0.3f ? 4 : 1, .height = 1.0f};
}

TEST(Samplers, GgxHalfVectors) {
  for (const float alpha : {0.03f, 0.2f, 0.5f, 1.0f}) {
    const auto sampler = [&](Random& random) {
      return std::optional(sample_ggx_half_vector(uniform_2d(random), alpha));
    };
    const auto pdf_sr = [&](const vec3& h) {
      return h.z > 0.0f ? double{d_ggx_from_sin2(sin2_to_z(h), alpha)} * h.z : 0.0;
    };
    EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, half_vector_bins(alpha), {.fineness = 24}), 4)) << alpha;
  }
}

// Density of visible normals, D G1 max(wo.h, 0) / n.v [Heitz 2014, eq. 2].
double visible_normal_density(const vec3& h, const vec3& wo, float alpha) {
  if (h.z <= 0.0f) return 0.0;
  return 4.0 * std::max(glm::dot(wo, h), 0.0f) * pdf_sr_ggx_visible(sin2_to_z(h), wo.z, alpha);
}

TEST(Samplers, VisibleHalfVectors) {
  const std::vector<float> alphas{0.03f, 0.2f, 0.5f, 1.0f}, cosines{0.02f, 0.3f, 0.8f, 1.0f};
  for (const float alpha : alphas) {
    for (const float n_dot_v : cosines) {
      const vec3 wo = at_cosine(n_dot_v);
      const auto sampler = [&](Random& random) {
        return std::optional(sample_ggx_visible_half_vector(wo, uniform_2d(random), alpha));
      };
      const auto pdf_sr = [&](const vec3& h) { return visible_normal_density(h, wo, alpha); };
      EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, half_vector_bins(alpha), {.fineness = 24}), 16))
          << alpha << ' ' << n_dot_v;
    }
  }
}

// Half vectors without masking have another density: the test above can tell.
TEST(Samplers, PlainHalfVectorsAreNotTheVisibleOnes) {
  const vec3 wo = at_cosine(0.5f);
  const auto sampler = [](Random& random) { return std::optional(sample_ggx_half_vector(uniform_2d(random), 0.5f)); };
  const auto pdf_sr = [&](const vec3& h) { return visible_normal_density(h, wo, 0.5f); };
  EXPECT_FALSE(agrees(test_on_sphere(sampler, pdf_sr, half_vector_bins(0.5f), {.fineness = 24}), 1));
}

TEST(Samplers, DirectionsMirroredAtVisibleHalfVectors) {
  for (const float alpha : {0.1f, 0.4f, 1.0f}) {
    for (const float n_dot_v : {0.1f, 0.6f, 1.0f}) {
      const vec3 wo = at_cosine(n_dot_v);
      const auto sampler = [&](Random& random) {
        const vec3 h = sample_ggx_visible_half_vector(wo, uniform_2d(random), alpha);
        return std::optional(2.0f * glm::dot(wo, h) * h - wo);
      };
      // Directions under the surface, too, belong to some half vector above it.
      const auto pdf_sr = [&](const vec3& wi) {
        const vec3 h = glm::normalize(wo + wi);
        return h.z > 0.0f ? double{pdf_sr_ggx_visible(sin2_to_z(h), wo.z, alpha)} : 0.0;
      };
      const vec3 mirrored{-wo.x, -wo.y, wo.z};
      EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, {mirrored, 3}, {.fineness = 24}), 9))
          << alpha << ' ' << n_dot_v;
    }
  }
}

// Half angles of 0.27 degrees (the sun), of 30 and 90 degrees; and the whole sphere.
TEST(Samplers, Cones) {
  for (const float height : {cone_height(0.00465f * 0.00465f), cone_height(0.25f), cone_height(1.0f), 2.0f}) {
    const auto sampler = [&](Random& random) { return std::optional(sample_cone(uniform_2d(random), height)); };
    const auto pdf_sr = [&](const vec3&) { return pdf_sr_cone(height); };
    EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, {.height = height}, {}), 4)) << height;
  }
}

TEST(Samplers, ConeOfASphere) {
  EXPECT_EQ(cone_height(0.0f), 0.0f);
  EXPECT_EQ(cone_height(1.0f), 1.0f);
  EXPECT_NEAR(cone_height(0.75f), 0.5f, 1e-7);  // 60 degrees
  EXPECT_NEAR(cone_height(1e-10f) / 0.5e-10f, 1.0f, 1e-6);
  // Seen from 2 m, a sphere of 1 m is met by each direction of its cone, and by none just outside.
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const vec3 d = sample_cone(uniform_2d(random), cone_height(0.25f));
    ASSERT_LE(2.0f * std::sqrt(d.x * d.x + d.y * d.y), 1.0f + 1e-6f);
  }
}

TEST(Samplers, Triangles) {
  // Uniform over the triangle means uniform in ((b0 + b1)^2, b0 / (b0 + b1)).
  const auto sampler = [](Random& random) -> std::optional<vec2> {
    const vec3 b = sample_triangle(uniform_2d(random));
    return vec2((b.x + b.y) * (b.x + b.y), b.x / (b.x + b.y));
  };
  EXPECT_TRUE(agrees(test_on_square(sampler, [](const vec2&) { return 1.0; }, {}), 1));
  Random random(6);
  for (int i = 0; i < 10000; ++i) {
    const vec3 b = sample_triangle(uniform_2d(random));
    ASSERT_GE(std::min({b.x, b.y, b.z}), 0.0f);
    ASSERT_NEAR(b.x + b.y + b.z, 1.0f, 1e-6);
  }
}

TEST(Samplers, TangentFramesInvert) {
  Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const vec3 n = random.direction(), d = random.direction();
    ASSERT_LT(length(from_tangent_space(to_tangent_space(d, n), n) - d), 2e-6f);
    ASSERT_NEAR(to_tangent_space(d, n).z, glm::dot(d, n), 1e-6);
  }
}

struct Material {
  const char* name;
  vec3 albedo, f0;
};

const Material kMaterials[] = {{"plastic", vec3(0.8f, 0.4f, 0.2f), vec3(0.04f)},
                               {"metal", vec3(0.0f), vec3(1.0f, 0.77f, 0.34f)},
                               {"matt", vec3(0.5f), vec3(0.0f)},
                               {"half metal", vec3(0.5f, 0.4f, 0.3f), vec3(0.5f, 0.3f, 0.2f)}};

Surface make_surface(const Material& m, const vec3& normal) {
  return {normal, m.albedo, m.f0, 0.5f, 1.0f, 0.0f, vec2(0.0f), kClassStandard};
}

// The mixture of lobes, about a normal that no axis favours, seen from above, from the edge and from behind.
class BrdfSampler : public testing::TestWithParam<std::tuple<uint, std::size_t>> {};

TEST_P(BrdfSampler, MeetsItsDensity) {
  const auto [model, material] = GetParam();
  const Surface s = make_surface(kMaterials[material], glm::normalize(vec3(0.3f, -0.5f, 0.6f)));
  for (const float alpha : {0.08f, 0.3f, 1.0f}) {
    for (const float n_dot_v : {0.9f, 0.3f, 0.02f, -0.2f}) {
      const vec3 wo = from_tangent_space(at_cosine(n_dot_v), s.normal_ws);
      const vec3 scale(1.0f + 0.5f * alpha);
      const auto sampler = [&](Random& random) -> std::optional<vec3> {
        const float u_lobe = random.uniform();
        const auto chosen = reference::sample_brdf(s, alpha, wo, scale, model, u_lobe, uniform_2d(random));
        return chosen ? std::optional(chosen->wi) : std::nullopt;
      };
      const auto pdf_sr = [&](const vec3& wi) { return reference::pdf_sr_brdf(s, alpha, wo, wi, scale, model); };
      const SphereBins bins{from_tangent_space(at_cosine(std::abs(n_dot_v), 0.4f + kPi), s.normal_ws), 3};
      EXPECT_TRUE(agrees(test_on_sphere(sampler, pdf_sr, bins, {.samples = 100000, .fineness = 24}), 96))
          << kMaterials[material].name << ' ' << alpha << ' ' << n_dot_v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, BrdfSampler,
                         testing::Combine(testing::Values(kModelGltf, kModelRyse, kModelBlinnPhong),
                                          testing::Range(std::size_t{0}, std::size(kMaterials))));

}  // namespace
}  // namespace velarium::statistical
