// What an engine does ahead changes no picture, and what a scene does not need is not made.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/pictures.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

namespace velarium::test {
namespace {

RenderRequest request() {
  RenderRequest request;
  request.width = 96;
  request.height = 64;
  request.environment = "sky";
  request.settings.frame.spp = 2;
  return request;
}

Scene box(const std::string& alpha_mode) {
  GltfWriter writer;
  const int material = writer.add_material({.base_color = {0.8f, 0.4f, 0.2f, 0.5f}, .alpha_mode = alpha_mode});
  writer.add_box(material, {0, 0, 0}, {1, 1, 1});
  writer.add_light({.intensity = 5.0f, .position = {1.0f, 2.0f, 1.0f}});
  return writer.load();
}

TEST(Prepare, APreparedEngineDrawsTheSamePicture) {
  const Scene scene = box("OPAQUE");
  const Picture expected = Engine(validated()).picture(scene, request());
  Engine engine(validated());
  engine.prepare(request());
  const Picture actual = engine.picture(scene, request());
  EXPECT_EQ(actual.width, 96u);
  EXPECT_TRUE(actual.display == expected.display);
  EXPECT_TRUE(actual.linear == expected.linear);
}

TEST(Prepare, TwiceAndForAnotherSizeDoesNoHarm) {
  RenderRequest other = request();
  other.width = 64;
  engine().prepare(other);
  engine().prepare(request());
  const Scene scene = box("OPAQUE");
  const Picture first = engine().picture(scene, request());
  engine().prepare(other);
  EXPECT_TRUE(engine().picture(scene, request()).display == first.display);
}

TEST(Prepare, AMissingEnvironmentIsSaidAhead) {
  RenderRequest missing = request();
  missing.environment = "no/such.hdr";
  EXPECT_THROW(engine().prepare(missing), Error);
}

TEST(Prepare, OpaqueScenesHaveNoPassForBlending) {
  EXPECT_EQ(passes_named(engine().render(box("OPAQUE"), request()).report, "forward"), 0u);
  EXPECT_GT(passes_named(engine().render(box("BLEND"), request()).report, "forward"), 0u);
}

}  // namespace
}  // namespace velarium::test
