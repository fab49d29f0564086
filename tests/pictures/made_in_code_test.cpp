// A scene that a program describes looks as the same scene in a file does, to the bit, in both renderers.

#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/reference.hpp>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace velarium::test {
namespace {

std::vector<std::uint8_t> checks(std::array<std::uint8_t, 3> first, std::array<std::uint8_t, 3> second) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 16; ++i) {
    const auto& color = (i + i / 4) % 2 == 0 ? first : second;
    rgba.insert(rgba.end(), {color[0], color[1], color[2], 255});
  }
  return rgba;
}

// Both ways to say the same scene are filled beside each other.
struct Twins {
  GltfWriter file;
  SceneDescription code;

  void add_image(const std::vector<std::uint8_t>& rgba) {
    file.add_image({4, 4, rgba});
    code.images.push_back({.width = 4, .height = 4, .rgba = rgba});
  }

  void add_mesh(const TestMaterial& in_file, const MaterialDescription& in_code, const TestMesh& mesh,
                const TestPlace& place) {
    const auto array3 = [](const glm::vec3& v) { return std::array{v.x, v.y, v.z}; };
    file.add_mesh(file.add_material(in_file), mesh, place);
    MeshDescription described{.indices = mesh.indices, .material = static_cast<std::uint32_t>(code.materials.size())};
    for (const glm::vec3& p : mesh.positions) described.positions.push_back(array3(p));
    for (const glm::vec3& n : mesh.normals) described.normals.push_back(array3(n));
    for (const glm::vec2& t : mesh.uv) described.uv.push_back({t.x, t.y});
    code.nodes.push_back({.parent = 0,
                          .mesh = static_cast<std::uint32_t>(code.meshes.size()),
                          .translation = array3(place.translation),
                          .rotation = {place.rotation.x, place.rotation.y, place.rotation.z, place.rotation.w},
                          .scale = array3(place.scale)});
    code.materials.push_back(in_code);
    code.meshes.push_back(std::move(described));
  }
};

TestMesh square(float half) {
  return {.positions = {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}},
          .normals = std::vector<glm::vec3>(4, {0, 2, 0}),  // brought to unit length
          .uv = {{0, 3}, {3, 3}, {3, 0}, {0, 0}},
          .indices = {0, 1, 2, 0, 2, 3}};
}

// Without normals, and without indices.
TestMesh pyramid() {
  const glm::vec3 a(-1, 0, 1), b(1, 0, 1), c(1, 0, -1), d(-1, 0, -1), top(0, 1.5f, 0);
  return {.positions = {a, b, top, b, c, top, c, d, top, d, a, top}};
}

void add_surfaces(Twins& twins) {
  twins.add_image(checks({220, 200, 180}, {40, 60, 90}));
  twins.add_image(checks({128, 128, 255}, {170, 110, 235}));  // slopes of a normal map
  twins.add_mesh({.perceptual_roughness = 0.5f, .specular = 1, .base_color_image = 0, .normal_image = 1},
                 {.base_color_texture = {.image = 0}, .perceptual_roughness = 0.5f, .normal_texture = {.image = 1}},
                 square(4), {});
  twins.add_mesh({.base_color = {0.9f, 0.6f, 0.3f, 1}, .metallic = 1, .perceptual_roughness = 0.3f, .specular = 1},
                 {.base_color = {0.9f, 0.6f, 0.3f, 1}, .metallic = 1, .perceptual_roughness = 0.3f}, pyramid(),
                 {.translation = {-0.8f, 0.1f, 0}, .rotation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0))});
  twins.add_mesh({.base_color = {0.2f, 0.2f, 0.2f, 1}, .specular = 1, .emissive = {0.2f, 0.4f, 0.1f}},
                 {.base_color = {0.2f, 0.2f, 0.2f, 1}, .emissive = {0.2f, 0.4f, 0.1f}}, pyramid(),
                 {.translation = {1.2f, 0, 0.6f}, .scale = {0.4f, -0.6f, 0.4f}});  // mirrored
  twins.add_mesh({.base_color = {0.2f, 0.5f, 0.8f, 0.5f}, .specular = 1, .double_sided = true, .alpha_mode = "BLEND"},
                 {.base_color = {0.2f, 0.5f, 0.8f, 0.5f}, .alpha_mode = AlphaMode::blend, .double_sided = true},
                 square(0.7f),
                 {.translation = {0.5f, 0.8f, 1.2f}, .rotation = glm::angleAxis(1.2f, glm::vec3(1, 0, 0))});
}

void add_lights(Twins& twins) {
  twins.file.add_light({.type = "directional",
                        .intensity = 0.8f,
                        .direction = {1, -2, -1},
                        .extras = {{"angular_radius", glm::radians(0.5f)}}});
  twins.file.add_light({.intensity = 3,
                        .color = {1, 0.8f, 0.5f},
                        .position = {-1.5f, 2, 1.5f},
                        .direction = {1, 0, -1},
                        .extras = {{"radius", 0.2f}, {"falloff", "bulb"}, {"cutoff", 6}, {"casts_shadow", false}}});
  twins.file.add_light({.type = "spot",
                        .intensity = 30,
                        .inner_cone = glm::radians(10.0f),
                        .outer_cone = glm::radians(35.0f),
                        .position = {2, 2, 2},
                        .direction = {-2, -2, -2},
                        .extras = {{"projector", {{"image", 0}, {"field_of_view", glm::radians(50.0f)}}}}});
  twins.code.lights = {{.kind = LightKind::directional,
                        .parent = 0,
                        .direction = {1, -2, -1},
                        .intensity = 0.8f,
                        .angular_radius_deg = 0.5f},
                       {.parent = 0,
                        .position = {-1.5f, 2, 1.5f},
                        .direction = {1, 0, -1},
                        .color = {1, 0.8f, 0.5f},
                        .intensity = 3,
                        .falloff = LightFalloff::bulb,
                        .range_m = 6,
                        .radius_m = 0.2f,
                        .casts_shadow = false},
                       {.kind = LightKind::spot,
                        .parent = 0,
                        .position = {2, 2, 2},
                        .direction = {-2, -2, -2},
                        .intensity = 30,
                        .inner_cone_deg = 10,
                        .outer_cone_deg = 35,
                        .projected_image = 0,
                        .projected_fov_deg = 50}};
}

Twins make_twins() {
  Twins twins;
  twins.code.nodes.emplace_back();  // as the writer hangs everything below one
  add_surfaces(twins);
  add_lights(twins);
  return twins;
}

RenderRequest view() {
  RenderRequest request{.width = 64, .height = 48, .environment = "studio"};
  request.look_at = LookAt{.eye = {1, 3, 5}, .target = {0, 0.4f, 0}};
  request.settings.frame.spp = 2;
  request.settings.reference.spp = 2;
  return request;
}

void expect_equal(const Picture& a, const Picture& b) {
  EXPECT_EQ(largest_error(a.linear, b.linear), 0.0);
  EXPECT_TRUE(a.display == b.display);
  EXPECT_TRUE(compare(bytes_of(a), bytes_of(b), {0, 0.0}).same);  // which refuses pictures of one colour
}

TEST(MadeInCode, RendersAsItsFile) {
  const Twins twins = make_twins();
  expect_equal(picture_of(Scene::make(twins.code), view()), picture_of(twins.file.load(), view()));
}

TEST(MadeInCode, IsTracedAsItsFile) {
  const Twins twins = make_twins();
  expect_equal(render_reference(Scene::make(twins.code), {.view = view()}).picture,
               render_reference(twins.file.load(), {.view = view()}).picture);
}

Picture traced(const SceneDescription& description) {
  return render_reference(Scene::make(description), {.view = view()}).picture;
}

// That the pictures above would show a difference: each of these is one.
TEST(MadeInCode, EveryPartIsSeen) {
  const Twins twins = make_twins();
  const Picture whole = traced(twins.code);
  for (std::size_t i = 0; i < twins.code.lights.size(); ++i) {
    SceneDescription less = twins.code;
    less.lights.erase(less.lights.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_GT(largest_error(traced(less).linear, whole.linear), 0.01) << "light " << i;
  }
  for (std::size_t i = 1; i < twins.code.nodes.size(); ++i) {
    SceneDescription less = twins.code;
    less.nodes[i].mesh.reset();
    EXPECT_GT(largest_error(traced(less).linear, whole.linear), 0.01) << "node " << i;
  }
}

}  // namespace
}  // namespace velarium::test
