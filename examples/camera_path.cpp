// A camera that goes around a scene: one picture a step, orbit_00.png to orbit_07.png.
#include <velarium/velarium.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  constexpr int kSteps = 8;
  constexpr float kDistance = 8.0f, kHeight = 3.5f;  // metres

  velarium::Engine engine;  // keeps the scene on the device between pictures
  const velarium::Scene scene = velarium::Scene::load("builtin:spheres");
  velarium::RenderRequest request{.width = 320, .height = 180};
  request.settings.frame.spp = 4;

  for (int step = 0; step < kSteps; ++step) {
    const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(step) / kSteps;
    request.look_at = velarium::LookAt{.eye = {kDistance * std::sin(turn), kHeight, kDistance * std::cos(turn)},
                                       .target = {0, 0.5f, 0}};
    char name[16];
    std::snprintf(name, sizeof(name), "orbit_%02d.png", step);
    engine.picture(scene, request).save(name);
  }
}
