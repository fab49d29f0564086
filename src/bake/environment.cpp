#include "bake/environment.hpp"

#include "bake/environment_cube.hpp"
#include "bake/environment_sh.hpp"
#include "bake/environment_texels.hpp"
#include "bake/environment_transfer.hpp"
#include "bake/irradiance.hpp"
#include "bake/table_cache.hpp"
#include "core/files.hpp"
#include "core/jobs.hpp"
#include "gpu/cube_edges.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

#include <cstring>

#include "shading/host.hpp"

namespace velarium::bake {
namespace {

// To be raised whenever the same picture would bake to other bytes.
constexpr std::uint64_t kVersion = 3;

gpu::ImageDesc background_desc(const image::FloatImage& equirect) {
  return {.format = VK_FORMAT_R16G16B16A16_SFLOAT,
          .width = equirect.width,
          .height = equirect.height,
          .mips = gpu::full_mip_count(equirect.width, equirect.height)};
}

gpu::ImageDesc irradiance_desc() {
  return {.format = VK_FORMAT_R16G16B16A16_SFLOAT,
          .width = kIrradianceSize,
          .height = kIrradianceSize,
          .layers = 6,
          .cube = true};
}

void bake_irradiance(const image::FloatImage& equirect, std::span<std::byte> texels) {
  const auto values = irradiance_cube(equirect, kIrradianceSize);
  for (std::size_t i = 0; i < values.size(); ++i) {
    // The largest half: lights above it exist, irradiance above it does not in any picture that shows more than white.
    const std::uint64_t packed =
        glm::packHalf4x16(glm::vec4(glm::min(values[i], glm::vec3(shading::kLargestHalf)), 1.0f));
    std::memcpy(texels.data() + i * sizeof(packed), &packed, sizeof(packed));
  }
}

void refuse_too_large(const gpu::Device& device, const image::FloatImage& equirect) {
  const std::uint32_t limit = device.caps().max_image_size;
  if (equirect.width > limit || equirect.height > limit)
    throw Error(ErrorCode::input_invalid,
                fmt::format("the environment has {} x {} pixels, and this device takes {} a side: scale it down",
                            equirect.width, equirect.height, limit));
}

// Names the bake by the picture's half floats and by the driver, whose rounding is in its bits. Rows are hashed side by
// side, then their hashes.
std::string cache_name(const gpu::Device& device, const image::FloatImage& equirect,
                       std::span<const std::uint16_t> halves) {
  const std::size_t row = 4 * static_cast<std::size_t>(equirect.width);
  std::vector<std::uint64_t> hashes(equirect.height);
  parallel_for(hashes.size(),
               [&](std::size_t y) { hashes[y] = content_hash(std::as_bytes(halves.subspan(y * row, row))); });
  hashes.insert(hashes.end(), {equirect.width, equirect.height, device.driver_hash(), kVersion});
  return fmt::format("environment-{:016x}.bin", content_hash(std::as_bytes(std::span(hashes))));
}

}  // namespace

Environment bake_environment(gpu::GpuContext& tools, const image::FloatImage& equirect) {
  refuse_too_large(tools.device, equirect);
  const std::vector<std::uint16_t> halves = half_mips(equirect);
  Environment environment{
      .background = upload_half_image(tools.device, background_desc(equirect), std::as_bytes(std::span(halves)))};

  // A cached bake is the coefficients, the specular cube's texels and the irradiance cube's.
  const std::string name = cache_name(tools.device, equirect, halves);
  const std::size_t specular_at = sizeof environment.sh;
  const std::size_t irradiance_at = specular_at + half_image_bytes(specular_cube_desc());
  std::vector<std::byte> bake(irradiance_at + half_image_bytes(irradiance_desc()));
  const auto specular = std::span(bake).subspan(specular_at, irradiance_at - specular_at);
  const auto irradiance = std::span(bake).subspan(irradiance_at);
  if (load_table(name, bake)) {
    std::memcpy(environment.sh.data(), bake.data(), specular_at);
    environment.specular = upload_half_image(tools.device, specular_cube_desc(), specular);
  } else {
    environment.sh = project_sh(equirect);
    environment.specular = bake_specular_cube(tools, environment.background);
    std::memcpy(bake.data(), environment.sh.data(), specular_at);
    download_half_image(tools.device, environment.specular, specular);
    bake_irradiance(equirect, irradiance);
    store_table(name, bake);
  }
  environment.irradiance = upload_half_image(tools.device, irradiance_desc(), irradiance);
  gpu::fill_cube_edges(tools.device, environment.specular);
  gpu::fill_cube_edges(tools.device, environment.irradiance);
  return environment;
}

}  // namespace velarium::bake
