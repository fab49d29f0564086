#pragma once

// FLIP: how strongly two pictures seem to differ to someone who sees them in turn, pixel by pixel, from 0 to 1.
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating
// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
// Andersson, Nilsson, Shirley, Akenine-Moller: "Visualizing Errors in Rendered High Dynamic Range Images",
// Eurographics Short Papers, 2021.

#include "image/image.hpp"

#include <vector>

namespace velarium::image {

// One value a pixel. The pictures hold what a display shows: linear light, BT.709, 0 to 1; alpha is not read.
// `pixels_per_degree` of the observer's view is above 0. Symmetric in the pictures.
// Precondition: equal sizes, of one pixel at least.
[[nodiscard]] std::vector<float> flip(const FloatImage& picture, const FloatImage& reference, float pixels_per_degree);

// How a picture of scene-referred light is looked at: exposed by each of `count` steps from `first` to `last` stops.
struct Exposures {
  float first = 0.0f, last = 0.0f;
  int count = 1;
};

// From the exposure in which the brightest pixel of the reference is nearly white to that in which the median is: as
// many as stops lie between, rounded up, and two at least (2021, section 3). Pixels without light, such as a
// background, do not count for the median; a picture without any light is seen once, as it is.
[[nodiscard]] Exposures exposures_of(const FloatImage& reference);

// The largest FLIP of each pixel over the exposures, through the tone curve that the paper proposes. The pictures hold
// scene-referred linear light; what is negative counts as 0.
[[nodiscard]] std::vector<float> hdr_flip(const FloatImage& picture, const FloatImage& reference,
                                          const Exposures& exposures, float pixels_per_degree);

}  // namespace velarium::image
