// What a picture does not depend on, and what it does.

#include "statistical/tracer_scene.hpp"

#include <gtest/gtest.h>

namespace velarium::reference {
namespace {

using statistical::Tracing;

// A glossy ball on a floor under a sky, some of it see-through.
Tracing still_life() {
  scene::SceneBuilder builder("still life");
  scene::Material gloss;
  gloss.perceptual_roughness = 0.3f;
  scene::Material veil = statistical::matt(0.7f);
  veil.base_color.w = 0.5f;
  veil.alpha_mode = scene::AlphaMode::blend;
  const auto ball = builder.add_material(gloss), floor = builder.add_material(statistical::matt(0.5f));
  const auto sheet = builder.add_material(veil);
  builder.place_mesh(builder.add_mesh("ball", scene::uv_sphere(1.0f, 12, 24), ball), {0.0f, 1.0f, 0.0f});
  builder.place_mesh(builder.add_mesh("floor", statistical::square(5.0f, 0.0f, true), floor), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("veil", statistical::square(0.7f, 2.5f, true), sheet), {0.5f, 0.0f, 0.0f});
  Tracing t{std::move(builder).take(),
            scene::look_at_camera({0.0f, 3.0f, 6.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.8f)};
  t.environment = statistical::constant_environment(1.0f);
  t.settings.reference.spp = 5;
  t.size = 40;  // neither side is a whole number of tiles
  return t;
}

TEST(Tracer, ThreadsChangeNothing) {
  Tracing t = still_life();
  t.settings.reference.threads = 1;
  const auto alone = t.run();
  for (const int threads : {2, 3, 7}) {
    t.settings.reference.threads = threads;
    const auto together = t.run();
    EXPECT_EQ(alone.film.beauty(), together.film.beauty()) << threads << " threads";
    EXPECT_EQ(alone.film.variance(), together.film.variance()) << threads << " threads";
    EXPECT_EQ(alone.film.depth(), together.film.depth()) << threads << " threads";
  }
}

TEST(Tracer, SeedsGiveOtherNoiseOfTheSamePicture) {
  Tracing t = still_life();
  t.settings.reference.spp = 64;
  t.size = 16;
  const auto first = t.run();
  t.settings.frame.seed = 1;
  const auto second = t.run();
  EXPECT_NE(first.film.beauty(), second.film.beauty());
  const double error = std::hypot(first.standard_error(), second.standard_error());
  EXPECT_NEAR(first.radiance(), second.radiance(), 5.0 * error);
}

// A glowing square above a floor, with nothing else: without glow the square is as bright as ever and the floor is
// black, however light is looked for.
TEST(Tracer, GlowThatLightsNothingIsSeen) {
  scene::SceneBuilder builder("panel");
  scene::Material panel = statistical::matt(0.0f);
  panel.emissive = glm::vec3(3.0f);
  panel.double_sided = true;
  builder.place_mesh(
      builder.add_mesh("floor", statistical::square(5.0f, 0.0f, true), builder.add_material(statistical::matt(0.5f))),
      glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("panel", statistical::square(1.0f, 1.0f, true), builder.add_material(panel)),
                     glm::vec3(0.0f));
  Tracing t{std::move(builder).take(),
            scene::look_at_camera({0.0f, 6.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, 1.0f)};
  t.settings.reference.spp = 4;
  t.size = 16;
  const std::size_t middle = 4 * (8 * 16 + 8), corner = 4 * (1 * 16 + 1);
  for (const auto transport : {velarium::Transport::direct, velarium::Transport::full}) {
    t.settings.reference.transport = transport;
    t.settings.reference.emissive_lighting = true;
    const auto lit = t.run().film.beauty();
    t.settings.reference.emissive_lighting = false;
    const auto seen = t.run().film.beauty();
    EXPECT_EQ(seen[middle], 3.0f);
    EXPECT_EQ(lit[middle], 3.0f);
    EXPECT_GT(lit[corner], 0.0f);
    EXPECT_EQ(seen[corner], 0.0f);
  }
}

// They multiply light as no light does: what was traced without them says so.
TEST(Tracer, AmbientLightsAreLeftOutWithANote) {
  Tracing t = still_life();
  t.settings.reference.spp = 1;
  const auto without = t.run();
  t.scene.ambient_lights = {{.node = 0, .color = glm::vec3(0.1f), .range = 100.0f}};
  const auto with = t.run();
  EXPECT_EQ(with.film.beauty(), without.film.beauty());
  EXPECT_EQ(with.notes.size(), without.notes.size() + 1);
  EXPECT_NE(with.notes.back().find("ambient lights are left out"), std::string::npos);
  t.settings.ambient_lights.enabled = false;
  EXPECT_EQ(t.run().notes.size(), without.notes.size());
}

TEST(Tracer, MorePathsContinueFewer) {
  Tracing t = still_life();
  t.settings.reference.spp = 1;
  t.settings.reference.clamp = 0.0f;
  const auto one = t.run();
  EXPECT_EQ(one.film.finished_samples(), 1u);
  for (const float v : one.film.variance()) EXPECT_EQ(v, 0.0f);
  EXPECT_TRUE(std::isinf(one.film.relative_error()));
  t.settings.reference.spp = 64;
  const double coarse = still_life().run().film.relative_error(), fine = t.run().film.relative_error();
  EXPECT_GT(coarse, 0.0);
  EXPECT_LT(fine, 0.5 * coarse);  // 13 times the paths
}

TEST(Tracer, NoiseEndsThePictureEarly) {
  Tracing t = still_life();
  t.settings.reference.spp = 100000;
  t.settings.reference.noise = 0.2f;
  const auto traced = t.run();
  EXPECT_LT(traced.film.relative_error(), 0.2);
  EXPECT_LT(traced.film.finished_samples(), 1000u);
}

TEST(Tracer, CallersMayStopItAtOnceAndLater) {
  Tracing t = still_life();
  EXPECT_TRUE(t.run().finished);
  t.on_progress = [](const Progress&) { return false; };
  const auto none = t.run();
  EXPECT_FALSE(none.finished);
  EXPECT_EQ(none.film.finished_samples(), 0u);
  EXPECT_EQ(none.radiance(), 0.0);
  t.settings.reference.spp = 1000000;
  t.on_progress = [](const Progress& p) { return p.share == 0.0; };
  const auto some = t.run();
  EXPECT_FALSE(some.finished);
  EXPECT_GT(some.radiance(), 0.0);
}

TEST(Tracer, LayersTellWhatIsHitFirst) {
  Tracing t{{}, statistical::point_below(5.0f)};
  scene::SceneBuilder builder("floor");
  const auto floor = builder.add_material(statistical::matt(0.25f));
  builder.place_mesh(builder.add_mesh("floor", statistical::square(5.0f, 1.0f, true), floor), glm::vec3(0.0f));
  t.scene = std::move(builder).take();
  t.settings.reference.spp = 2;
  t.size = 1;
  const auto traced = t.run();
  EXPECT_EQ(traced.film.albedo(), (std::vector<float>{0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(traced.film.normal(), (std::vector<float>{0.0f, 1.0f, 0.0f}));
  EXPECT_NEAR(traced.film.depth()[0], 4.0f, 1e-5f);
  EXPECT_EQ(traced.film.beauty()[3], 1.0f);
}

TEST(Tracer, CamerasSeeThroughBacksThatShadowsKeep) {
  // From below the floor's back is not drawn; the light above it does not reach what lies below.
  Tracing t{{}, scene::look_at_camera({0.0f, -1.0f, 0.0f}, {0.0f, -3.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, 0.5f)};
  scene::SceneBuilder builder("two floors");
  const auto white = builder.add_material(statistical::matt(0.5f));
  builder.place_mesh(builder.add_mesh("upper", statistical::square(50.0f, 0.0f, true), white), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("lower", statistical::square(50.0f, -3.0f, true), white), glm::vec3(0.0f));
  t.scene = std::move(builder).take();
  t.lights = {{.position_range = {0.0f, 3.0f, 0.0f, 0.0f},
               .direction = {0.0f, -1.0f, 0.0f, shading::kLightPoint},
               .color = glm::vec4(100.0f, 100.0f, 100.0f, 0.0f),
               .cone = {},
               .flags = shading::kLightCastsShadow}};
  t.settings.reference.spp = 2;
  t.settings.reference.max_bounces = 0;
  EXPECT_EQ(t.run().radiance(), 0.0);  // shadowed by a surface that faces away from the shadow ray
  t.camera = scene::look_at_camera({0.0f, -1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, 0.5f);
  for (const float z : t.run().film.depth()) EXPECT_EQ(z, 0.0f);
}

TEST(Tracer, NotesSayWhatIsMissing) {
  Tracing t{{}, statistical::point_below(1.0f)};
  t.environment = statistical::constant_environment(0.0f);
  t.settings.reference.spp = 1;
  const auto traced = t.run();
  ASSERT_EQ(traced.notes.size(), 2u);
  EXPECT_NE(traced.notes[0].find("no triangles"), std::string::npos);
  EXPECT_NE(traced.notes[1].find("black"), std::string::npos);
  EXPECT_EQ(traced.radiance(), 0.0);
}

}  // namespace
}  // namespace velarium::reference
