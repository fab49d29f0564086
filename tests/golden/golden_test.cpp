// Small pictures against accepted ones. tools/accept.py accepts what a run of this program has drawn.

#include "driver_tolerance.hpp"
#include "support/device.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <velarium/error.hpp>
#include <velarium/files.hpp>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

struct Golden {
  const char* name;
  const char* scene;         // "builtin:NAME", or a file of tests/data
  const char* options = "";  // KEY=VALUE, parted by spaces
  const char* environment = "";
  const char* camera = "";
  float time_s = 0.0f;
  Background background = Background::environment;
  const char* variant = "";
  Tolerance tolerance = {};
  const char* why = "";  // of a tolerance that is looser than the usual one
};

// 256 x 192 pixels, four frames, without dither, whose noise hardly packs; but for what the options say.
constexpr Golden kGoldens[] = {
    {.name = "atrium", .scene = "builtin:atrium"},
    {.name = "atrium_torches", .scene = "builtin:atrium?sun=off"},
    {.name = "atrium_pool", .scene = "builtin:atrium", .camera = "pool"},
    {.name = "spheres", .scene = "builtin:spheres"},
    {.name = "spheres_ryse", .scene = "builtin:spheres", .options = "lighting.model=ryse"},
    {.name = "spheres_turned", .scene = "builtin:spheres", .options = "environment.rotation=90 display.tonemap=agx"},
    {.name = "spheres_automatic",
     .scene = "builtin:spheres",
     .options = "display.exposure_mode=automatic display.tonemap=aces"},
    {.name = "cornell", .scene = "builtin:cornell"},
    {.name = "furnace_studio", .scene = "builtin:furnace", .environment = "studio"},
    {.name = "sun_far",
     .scene = "builtin:boxes?radius=30&sheet=off",
     .options = "sun_shadows.distance=4.5 sun_shadows.cascades=2 far_shadows.size=512"},
    {.name = "sun_static",
     .scene = "builtin:boxes?radius=30&sheet=off",
     .options = "sun_shadows.distance=4.5 far_shadows.kind=static_map far_shadows.static_size=2048"},
    {.name = "triangle", .scene = "triangle.gltf", .options = "display.dither=on"},
    {.name = "triangle_transparent",
     .scene = "triangle.gltf",
     .environment = "studio",
     .background = Background::transparent},
    {.name = "wrap_modes", .scene = "wrap_modes.gltf"},
    {.name = "vertex_colors", .scene = "vertex_colors.gltf"},
    {.name = "sparse", .scene = "sparse.gltf"},
    {.name = "sparse_fitted", .scene = "sparse.gltf", .options = "frame.spp=1", .camera = "auto"},
    {.name = "primitive_modes", .scene = "primitive_modes.gltf"},
    {.name = "morph_cube", .scene = "morph_cube.gltf"},
    {.name = "morph_cube_1s", .scene = "morph_cube.gltf", .time_s = 1.0f},
    {.name = "skinned_bar", .scene = "skinned_bar.gltf"},
    {.name = "skinned_bar_1s", .scene = "skinned_bar.gltf", .time_s = 1.0f},
    {.name = "mirrored_and_masked", .scene = "mirrored_and_masked.gltf"},
    {.name = "blend_layers", .scene = "blend_layers.gltf"},
    {.name = "blend_layers_over_color", .scene = "blend_layers.gltf", .background = Background::color},
    {.name = "lights", .scene = "lights.gltf"},
    {.name = "clip_volumes", .scene = "clip_volumes.gltf"},
    {.name = "ambient_lights", .scene = "ambient_lights.gltf"},
    {.name = "area_lights", .scene = "area_lights.gltf"},
    {.name = "projectors", .scene = "projectors.gltf"},
    {.name = "boxes_sheet_sun", .scene = "builtin:boxes?radius=30"},
    {.name = "boxes_sheet_point", .scene = "builtin:boxes?light=point"},
    {.name = "boxes_sheet_spot", .scene = "builtin:boxes?light=spot&radius=150"},
    {.name = "texture_transform", .scene = "texture_transform.gltf"},
    {.name = "unlit", .scene = "unlit.gltf"},
    {.name = "emissive_strength", .scene = "emissive_strength.gltf"},
    {.name = "specular_and_ior", .scene = "specular_and_ior.gltf"},
    {.name = "quantized", .scene = "quantized.gltf"},
    {.name = "normal_map", .scene = "normal_map.gltf"},
    {.name = "bumpy_metal", .scene = "bumpy_metal.gltf"},
    {.name = "orthographic", .scene = "orthographic.gltf"},
    {.name = "embedded", .scene = "embedded.glb"},
    {.name = "vase", .scene = "vase.gltf"},
    {.name = "vase_draco", .scene = "vase_draco.gltf"},
    {.name = "vase_meshopt", .scene = "vase_meshopt.gltf"},
    {.name = "gpu_instancing", .scene = "gpu_instancing.gltf"},
    {.name = "webp_texture", .scene = "webp_texture.gltf"},
    {.name = "variants", .scene = "variants.gltf"},
    {.name = "variants_walnut", .scene = "variants.gltf", .variant = "walnut"},
    {.name = "variants_steel", .scene = "variants.gltf", .variant = "2"},
    {.name = "specular_glossiness", .scene = "specular_glossiness.gltf"},
    {.name = "metallic_roughness", .scene = "metallic_roughness.gltf"},
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

RenderRequest request_of(const Golden& golden) {
  RenderRequest request;
  request.width = 256;
  request.height = 192;
  request.want_linear = false;
  request.environment = golden.environment;
  request.camera = golden.camera;
  request.time_s = golden.time_s;
  request.background = golden.background;
  request.background_color = {0.2f, 0.4f, 0.6f};
  request.settings.display.dither = false;
  set_options(request.settings, golden.options);
  return request;
}

Scene load(const Golden& golden) {
  const std::string scene = golden.scene;
  LoadOptions options;
  options.variant = golden.variant;
  return Scene::load(scene.starts_with("builtin:") ? fs::path(scene) : fs::path(VELARIUM_TEST_DATA) / scene, options);
}

image::ByteImage read_png(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw Error(ErrorCode::input_missing, file, "no accepted picture; look at the actual one, then accept it");
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return image::decode(std::as_bytes(std::span(bytes)), file.string());
}

// Where this run leaves its pictures: actual/NAME.png always, difference/NAME.png of those that differ.
fs::path results() {
  const char* folder = std::getenv("VELARIUM_GOLDEN_OUT");
  return folder != nullptr ? fs::path(folder) : fs::current_path() / "golden";
}

// What drew the pictures, for tools/accept.py.
void write_device(const std::string& name) {
  const fs::path file = results() / "actual" / "device.json";
  if (fs::exists(file)) return;
  for (const auto& device : list_devices()) {
    if (device.name != name) continue;
    const nlohmann::json json{{"device", device.name}, {"driver", device.driver}};
    write_text(file, json.dump(2) + "\n");
    return;
  }
}

class Pictures : public testing::TestWithParam<Golden> {
 protected:
  static void SetUpTestSuite() {
    fs::create_directories(results() / "actual");
    fs::create_directories(results() / "difference");
    fs::remove(results() / "actual" / "device.json");
  }
};

TEST_P(Pictures, LookAsAccepted) {
  const Golden& golden = GetParam();
  const std::string file = std::string(golden.name) + ".png";
  const auto result = engine().render(load(golden), request_of(golden));
  const auto actual = bytes_of(result.picture);
  const fs::path difference = results() / "difference" / file;
  fs::remove(difference);
  image::save_png(results() / "actual" / file, actual);
  write_device(result.report.device);

  const auto accepted = read_png(fs::path(VELARIUM_GOLDENS) / file);
  const Tolerance tolerance = tolerance_on(result.report.device, golden.name, golden.tolerance);
  const Verdict verdict = compare(actual, accepted, tolerance);
  if (verdict.same) return;
  if (actual.rgba.size() == accepted.rgba.size()) image::save_png(difference, difference_picture(actual, accepted));
  ADD_FAILURE() << golden.name << ": " << verdict.says << "\n  actual: " << (results() / "actual" / file).string()
                << "\n  difference: " << difference.string();
}

INSTANTIATE_TEST_SUITE_P(Golden, Pictures, testing::ValuesIn(kGoldens),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(GoldenTable, LooserTolerancesSayWhy) {
  for (const Golden& golden : kGoldens) {
    const bool looser =
        golden.tolerance.max_error > Tolerance{}.max_error || golden.tolerance.share > Tolerance{}.share;
    EXPECT_EQ(looser, *golden.why != '\0') << golden.name;
  }
}

TEST(GoldenTable, HoldsEveryAcceptedPictureAndEverySceneOfTheTestData) {
  const auto in_table = [](const auto& predicate) {
    return std::any_of(std::begin(kGoldens), std::end(kGoldens), predicate);
  };
  for (const auto& entry : fs::directory_iterator(VELARIUM_GOLDENS)) {
    if (entry.path().extension() != ".png") continue;
    EXPECT_TRUE(in_table([&](const Golden& golden) { return entry.path().stem() == golden.name; })) << entry.path();
  }
  for (const auto& entry : fs::directory_iterator(VELARIUM_TEST_DATA)) {
    if (!entry.path().extension().string().starts_with(".gl")) continue;
    EXPECT_TRUE(in_table([&](const Golden& golden) { return entry.path().filename() == golden.scene; }))
        << entry.path();
  }
}

}  // namespace
}  // namespace velarium::test
