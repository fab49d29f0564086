#pragma once

// Whether pictures are what they were: as the metric `share` of `velarium compare` counts, but in whole steps of 8
// bits, and what is no picture (another size, one flat colour, not a number) never passes. The library measures how far
// pictures are apart: velarium/compare.hpp.

#include "image/image.hpp"

#include <span>
#include <string>

namespace velarium::test {

// What may differ: `share` of the pixels, 0..1, may have a channel that is off by more than `max_error` of 255.
struct Tolerance {
  int max_error = 2;
  double share = 0.001;
};

struct Verdict {
  bool same = false;
  int worst = 0;       // the largest difference of a channel, of 255
  double share = 0.0;  // of pixels beyond the tolerance's max_error
  std::string says;    // one line
};

// A picture of one flat colour is refused whatever it is compared with: nothing was drawn, or nothing was read back.
[[nodiscard]] Verdict compare(const image::ByteImage& actual, const image::ByteImage& expected,
                              const Tolerance& tolerance);

// 16 times the difference of each channel, opaque, so that small ones can be seen. Precondition: equal sizes.
[[nodiscard]] image::ByteImage difference_picture(const image::ByteImage& a, const image::ByteImage& b);

// Largest |a - b|; NaN, which fails every comparison, where a value is NaN, the sizes differ or there is no value.
[[nodiscard]] double largest_error(std::span<const float> a, std::span<const float> b);

}  // namespace velarium::test
