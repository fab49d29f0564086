#include "sun_shade.hpp"

#include "support/gltf_writer.hpp"
#include "support/settings.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::test {

std::vector<float> shadow_of(const Scene& scene, const RenderRequest& wanted) {
  RenderRequest bare = wanted;
  bare.settings.sun_shadows.enabled = false;
  const Picture lit = picture_of(scene, bare), shadowed = picture_of(scene, wanted);
  std::vector<float> share;
  for (std::size_t i = 0; i < lit.linear.size(); i += 4)
    share.push_back(lit.linear[i] > 0.0f ? shadowed.linear[i] / lit.linear[i] : 1.0f);
  return share;
}

Scene tilted_plane(float tilt) {
  GltfWriter scene;
  scene.add_quad(scene.add_material({}), {0, 0, 0}, {0, 1, 0}, {12, 12});
  const float turn = glm::radians(tilt);
  scene.add_light({.type = "directional",
                   .intensity = 10.0f,
                   .direction = {-std::sin(turn) * 0.8f, -std::cos(turn), -std::sin(turn) * 0.6f},
                   .extras = {{"angular_radius", 0.00465f}}});
  return scene.load();
}

float darkest_on_plane(const Scene& plane, const std::string& options) {
  RenderRequest view = linear_request(64, 64);
  view.look_at = LookAt{.eye = {3.0f, 2.5f, 4.0f}, .vertical_fov_deg = 40.0f};
  set_options(view.settings, options);
  const auto share = shadow_of(plane, view);
  return *std::min_element(share.begin(), share.end());
}

}  // namespace velarium::test
