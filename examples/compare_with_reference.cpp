// How far a picture is from the truth: renders a view, traces the paths of the same view, and compares the two. Reads
// an image from inside the frame on the way: the depth buffer.
#include <velarium/velarium.hpp>

#include <cstdio>

namespace {

// Of a layer of the reference.
const velarium::PictureLayer& layer(const velarium::Picture& picture, const char* name) {
  for (const velarium::PictureLayer& found : picture.layers)
    if (found.name == name) return found;
  throw velarium::Error(velarium::ErrorCode::usage, std::string("no layer ") + name);
}

}  // namespace

int main() {
  const velarium::Scene scene = velarium::Scene::load("builtin:boxes?light=point&radius=100");
  velarium::RenderRequest view{.width = 160, .height = 90, .dumps = {"gbuffer.depth"}};
  view.settings.frame.spp = 8;
  view.settings.reference.spp = 16;  // paths a pixel

  velarium::Engine engine;
  const velarium::RenderResult rendered = engine.render(scene, view);
  const velarium::ReferenceResult traced = velarium::render_reference(scene, {.view = view});

  // Depth is the camera's near plane over the distance along its axis. The first of four channels holds it.
  const velarium::DumpedImage& depth = rendered.dumps.front();
  const std::size_t middle = std::size_t{depth.height / 2} * depth.width + depth.width / 2;
  const float near_m = scene.info().cameras.front().near_m;
  std::printf("middle rendered %.3f m, traced %.3f m\n", static_cast<double>(near_m / depth.rgba[4 * middle]),
              static_cast<double>(layer(traced.picture, "depth").values[middle]));

  const velarium::Comparison found = velarium::compare(rendered.picture, traced.picture);
  std::printf("FLIP %.4f, relative error %.4f\n", found.flip, found.relmse);
  rendered.picture.save("rendered.png");
  traced.picture.save("traced.png");
  velarium::error_picture(found).save("difference.png");
}
