// A scene without a file: a gilded ball and a cut gem on a chequered floor, drawn to made.png.
#include <velarium/velarium.hpp>

#include <cmath>
#include <numbers>

namespace {

// Around the origin. Smooth, because every vertex has its normal.
velarium::MeshDescription ball(float radius, std::uint32_t rings, std::uint32_t segments) {
  constexpr float kPi = std::numbers::pi_v<float>;
  velarium::MeshDescription mesh{.name = "ball"};
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    for (std::uint32_t segment = 0; segment <= segments; ++segment) {
      const float polar = kPi * static_cast<float>(ring) / static_cast<float>(rings);
      const float around = 2 * kPi * static_cast<float>(segment) / static_cast<float>(segments);
      const float across = std::sin(polar);
      const std::array normal{across * std::sin(around), std::cos(polar), across * std::cos(around)};
      mesh.normals.push_back(normal);
      mesh.positions.push_back({radius * normal[0], radius * normal[1], radius * normal[2]});
      if (ring == rings || segment == segments) continue;
      const std::uint32_t above = ring * (segments + 1) + segment, below = above + segments + 1;
      mesh.indices.insert(mesh.indices.end(), {above, below, above + 1, above + 1, below, below + 1});
    }
  }
  return mesh;
}

// Facets, because no vertex has one.
velarium::MeshDescription gem(float radius, float height) {
  return {
      .name = "gem",
      .positions = {{radius, 0, 0}, {0, 0, -radius}, {-radius, 0, 0}, {0, 0, radius}, {0, height, 0}, {0, -height, 0}},
      .indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5}};
}

velarium::MeshDescription floor_of(float half) {
  const float squares = 2 * half;  // one a metre; the picture holds two by two
  return {.name = "floor",
          .positions = {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}},
          .normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}},
          .uv = {{0, squares / 2}, {squares / 2, squares / 2}, {squares / 2, 0}, {0, 0}},
          .indices = {0, 1, 2, 0, 2, 3}};
}

velarium::SceneDescription still_life() {
  velarium::SceneDescription scene{.name = "still life"};
  scene.images = {{.name = "chequers",
                   .width = 2,
                   .height = 2,
                   .rgba = {235, 230, 220, 255, 60, 66, 80, 255, 60, 66, 80, 255, 235, 230, 220, 255}}};
  scene.materials = {
      {.name = "tiles",
       .base_color_texture = {.image = 0, .filter = velarium::TextureFilter::nearest},
       .perceptual_roughness = 0.5f},
      {.name = "gold", .base_color = {1.0f, 0.77f, 0.34f, 1}, .metallic = 1, .perceptual_roughness = 0.25f},
      {.name = "ruby", .base_color = {0.6f, 0.02f, 0.05f, 1}, .perceptual_roughness = 0.1f, .ior = 1.77f}};

  scene.meshes = {floor_of(8), ball(0.8f, 32, 64), gem(0.5f, 0.7f)};
  for (std::uint32_t i = 0; i < 3; ++i) scene.meshes[i].material = i;
  scene.nodes = {{.mesh = 0},
                 {.mesh = 1, .translation = {-0.7f, 0.8f, 0}},
                 {.mesh = 2, .translation = {0.9f, 0.7f, 0.5f}, .rotation = {0, 0.2588f, 0, 0.9659f}}};  // 30 degrees

  scene.lights = {
      {.name = "lamp",
       .kind = velarium::LightKind::spot,
       .position = {3, 4, 2},
       .direction = {-3, -3.5f, -2},
       .intensity = 150,  // candela
       .radius_m = 0.15f,
       .inner_cone_deg = 15,
       .outer_cone_deg = 30},
      {.name = "sky", .kind = velarium::LightKind::directional, .direction = {1, -2, -1}, .intensity = 0.6f}};
  scene.cameras = {{.name = "front", .view = {.eye = {0.6f, 2, 5}, .target = {0, 0.6f, 0}, .vertical_fov_deg = 35}}};
  return scene;
}

}  // namespace

int main() {
  velarium::Engine engine;
  const velarium::Scene scene = velarium::Scene::make(still_life());
  velarium::RenderRequest request{.width = 320, .height = 180, .environment = "studio"};
  request.settings.environment.intensity = 0.5f;
  engine.picture(scene, request).save("made.png");
}
