#include "api/display.hpp"

#include "core/jobs.hpp"
#include "passes/exposure/exposure.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::api {
namespace {

using shading::vec3, shading::vec4;

vec4 pixel_of(const Picture& picture, std::size_t i) {
  const float* p = &picture.linear[4 * i];
  return {p[0], p[1], p[2], p[3]};
}

float exposure_of(const Picture& picture, const Settings::display_settings& settings) {
  if (settings.exposure_mode != ExposureMode::automatic) return exposure::manual_exposure(settings);
  glm::dvec2 sum(0.0);
  for (std::size_t i = 0; i < picture.linear.size() / 4; ++i)
    sum += glm::dvec2(shading::weighted_log2_luminance(pixel_of(picture, i)));
  return std::exp2(settings.exposure) * shading::automatic_exposure(glm::vec2(sum));
}

}  // namespace

void display(Picture& picture, const RenderRequest& request) {
  const Settings& settings = request.settings;
  const float exposure = exposure_of(picture, settings.display);
  const auto curve = static_cast<std::uint32_t>(settings.display.tonemap);
  const auto bits = static_cast<std::uint32_t>(settings.output.bits);
  const auto& color = request.background_color;
  const vec3 background = shading::srgb_decode({color[0], color[1], color[2]});
  picture.display_bits = settings.output.bits;
  picture.display.resize(picture.linear.size());
  parallel_for(picture.height, [&](std::size_t y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::size_t i = y * picture.width + x;
      const vec4 light = pixel_of(picture, i);
      vec3 linear = shading::displayed_light(curve, light, exposure);
      float alpha = std::min(shading::displayable(light.w), 1.0f);
      if (request.background == Background::color) {
        linear = glm::mix(background, linear, alpha);
        alpha = 1.0f;
      }
      const vec3 encoded = glm::clamp(shading::srgb_encode(linear), 0.0f, 1.0f);
      const float noise = settings.display.dither
                              ? shading::screen_noise({x, static_cast<std::uint32_t>(y)}, 0u,
                                                      static_cast<std::uint32_t>(settings.frame.seed))
                              : 0.5f;
      std::uint16_t* out = &picture.display[4 * i];
      for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint16_t>(shading::quantize(encoded[c], noise, bits));
      out[3] = static_cast<std::uint16_t>(shading::quantize(alpha, 0.5f, bits));
    }
  });
}

}  // namespace velarium::api
