#include "support/pictures.hpp"

#include "support/device.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

std::size_t offset_of(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  return 4 * (std::size_t{y} * picture.width + x);
}

std::uint8_t to_byte(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8u);
}

RenderRequest one_frame(std::uint32_t width, std::uint32_t height) {
  RenderRequest request;
  request.width = width;
  request.height = height;
  request.settings.frame.spp = 1;
  return request;
}

}  // namespace

RenderRequest linear_request(std::uint32_t width, std::uint32_t height) {
  RenderRequest request = one_frame(width, height);
  request.environment = "none";
  request.want_display = false;
  return request;
}

RenderRequest display_request(std::uint32_t width, std::uint32_t height) {
  RenderRequest request = one_frame(width, height);
  request.settings.display.dither = false;
  request.settings.display.tonemap = Tonemap::linear;
  request.want_linear = false;
  return request;
}

glm::vec4 linear_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  const float* pixel = &picture.linear.at(offset_of(picture, x, y));
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

image::ByteImage bytes_of(const Picture& picture) {
  image::ByteImage image{picture.width, picture.height, {}};
  image.rgba.reserve(picture.display.size());
  for (const std::uint16_t value : picture.display) image.rgba.push_back(to_byte(value));
  return image;
}

Rgba8 byte_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
  const std::uint16_t* pixel = &picture.display.at(offset_of(picture, x, y));
  return {to_byte(pixel[0]), to_byte(pixel[1]), to_byte(pixel[2]), to_byte(pixel[3])};
}

bool is_finite(const Picture& picture) {
  return !picture.linear.empty() &&
         std::all_of(picture.linear.begin(), picture.linear.end(), [](float value) { return std::isfinite(value); });
}

std::size_t passes_named(const RenderReport& report, const std::string& name) {
  return static_cast<std::size_t>(std::count_if(report.passes.begin(), report.passes.end(),
                                                [&](const PassTime& pass) { return pass.name == name; }));
}

Picture picture_of(const Scene& scene, const RenderRequest& request) {
  return engine().picture(scene, request);
}

}  // namespace velarium::test
