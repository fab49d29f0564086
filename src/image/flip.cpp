#include "image/flip.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "image/flip_filters.hpp"
#include "image/opponent_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace velarium::image {
namespace {

// Pictures are worked on in bands of rows, each by one thread. Higher bands share more rows that are filtered
// along x; lower ones stay in the cache.
constexpr std::size_t kBandRows = 48;

// Rows [begin, end) of a picture.
struct Band {
  std::size_t begin, end;
  [[nodiscard]] std::size_t rows() const { return end - begin; }
};

// What is kept of a pixel for the comparison: its colour, and how much of an edge and of a point it is.
struct Impression {
  Lab color;
  float edge, point;
};

// The rows of a band and those that its filters reach beyond, each filtered along x. Beyond the picture its outermost
// rows and pixels go on.
class FilteredRows {
 public:
  FilteredRows(const FloatImage& image, const Band& band, const FlipFilters& filters)
      : width_(image.width), filters_(filters), padding_(filters.padding()) {
    const std::size_t rows = band.rows() + 2 * padding_;
    for (std::vector<float>* plane : {&luminance_, &red_green_, &wide_, &narrow_, &blur_, &slope_, &curvature_})
      plane->resize(rows * width_);
    std::array<std::vector<float>, 3> row;
    for (auto& values : row) values.resize(width_ + 2 * padding_);
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t y = std::clamp(band.begin + i, padding_, padding_ + image.height - 1) - padding_;
      read_row(image, y, row);
      filter(i, row);
    }
  }

  // Row `row` of the band.
  void finish(std::size_t row, std::vector<Impression>& to) {
    column(luminance_, filters_.luminance, row, y_);
    column(red_green_, filters_.red_green, row, x_minus_y_);
    column(wide_, filters_.wide_columns, row, y_minus_z_);
    add_filtered_column(narrow_, first(filters_.narrow_columns, row), filters_.narrow_columns, y_minus_z_);
    column(slope_, filters_.blur, row, edge_x_);
    column(blur_, filters_.slope, row, edge_y_);
    column(curvature_, filters_.blur, row, point_x_);
    column(blur_, filters_.curvature, row, point_y_);
    for (std::size_t x = 0; x < width_; ++x) {
      const Rgb c = rgb_from_opponent({y_[x], x_minus_y_[x], y_minus_z_[x]});
      const Rgb shown{std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)};
      to[x] = {hunt_lab_from_rgb(shown), length(edge_x_[x], edge_y_[x]), length(point_x_[x], point_y_[x])};
    }
  }

 private:
  static float length(float x, float y) { return std::sqrt(x * x + y * y); }

  void read_row(const FloatImage& image, std::size_t y, std::array<std::vector<float>, 3>& row) const {
    const float* pixel = image.rgba.data() + 4 * y * width_;
    for (std::size_t x = padding_; x < padding_ + width_; ++x, pixel += 4) {
      const Opponent o = opponent_from_rgb({pixel[0], pixel[1], pixel[2]});
      row[0][x] = o.y;
      row[1][x] = o.x_minus_y;
      row[2][x] = o.y_minus_z;
    }
    for (auto& values : row) pad_row(values, padding_);
  }

  void filter(std::size_t i, const std::array<std::vector<float>, 3>& row) {
    const auto along_x = [&](const std::vector<float>& from, const Kernel& kernel, std::vector<float>& plane) {
      filter_row(from, kernel, padding_, std::span(plane).subspan(i * width_, width_));
    };
    along_x(row[0], filters_.luminance, luminance_);
    along_x(row[1], filters_.red_green, red_green_);
    along_x(row[2], filters_.wide_rows, wide_);
    along_x(row[2], filters_.narrow_rows, narrow_);
    along_x(row[0], filters_.blur, blur_);
    along_x(row[0], filters_.slope, slope_);
    along_x(row[0], filters_.curvature, curvature_);
  }

  // The uppermost of the filtered rows that a kernel around a row of the band covers.
  [[nodiscard]] std::size_t first(const Kernel& kernel, std::size_t row) const {
    return row + padding_ - kernel.radius();
  }

  void column(const std::vector<float>& plane, const Kernel& kernel, std::size_t row, std::vector<float>& to) const {
    to.assign(width_, 0.0f);
    add_filtered_column(plane, first(kernel, row), kernel, to);
  }

  std::size_t width_;
  const FlipFilters& filters_;
  std::size_t padding_;
  std::vector<float> luminance_, red_green_, wide_, narrow_, blur_, slope_, curvature_;  // filtered along x
  std::vector<float> y_, x_minus_y_, y_minus_z_, edge_x_, edge_y_, point_x_, point_y_;   // one row, along y as well
};

// HyAB: lightness and chroma are judged apart, which suits large differences (section 4.1).
float hyab(const Lab& p, const Lab& q) {
  const float a = p.a - q.a, b = p.b - q.b;
  return std::abs(p.l - q.l) + std::sqrt(a * a + b * b);
}

constexpr float kColorExponent = 0.7f;  // section 4.1

// Differences up to a share of 0.4 of the largest, after the exponent, take 0.95 of the range (section 4.1).
float spread(float difference) {
  constexpr float kShare = 0.4f, kRange = 0.95f;
  // Green and blue are farthest apart of all colours of a display.
  static const float kLargest =
      std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), kColorExponent);
  const float knee = kShare * kLargest;
  if (difference < knee) return kRange / knee * difference;
  return kRange + (difference - knee) / (kLargest - knee) * (1.0f - kRange);
}

// Where features differ as well, a difference of colour counts for more (section 4.3).
float difference_of(const Impression& p, const Impression& q) {
  const float color = spread(std::pow(hyab(p.color, q.color), kColorExponent));
  const float feature = std::max(std::abs(p.edge - q.edge), std::abs(p.point - q.point));
  const float exponent = 1.0f - std::sqrt(feature * std::sqrt(0.5f));  // section 4.2
  return std::min(std::pow(color, exponent), 1.0f);                    // rounding may leave a little more than 1
}

void compare_band(const FloatImage& picture, const FloatImage& reference, const Band& band, const FlipFilters& filters,
                  float* to) {
  FilteredRows p_rows(picture, band, filters), q_rows(reference, band, filters);
  std::vector<Impression> p(picture.width), q(picture.width);
  for (std::size_t row = 0; row < band.rows(); ++row, to += picture.width) {
    p_rows.finish(row, p);
    q_rows.finish(row, q);
    std::transform(p.begin(), p.end(), q.begin(), to, difference_of);
  }
}

}  // namespace

std::vector<float> flip(const FloatImage& picture, const FloatImage& reference, float pixels_per_degree) {
  VEL_ASSERT(picture.width == reference.width && picture.height == reference.height && pixels_per_degree > 0.0f);
  const FlipFilters filters = flip_filters(pixels_per_degree);
  const std::size_t height = picture.height;
  std::vector<float> errors(height * picture.width);
  parallel_for((height + kBandRows - 1) / kBandRows, [&](std::size_t i) {
    const Band band{i * kBandRows, std::min((i + 1) * kBandRows, height)};
    compare_band(picture, reference, band, filters, errors.data() + band.begin * picture.width);
  });
  return errors;
}

}  // namespace velarium::image
