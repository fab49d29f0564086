#include "scenes/scenes.hpp"
#include "scenes/shapes.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

// The box as measured by the Program of Computer Graphics, Cornell University ("Cornell Box Data"), in millimetres:
// x to the left, y up, z away from the camera. Ten times larger here, a room, so that distances in metres that
// techniques choose for rooms fit it; and turned about the y axis, so that the camera looks along -Z.
constexpr float kCenterX = 278.0f, kCenterZ = 279.6f;

glm::vec3 place(float x, float y, float z) {
  return 0.01f * glm::vec3(kCenterX - x, y, kCenterZ - z);
}

// Linear BT.709 of the measured reflectances, as most renderers have them.
constexpr glm::vec3 kWhite{0.725f, 0.71f, 0.68f}, kRed{0.63f, 0.065f, 0.05f}, kGreen{0.14f, 0.45f, 0.091f};
// The light's measured emission, likewise, and its area: 130 x 105 mm, ten times larger.
constexpr glm::vec3 kPanelRadiance{17.0f, 12.0f, 4.0f};
constexpr float kPanelArea = 1.30f * 1.05f;  // m^2

Material matte(const char* name, const glm::vec3& color) {
  Material m;
  m.name = name;
  m.base_color = glm::vec4(color, 1.0f);
  m.metallic = 0.0f;
  m.specular = 0.0f;  // the measured paints have no gloss
  return m;
}

void add_room(SceneBuilder& builder, std::uint32_t white) {
  const glm::vec3 floor_left = place(552.8f, 0, 0), floor_right = place(0, 0, 0), floor_far_right = place(0, 0, 559.2f),
                  floor_far_left = place(549.6f, 0, 559.2f);
  const glm::vec3 top_left = place(556, 548.8f, 0), top_right = place(0, 548.8f, 0),
                  top_far_right = place(0, 548.8f, 559.2f), top_far_left = place(556, 548.8f, 559.2f);
  const auto red = builder.add_material(matte("red", kRed)), green = builder.add_material(matte("green", kGreen));
  const auto add = [&](const char* name, const std::array<glm::vec3, 4>& corners, std::uint32_t material) {
    builder.place_mesh(builder.add_mesh(name, quad(corners), material), glm::vec3(0.0f));
  };
  add("floor", {floor_left, floor_right, floor_far_right, floor_far_left}, white);
  add("ceiling", {top_far_left, top_far_right, top_right, top_left}, white);
  add("back wall", {floor_far_left, floor_far_right, top_far_right, top_far_left}, white);
  add("left wall", {floor_left, floor_far_left, top_far_left, top_left}, red);
  add("right wall", {floor_far_right, floor_right, top_right, top_far_right}, green);
}

void add_blocks(SceneBuilder& builder, std::uint32_t white) {
  const std::array<glm::vec3, 4> low{place(130, 0, 65), place(290, 0, 114), place(240, 0, 272), place(82, 0, 225)};
  const std::array<glm::vec3, 4> tall{place(423, 0, 247), place(472, 0, 406), place(314, 0, 456), place(265, 0, 296)};
  const auto counter_clockwise = [](const std::array<glm::vec3, 4>& b) {
    const bool faces_up = glm::cross(b[2] - b[0], b[3] - b[1]).y > 0.0f;
    return faces_up ? b : std::array{b[3], b[2], b[1], b[0]};
  };
  builder.place_mesh(builder.add_mesh("low block", block(counter_clockwise(low), 1.65f), white), glm::vec3(0.0f));
  builder.place_mesh(builder.add_mesh("tall block", block(counter_clockwise(tall), 3.30f), white), glm::vec3(0.0f));
}

// A spot light stands in for the light's area, with the same flux: the light sends pi L A; a spot of outer cone 90
// degrees and inner cone 0 falls off with the squared cosine (KHR_lights_punctual) and sends 2 pi I / 3.
// The panel only shows where the light is: at radiance 1 it adds some twentieth to it.
void add_panel(SceneBuilder& builder) {
  constexpr float kBelowCeiling = 547.8f;  // a millimetre, so that the two do not coincide
  Material panel = matte("lamp", glm::vec3(0.0f));
  panel.emissive = kPanelRadiance / kPanelRadiance.x;
  const auto mesh = builder.add_mesh("lamp",
                                     quad({place(343, kBelowCeiling, 332), place(213, kBelowCeiling, 332),
                                           place(213, kBelowCeiling, 227), place(343, kBelowCeiling, 227)}),
                                     builder.add_material(std::move(panel)));
  builder.place_mesh(mesh, glm::vec3(0.0f));
  Light light;
  light.name = "lamp";
  light.kind = LightKind::spot;
  light.color = kPanelRadiance / kPanelRadiance.x;
  light.intensity = 1.5f * kPanelRadiance.x * kPanelArea;
  light.inner_cone = 0.0f;
  light.outer_cone = glm::half_pi<float>();
  const glm::quat down = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1, 0, 0));
  builder.place_light(std::move(light), place(278, kBelowCeiling - 1.0f, 279.5f), down);
}

}  // namespace

Scene cornell_scene() {
  SceneBuilder builder("cornell");
  const auto white = builder.add_material(matte("white", kWhite));
  add_room(builder, white);
  add_blocks(builder, white);
  add_panel(builder);
  // As measured: 35 mm focal length before 25 mm of film.
  builder.place_camera(2.0f * std::atan(12.5f / 35.0f), 1.0f, place(278, 273, -800), place(278, 273, 0));
  return std::move(builder).take();
}

}  // namespace velarium::scene
