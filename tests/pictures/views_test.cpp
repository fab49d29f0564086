// Several views in one graph, and views that do not stand where world space has its origin.

#include "support/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSize = 48;
constexpr glm::vec3 kEye{0.1f, 1.1f, 0.2f};

struct Face {
  const char* name;
  glm::vec3 forward, up;
};
constexpr std::array kFaces{Face{"face+x", {1, 0, 0}, {0, 1, 0}}, Face{"face-x", {-1, 0, 0}, {0, 1, 0}},
                            Face{"face+y", {0, 1, 0}, {0, 0, 1}}, Face{"face-y", {0, -1, 0}, {0, 0, -1}},
                            Face{"face+z", {0, 0, 1}, {0, 1, 0}}, Face{"face-z", {0, 0, -1}, {0, 1, 0}}};

RenderRequest request_of(bool local_shadows) {
  RenderRequest request;
  request.width = request.height = kSize;
  request.want_display = false;
  request.settings.frame.spp = 1;
  request.settings.local_shadows.enabled = local_shadows;
  request.settings.local_shadows.atlas = 512;
  request.settings.sun_shadows.size = 512;
  return request;
}

// A view with all that it draws its frame with. `origin`: of world space.
struct Eye {
  upload::View view;
  frame::State state;
  frame::Prepared prepared;
  gpu::Image sum;

  Eye(const upload::Tables& tables, const scene::SceneSnapshot& snapshot, const scene::CameraInstance& camera,
      const RenderRequest& request) {
    auto& device = gpu_context().device;
    view = upload::make_view(device, tables, snapshot, upload::view_matrices(camera, 1.0f), {kSize, kSize}, 1000);
    prepared = frame::prepare(state, device, tables, view, request.settings);
    sum = gpu::Image(device, {VK_FORMAT_R32G32B32A32_SFLOAT, kSize, kSize},
                     VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  }
};

// The frames of all eyes in one graph, run at once: a linear picture each.
std::vector<std::vector<float>> draw_together(const upload::Tables& tables, std::vector<std::unique_ptr<Eye>>& eyes,
                                              const std::vector<const char*>& names) {
  frame::Constants constants(gpu_context().device);
  graph::Executor executor(gpu_context());
  graph::Graph graph(executor.history());
  std::vector<graph::GraphBuffer> outputs;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    Eye& eye = *eyes[i];
    const auto scope = graph.scope(names[i]);
    frame::add_frame(graph, {.tables = tables,
                             .view = eye.view,
                             .state = eye.state,
                             .brdf_table = constants.brdf_table(ShadingModel::gltf),
                             .normal_lengths = constants.normal_lengths(),
                             .sum = eye.sum,
                             .before = {&tables, &eye.view, {}},
                             .settings = eye.prepared.settings});
    outputs.push_back(
        frame::add_display(
            graph, {.sum = eye.sum, .settings = eye.prepared.settings, .want_linear = true, .want_display = false})
            .linear);
  }
  executor.run(graph);
  std::vector<std::vector<float>> pictures;
  for (const auto output : outputs) {
    const auto mapped = executor.buffer(output).mapped_as<float>();
    pictures.emplace_back(mapped.begin(), mapped.begin() + 4 * kSize * kSize);
  }
  return pictures;
}

std::vector<float> picture_of(const StillScene& scene, const scene::CameraInstance& camera,
                              const RenderRequest& request) {
  frame::Renderer renderer(gpu_context());
  return renderer.render({*scene.gpu, scene.snapshot, camera, nullptr, request}).picture.linear;
}

class CubeFaces : public testing::TestWithParam<bool> {};

// With maps of points and spots off, and with maps planned for each view.
TEST_P(CubeFaces, OfOneGraphAreThoseOfSixPictures) {
  const StillScene scene("cornell");
  const RenderRequest request = request_of(GetParam());
  const auto tables = upload::make_tables(gpu_context().device, *scene.gpu, scene.snapshot, glm::dvec3(kEye));
  std::vector<std::unique_ptr<Eye>> eyes;
  std::vector<const char*> names;
  for (const Face& face : kFaces) {
    eyes.push_back(std::make_unique<Eye>(tables, scene.snapshot, cube_camera(kEye, face.forward, face.up), request));
    names.push_back(face.name);
  }
  const auto faces = draw_together(tables, eyes, names);
  bool any_light = false;
  for (std::size_t i = 0; i < kFaces.size(); ++i) {
    const auto alone = picture_of(scene, cube_camera(kEye, kFaces[i].forward, kFaces[i].up), request);
    EXPECT_TRUE(faces[i] == alone) << kFaces[i].name;
    any_light |= std::ranges::any_of(alone, [](float value) { return value > 0.1f && value < 1.0f; });
  }
  EXPECT_TRUE(any_light);
}

INSTANTIATE_TEST_SUITE_P(LocalShadows, CubeFaces, testing::Bool(),
                         [](const auto& row) { return row.param ? "On" : "Off"; });

// The share of pixels that differ by more than a hundredth of what a white surface gives.
double differing(const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > 0.01f ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(a.size());
}

// The same view from an origin at its eye and from one elsewhere, as the second of a pair of eyes has it: rounding may
// move outlines and edges of shadows by a pixel.
TEST(OffsetViews, LookAsFromTheirOwnOrigin) {
  for (const char* name : {"boxes", "boxes?light=point&radius=150", "cornell"}) {
    const StillScene scene(name);
    for (const LightingPath path : {LightingPath::tiled, LightingPath::volumes}) {
      RenderRequest request = request_of(true);
      request.settings.lighting.path = path;
      const auto camera = scene::choose_camera(scene.snapshot, "", 1.0f);
      const glm::dvec3 elsewhere = glm::dvec3(camera.world_from_view[3]) + glm::dvec3(0.7, -0.4, 0.3);
      const auto tables = upload::make_tables(gpu_context().device, *scene.gpu, scene.snapshot, elsewhere);
      std::vector<std::unique_ptr<Eye>> eyes;
      eyes.push_back(std::make_unique<Eye>(tables, scene.snapshot, camera, request));
      const auto offset = draw_together(tables, eyes, {"right"});
      EXPECT_LT(differing(offset[0], picture_of(scene, camera, request)), 0.01) << name;
    }
  }
}

}  // namespace
}  // namespace velarium::test
