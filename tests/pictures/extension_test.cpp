// Files that say the same in other words must look the same.

#include "support/device.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"

#include <velarium/scene.hpp>

#include <gtest/gtest.h>

#include <filesystem>

namespace velarium::test {
namespace {

image::ByteImage drawn(const char* file) {
  RenderRequest request = display_request(256, 192);
  request.settings.frame.spp = 4;
  return bytes_of(picture_of(Scene::load(std::filesystem::path(VELARIUM_TEST_DATA) / file), request));
}

void expect_same(const char* file, const char* other, const Tolerance& tolerance) {
  const Verdict verdict = compare(drawn(file), drawn(other), tolerance);
  EXPECT_TRUE(verdict.same) << file << " and " << other << ": " << verdict.says;
}

// 14 bits of a vase 1.6 m tall are steps of 0.1 mm, a sixtieth of a pixel here; normals are exact to 6e-5.
TEST(Extensions, DracoLooksLikeWhatItCompresses) {
  expect_same("vase_draco.gltf", "vase.gltf", {});
}

// Positions are exact to 2^-16 m. Normals in bytes are off by up to 0.6 degrees, which shifts the highlight.
TEST(Extensions, MeshoptLooksLikeWhatItCompresses) {
  expect_same("vase_meshopt.gltf", "vase.gltf", {.max_error = 8, .share = 0.002});
}

// The factors of these files mean the same, and their texels are what one becomes of the other.
TEST(Extensions, SpecularAndGlossinessLooksLikeMetalAndRoughness) {
  expect_same("specular_glossiness.gltf", "metallic_roughness.gltf", {.max_error = 1, .share = 0.0});
}

// That the test above can fail.
TEST(Extensions, DifferentFilesLookDifferent) {
  EXPECT_FALSE(compare(drawn("vase.gltf"), drawn("metallic_roughness.gltf"), {}).same);
}

}  // namespace
}  // namespace velarium::test
