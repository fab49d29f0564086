#pragma once

// Wang, Bovik, Sheikh, Simoncelli: "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
// Trans. Image Processing 13(4), 2004.

#include "image/differences.hpp"

namespace velarium::image {

// Structural similarity of each pixel's neighbourhood, at most 1, which equal neighbourhoods have: mean of red, green
// and blue of display values from 0 to 1. Alpha is not read. Symmetric in the pictures. Beyond the picture its
// outermost pixels go on. Precondition: equal sizes, of one pixel at least.
[[nodiscard]] std::vector<float> ssim(const FloatImage& picture, const FloatImage& reference);

// As the paper counts, only windows that lie inside the picture: the mask without the pixels near its edges, or as it
// was where nothing would be left.
[[nodiscard]] Mask inside_for_ssim(const Mask& mask, std::uint32_t width, std::uint32_t height);

}  // namespace velarium::image
