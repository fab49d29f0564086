// Draws a glTF scene with Filament 1.9: sun with shadow, environment, FXAA. Prints the median of the frames after the
// first, and writes the last as PPM.
//
// filament_peer LIGHT SCENE OUT.ppm WIDTH HEIGHT FRAMES EYE_X EYE_Y EYE_Z TARGET_X TARGET_Y TARGET_Z FOV
// LIGHT_ibl.ktx and LIGHT_skybox.ktx come from cmgen.

#include <filament/Camera.h>
#include <filament/Engine.h>
#include <filament/Fence.h>
#include <filament/IndirectLight.h>
#include <filament/LightManager.h>
#include <filament/Renderer.h>
#include <filament/Scene.h>
#include <filament/Skybox.h>
#include <filament/SwapChain.h>
#include <filament/Texture.h>
#include <filament/View.h>
#include <filament/Viewport.h>
#include <gltfio/AssetLoader.h>
#include <gltfio/FilamentAsset.h>
#include <gltfio/MaterialProvider.h>
#include <gltfio/ResourceLoader.h>
#include <image/KtxBundle.h>
#include <image/KtxUtility.h>
#include <utils/EntityManager.h>
#include <utils/NameComponentManager.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using filament::math::float3;

std::vector<uint8_t> read_file(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void add_light(filament::Engine& engine, filament::Scene& scene, const std::string& base) {
  const auto bundle = [](const std::string& name) {
    const auto bytes = read_file(name);
    return new image::KtxBundle(bytes.data(), static_cast<uint32_t>(bytes.size()));  // the texture takes it over
  };
  auto* reflections = bundle(base + "_ibl.ktx");
  float3 harmonics[9];
  reflections->getSphericalHarmonics(harmonics);
  constexpr float kIntensity = 30000.0f;  // Filament's own default, lux
  scene.setIndirectLight(filament::IndirectLight::Builder()
                             .reflections(image::ktx::createTexture(&engine, reflections, false))
                             .irradiance(3, harmonics)
                             .intensity(kIntensity)
                             .build(engine));
  auto* sky = image::ktx::createTexture(&engine, bundle(base + "_skybox.ktx"), false);
  scene.setSkybox(filament::Skybox::Builder().environment(sky).build(engine));
  const auto sun = utils::EntityManager::get().create();
  filament::LightManager::Builder(filament::LightManager::Type::SUN)
      .intensity(100000.0f)
      .direction({0.6f, -1.0f, -0.8f})
      .castShadows(true)
      .build(engine, sun);
  scene.addEntity(sun);
}

gltfio::FilamentAsset* add_model(filament::Engine& engine, filament::Scene& scene, const std::string& file) {
  auto* names = new utils::NameComponentManager(utils::EntityManager::get());
  auto* loader = gltfio::AssetLoader::create({&engine, gltfio::createUbershaderLoader(&engine), names});
  const auto bytes = read_file(file);
  const auto size = static_cast<uint32_t>(bytes.size());
  const bool binary = file.size() > 4 && file.compare(file.size() - 4, 4, ".glb") == 0;
  auto* asset =
      binary ? loader->createAssetFromBinary(bytes.data(), size) : loader->createAssetFromJson(bytes.data(), size);
  if (asset == nullptr) return nullptr;
  gltfio::ResourceConfiguration configuration{};
  configuration.engine = &engine;
  configuration.gltfPath = file.c_str();
  configuration.normalizeSkinningWeights = true;
  if (!gltfio::ResourceLoader(configuration).loadResources(asset)) return nullptr;
  scene.addEntities(asset->getEntities(), asset->getEntityCount());
  return asset;
}

// `done` becomes true in a later frame.
void read_pixels(filament::Renderer& renderer, uint32_t width, uint32_t height, std::vector<uint8_t>& pixels,
                 bool& done) {
  filament::backend::PixelBufferDescriptor target(
      pixels.data(), pixels.size(), filament::backend::PixelDataFormat::RGBA, filament::backend::PixelDataType::UBYTE,
      [](void*, size_t, void* flag) { *static_cast<bool*>(flag) = true; }, &done);
  renderer.readPixels(0, 0, width, height, std::move(target));
}

void write_ppm(const char* file, uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba) {
  std::ofstream out(file, std::ios::binary);
  out << "P6\n" << width << ' ' << height << "\n255\n";
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) out.write(reinterpret_cast<const char*>(&rgba[4 * (y * width + x)]), 3);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 14) return std::fprintf(stderr, "see the head of filament_peer.cpp\n"), 2;
  const auto number = [argv](int i) { return std::atof(argv[i]); };
  const auto width = static_cast<uint32_t>(number(4)), height = static_cast<uint32_t>(number(5));
  const int frames = std::max(2, static_cast<int>(number(6)));

  auto* engine = filament::Engine::create(filament::Engine::Backend::OPENGL);
  auto* swap_chain = engine->createSwapChain(width, height, 0);
  auto* renderer = engine->createRenderer();
  auto* scene = engine->createScene();
  auto* view = engine->createView();
  auto* camera = engine->createCamera(utils::EntityManager::get().create());
  view->setScene(scene);
  view->setCamera(camera);
  view->setViewport({0, 0, width, height});
  view->setAntiAliasing(filament::View::AntiAliasing::FXAA);
  add_light(*engine, *scene, argv[1]);
  auto* asset = add_model(*engine, *scene, argv[2]);
  if (asset == nullptr) return std::fprintf(stderr, "cannot load the scene\n"), 1;
  const float extent = length(asset->getBoundingBox().extent());
  camera->setProjection(number(13), static_cast<double>(width) / height, 0.01 * extent, 20.0 * extent);
  camera->lookAt(float3(number(7), number(8), number(9)), float3(number(10), number(11), number(12)), {0, 1, 0});
  camera->setExposure(16.0f, 1.0f / 125.0f, 100.0f);

  std::vector<uint8_t> pixels(std::size_t{4} * width * height);
  bool read = false;
  std::vector<double> times;
  for (int i = 0; i < frames || !read; ++i) {  // some more until the picture has arrived
    const auto start = std::chrono::steady_clock::now();
    while (!renderer->beginFrame(swap_chain)) {}
    renderer->render(view);
    if (i + 1 == frames) read_pixels(*renderer, width, height, pixels, read);
    renderer->endFrame();
    filament::Fence::waitAndDestroy(engine->createFence());
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    if (i > 0 && i < frames) times.push_back(passed.count());
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  std::printf("median frame: %.3f ms\n", times[times.size() / 2]);
  std::fflush(stdout);
  write_ppm(argv[3], width, height, pixels);
  std::_Exit(0);  // the engine's orderly end takes seconds and is not what is measured
}
