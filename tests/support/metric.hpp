#pragma once

// Differences between pictures. What is no picture (another size, one flat colour, not a number) never passes.

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

// Of values around 1. NaN, which fails every comparison, where a value is NaN or the sizes differ.
[[nodiscard]] double mean_squared_error(std::span<const float> a, std::span<const float> b);

// Peak 1; infinite for equal values, NaN as above.
[[nodiscard]] double psnr_db(std::span<const float> a, std::span<const float> b);

// Largest |a - b|. NaN as above.
[[nodiscard]] double largest_error(std::span<const float> a, std::span<const float> b);

}  // namespace velarium::test
