// The five lines of the README: a scene in, a picture out.
#include <velarium/velarium.hpp>

int main() {
  velarium::Engine engine;
  const velarium::Scene scene = velarium::Scene::load("builtin:spheres");
  const velarium::Picture picture = engine.picture(scene, {.width = 640, .height = 360});
  picture.save("out.png");
}
