#pragma once

// Requests for small pictures, and what is in a picture.

#include "image/image.hpp"

#include <velarium/engine.hpp>

#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace velarium::test {

// One frame through the pixels' centres, linear light alone, no environment: what closed forms can be held against.
[[nodiscard]] RenderRequest linear_request(std::uint32_t width, std::uint32_t height);

// One frame, display values alone, undithered, without a tone curve.
[[nodiscard]] RenderRequest display_request(std::uint32_t width, std::uint32_t height);

[[nodiscard]] glm::vec4 linear_at(const Picture& picture, std::uint32_t x, std::uint32_t y);

// Display values as 8-bit files hold them.
[[nodiscard]] image::ByteImage bytes_of(const Picture& picture);

using Rgba8 = std::array<std::uint8_t, 4>;
[[nodiscard]] Rgba8 byte_at(const Picture& picture, std::uint32_t x, std::uint32_t y);

// Has it pixels, and are all of them numbers?
[[nodiscard]] bool is_finite(const Picture& picture);

// How many passes of this name the picture took.
[[nodiscard]] std::size_t passes_named(const RenderReport& report, const std::string& name);

// The picture that the program's engine makes.
[[nodiscard]] Picture picture_of(const Scene& scene, const RenderRequest& request);

}  // namespace velarium::test
