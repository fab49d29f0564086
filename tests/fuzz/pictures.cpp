#include "support.hpp"

#include "image/codecs.hpp"

namespace velarium::fuzz {
namespace {

const image::Limits kLimits{.pixels = 1 << 20, .size = 1 << 12};

}  // namespace

void picture(Bytes input) {
  expect_orderly([&] { static_cast<void>(image::peek_size(input, "input")); });
  expect_orderly([&] { static_cast<void>(image::decode(input, "input", kLimits)); });
  if (image::format_of(input) != image::Format::png) return;
  expect_orderly([&] {
    image::check_size(image::png_size(input, "input"), "input", kLimits);
    if (image::png_has_16_bits(input)) static_cast<void>(image::read_png_16(input, "input", kLimits));
  });
}

void exr(Bytes input) {
  expect_orderly([&] { static_cast<void>(image::read_exr(input, "input", kLimits)); });
}

void hdr(Bytes input) {
  expect_orderly([&] { static_cast<void>(image::read_hdr(input, "input", kLimits)); });
}

}  // namespace velarium::fuzz
