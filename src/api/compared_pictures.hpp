#pragma once

// Two pictures in a form in which they can be compared.

#include "image/differences.hpp"
#include "image/image.hpp"

#include <velarium/compare.hpp>

#include <string>
#include <vector>

namespace velarium::compared {

// Both cut to the crop and premultiplied by alpha.
struct Pair {
  image::FloatImage picture, reference;
  bool linear = false;             // linear light, else display values from 0 to 1
  std::vector<std::string> notes;  // what was done to get there
};

// Throws as velarium::compare().
[[nodiscard]] Pair pair_of(const Picture& picture, const Picture& reference, const CompareOptions& options);

// Of the crop; empty where the options have no mask. Throws as velarium::compare().
[[nodiscard]] image::Mask mask_of(const Picture& picture, const CompareOptions& options);

// Opaque: premultiplied values over a grey background.
[[nodiscard]] image::FloatImage over(const image::FloatImage& premultiplied, float background);

// Premultiplied linear light as premultiplied display values: times 2^stops, clamped, sRGB-encoded.
[[nodiscard]] image::FloatImage display_from_linear(const image::FloatImage& linear, float stops);

// Opaque display values as the light that a display makes of them.
[[nodiscard]] image::FloatImage linear_from_display(const image::FloatImage& display);

// What a page shows of one of a pair: straight alpha.
[[nodiscard]] image::ByteImage shown_bytes(const image::FloatImage& premultiplied, bool linear, float stops);

}  // namespace velarium::compared
