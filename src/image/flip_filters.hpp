#pragma once

#include "image/separable_filter.hpp"

namespace velarium::image {

// How much of a picture's detail an observer sees, and what he takes for edges and points.
struct FlipFilters {
  // Contrast sensitivity as weights of a neighbourhood. That of blue-yellow is the sum of two Gaussians, of which only
  // the kernels for columns carry the shares.
  Kernel luminance, red_green;
  Kernel wide_rows, wide_columns, narrow_rows, narrow_columns;
  // A Gaussian and its first and second derivative.
  Kernel blur, slope, curvature;

  [[nodiscard]] std::size_t padding() const;  // the largest radius
};

// Precondition: pixels_per_degree > 0.
[[nodiscard]] FlipFilters flip_filters(float pixels_per_degree);

}  // namespace velarium::image
