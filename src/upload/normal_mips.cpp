#include "upload/normal_mips.hpp"

#include "shading/host.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace velarium::upload {
namespace {

// A row of vectors, an array a component, so that compilers work on several at once.
struct Row {
  explicit Row(std::uint32_t width) : x(width), y(width), z(width) {}
  std::vector<float> x, y, z;
};

// Devices read the code c as (2 c - 255) / 255, which is never 0.
void decode(const std::vector<std::uint32_t>& texels, Row& row) {
  float *x = row.x.data(), *y = row.y.data(), *z = row.z.data();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto cx = static_cast<float>(static_cast<int>(2 * (texels[i] & 0xff)) - 255);
    const auto cy = static_cast<float>(static_cast<int>(2 * (texels[i] >> 8 & 0xff)) - 255);
    const auto cz = static_cast<float>(static_cast<int>(2 * (texels[i] >> 16 & 0xff)) - 255);
    const float scale = 1.0f / std::sqrt(cx * cx + cy * cy + cz * cz);
    x[i] = scale * cx;
    y[i] = scale * cy;
    z[i] = scale * cz;
  }
}

// 1 / |mean|; of null means a large number.
void find_inverse_lengths(const Row& means, std::vector<float>& inverse) {
  const float *x = means.x.data(), *y = means.y.data(), *z = means.z.data();
  float* to = inverse.data();
  for (std::size_t i = 0; i < inverse.size(); ++i)
    to[i] = 1.0f / std::max(std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]), 1e-6f);
}

void scale(std::vector<float>& values, const std::vector<float>& factors) {
  float* value = values.data();
  const float* factor = factors.data();
  for (std::size_t i = 0; i < values.size(); ++i) value[i] *= factor[i];
}

// Level 1 knows what filters show between its texels of level 0.
void interpolate(Row& means, std::vector<float>& scratch) {
  find_inverse_lengths(means, scratch);
  float* factor = scratch.data();
  for (std::size_t i = 0; i < scratch.size(); ++i) factor[i] *= shading::interpolated_mean_length(1.0f / factor[i]);
  for (const auto component : {&Row::x, &Row::y, &Row::z}) scale(means.*component, scratch);
}

// The sum of what two rows hold, each by its factors.
void weighted_sum(const std::vector<float>& upper, const std::vector<float>& upper_factors,
                  const std::vector<float>& lower, const std::vector<float>& lower_factors, std::vector<float>& out) {
  const float *a = upper.data(), *u = upper_factors.data(), *b = lower.data(), *v = lower_factors.data();
  float* to = out.data();
  for (std::size_t i = 0; i < out.size(); ++i) to[i] = a[i] * u[i] + b[i] * v[i];
}

// sums: of the directions of two rows. Of each block of two by two texels, interpolation_gap(), for both its columns.
void find_gaps(const Row& sums, std::vector<float>& gaps) {
  const float *x = sums.x.data(), *y = sums.y.data(), *z = sums.z.data();
  float* to = gaps.data();
  const std::size_t pairs = gaps.size() / 2;
  for (std::size_t i = 0; i < pairs; ++i) {
    const float sx = x[2 * i] + x[2 * i + 1], sy = y[2 * i] + y[2 * i + 1], sz = z[2 * i] + z[2 * i + 1];
    to[2 * i] = to[2 * i + 1] = shading::interpolation_gap(0.25f * std::sqrt(sx * sx + sy * sy + sz * sz));
  }
  const std::size_t last = gaps.size() - 1;  // a column of its own, where their number is odd
  if (last == 2 * pairs)
    to[last] = shading::interpolation_gap(0.5f * std::sqrt(x[last] * x[last] + y[last] * y[last] + z[last] * z[last]));
}

std::uint32_t rounded(float value) {
  return static_cast<std::uint32_t>(static_cast<int>(value + 0.5f));
}

void encode(const Row& means, const std::vector<float>& inverse_lengths, const std::vector<float>& gaps,
            std::vector<std::uint32_t>& texels) {
  const float *x = means.x.data(), *y = means.y.data(), *z = means.z.data();
  const float *inverse = inverse_lengths.data(), *gap = gaps.data();
  std::uint32_t* to = texels.data();
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float scale = 127.5f * inverse[i];
    const std::uint32_t color =
        rounded(scale * x[i] + 127.5f) | rounded(scale * y[i] + 127.5f) << 8 | rounded(scale * z[i] + 127.5f) << 16;
    to[i] = color | rounded(255.0f * shading::spread_from_mean_length(gap[i] / inverse[i])) << 24;
  }
}

// Where both sizes are halved exactly, as nearly always: four equal weights.
void mean(const std::vector<float>& upper, const std::vector<float>& lower, std::vector<float>& out) {
  const float *a = upper.data(), *b = lower.data();
  float* to = out.data();
  for (std::size_t i = 0; i < out.size(); ++i) to[i] = 0.25f * ((a[2 * i] + b[2 * i]) + (a[2 * i + 1] + b[2 * i + 1]));
}

void filter(const std::vector<float>& upper, const std::vector<float>& lower, float share_of_lower,
            const std::vector<Tap>& columns, std::vector<float>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Tap& tap = columns[i];
    const float top = upper[tap.first] + tap.share() * (upper[tap.second] - upper[tap.first]);
    const float bottom = lower[tap.first] + tap.share() * (lower[tap.second] - lower[tap.first]);
    out[i] = top + share_of_lower * (bottom - top);
  }
}

// All levels at once: as soon as a row has both rows above it, it is made, so that of each level two rows of means are
// enough.
class Pyramid {
 public:
  explicit Pyramid(std::span<const TexelRows> levels) {
    for (std::size_t i = 0; i < levels.size(); ++i) levels_.emplace_back(levels[i], levels[i == 0 ? 0 : i - 1]);
  }

  void fill() {
    Level& base = levels_.front();
    for (std::uint32_t y = 0; y < base.texels.height; ++y) {
      std::memcpy(base.codes.data(), base.texel_row(y), base.bytes());
      decode(base.codes, base.row(y));
      pass_on(0, y);
    }
  }

 private:
  struct Level {
    Level(const TexelRows& rows_out, const TexelRows& above)
        : texels(rows_out),
          exact(above.width == 2 * rows_out.width && above.height == 2 * rows_out.height),
          columns(make_taps(above.width, rows_out.width)),
          rows(make_taps(above.height, rows_out.height)),
          codes(rows_out.width),
          means{Row(rows_out.width), Row(rows_out.width)},
          inverse_lengths{std::vector<float>(rows_out.width), std::vector<float>(rows_out.width)},
          directions(rows_out.width),
          gaps(rows_out.width) {}
    Row& row(std::uint32_t y) { return means[y % 2]; }
    [[nodiscard]] std::size_t bytes() const { return std::size_t{4} * texels.width; }
    [[nodiscard]] std::byte* texel_row(std::uint32_t y) const { return texels.first + y * texels.pitch; }

    TexelRows texels;
    bool exact;
    std::vector<Tap> columns, rows;
    std::vector<std::uint32_t> codes;                   // of a row
    std::array<Row, 2> means;                           // of the last two rows
    std::array<std::vector<float>, 2> inverse_lengths;  // of those
    Row directions;                                     // their sums
    std::vector<float> gaps;                            // of their blocks
    std::uint32_t done = 0;                             // rows
  };

  // Row y of level i stands in its means: makes the row below that waits for it, and what waits for that.
  void pass_on(std::size_t i, std::uint32_t y) {
    if (i + 1 == levels_.size()) return;
    Level &from = levels_[i], &to = levels_[i + 1];
    if (to.done == to.texels.height || to.rows[to.done].second != y) return;
    const Tap& tap = to.rows[to.done];
    const Row &upper = from.row(tap.first), &lower = from.row(tap.second);
    Row& out = to.row(to.done);
    for (const auto component : {&Row::x, &Row::y, &Row::z}) {
      if (to.exact)
        mean(upper.*component, lower.*component, out.*component);
      else
        filter(upper.*component, lower.*component, tap.share(), to.columns, out.*component);
    }
    if (i == 0) interpolate(out, to.gaps);
    if (to.done % 2 == 1 || to.done + 1 == to.texels.height) write_pair(to, to.done);
    pass_on(i + 1, to.done++);
  }

  // The row and the one above it that it shares blocks with; the last of an odd number has its blocks alone.
  static void write_pair(Level& level, std::uint32_t last) {
    const std::uint32_t first = last - last % 2;
    const Row &upper = level.row(first), &lower = level.row(last);
    auto &upper_inverse = level.inverse_lengths[0], &lower_inverse = level.inverse_lengths[last - first];
    find_inverse_lengths(upper, upper_inverse);
    if (last != first) find_inverse_lengths(lower, lower_inverse);
    for (const auto component : {&Row::x, &Row::y, &Row::z})
      weighted_sum(upper.*component, upper_inverse, lower.*component, lower_inverse, level.directions.*component);
    find_gaps(level.directions, level.gaps);
    for (std::uint32_t y = first; y <= last; ++y) {
      encode(level.row(y), level.inverse_lengths[y - first], level.gaps, level.codes);
      std::memcpy(level.texel_row(y), level.codes.data(), level.bytes());
    }
  }

  std::vector<Level> levels_;
};

}  // namespace

void copy_without_alpha(std::span<const std::byte> from, std::byte* to) {
  constexpr std::uint32_t kColor = 0x00ffffff;
  for (std::size_t i = 0; i < from.size(); i += 4) {
    std::uint32_t texel;
    std::memcpy(&texel, from.data() + i, 4);
    texel &= kColor;
    std::memcpy(to + i, &texel, 4);
  }
}

void make_normal_mips(std::span<const TexelRows> levels) {
  Pyramid(levels).fill();
}

}  // namespace velarium::upload
