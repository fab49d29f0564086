#include "upload/mips.hpp"

#include "shading/host.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace velarium::upload {
namespace {

// Means are taken in 16 bits: the darkest step of sRGB, 1 / (255 * 12.92), is 20 of theirs.
constexpr std::uint32_t kLinearOne = 65535;

// Half-way cases of the mean go to the even code, as devices round: always up would brighten a little with each level.
struct UnormCodec {
  [[nodiscard]] static std::uint8_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const std::uint32_t sum = a + b + c + d;
    return static_cast<std::uint8_t>((sum + 1 + ((sum >> 2) & 1)) >> 2);
  }
  [[nodiscard]] std::uint32_t linear(std::uint8_t code) const { return code * 257u; }
  [[nodiscard]] std::uint8_t code(std::uint32_t linear) const {
    return static_cast<std::uint8_t>((linear + 128) / 257);
  }
};

double linear_from_srgb(double encoded) {
  return static_cast<double>(shading::srgb_decode(glm::vec3(static_cast<float>(encoded))).x);
}

struct SrgbTables {
  std::array<std::uint16_t, 256> linear{};
  std::array<std::uint8_t, kLinearOne + 1> code{};  // the nearest by its encoded value

  SrgbTables() {
    std::uint32_t next = 0;
    for (std::uint32_t c = 0; c < 256; ++c) {
      linear[c] = static_cast<std::uint16_t>(std::lround(linear_from_srgb(c / 255.0) * kLinearOne));
      const double border = c == 255 ? kLinearOne : linear_from_srgb((c + 0.5) / 255.0) * kLinearOne;
      for (; next <= border; ++next) code[next] = static_cast<std::uint8_t>(c);
    }
  }
};

struct SrgbCodec {
  const SrgbTables& tables;
  [[nodiscard]] std::uint8_t mean(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const {
    return code((linear(a) + linear(b) + linear(c) + linear(d) + 2) / 4);
  }
  [[nodiscard]] std::uint32_t linear(std::uint8_t code) const { return tables.linear[code]; }
  [[nodiscard]] std::uint8_t code(std::uint32_t linear) const { return tables.code[linear]; }
};

constexpr std::uint32_t kTapOne = 256;  // the weight of Tap

std::uint32_t blend(std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
  return (a * (kTapOne - weight) + b * weight + kTapOne / 2) / kTapOne;
}

using Texels = const std::uint8_t*;

Texels row_of(const TexelRows& rows, std::uint32_t y) {
  return reinterpret_cast<Texels>(rows.first + y * rows.pitch);
}

// One channel of one texel from those at `a` and `b` of the upper row, and of the lower.
template <class Codec>
std::uint8_t filtered(const Codec& codec, Texels upper, Texels lower, const Tap& column, std::uint32_t row_weight) {
  const std::size_t a = std::size_t{4} * column.first, b = std::size_t{4} * column.second;
  const std::uint32_t top = blend(codec.linear(upper[a]), codec.linear(upper[b]), column.weight);
  const std::uint32_t bottom = blend(codec.linear(lower[a]), codec.linear(lower[b]), column.weight);
  return codec.code(blend(top, bottom, row_weight));
}

// The same where both sizes are halved exactly, as nearly always: four equal weights.
template <class Codec>
std::uint8_t mean(const Codec& codec, Texels upper, Texels lower) {
  return codec.mean(upper[0], upper[4], lower[0], lower[4]);
}

template <class ColorCodec>
void make_mip_of(const ColorCodec& color, const TexelRows& from, const TexelRows& to) {
  const UnormCodec alpha;
  const bool exact = from.width == 2 * to.width && from.height == 2 * to.height;
  const auto columns = make_taps(from.width, to.width), rows = make_taps(from.height, to.height);
  for (std::uint32_t y = 0; y < to.height; ++y) {
    Texels upper = row_of(from, rows[y].first), lower = row_of(from, rows[y].second);
    auto* out = reinterpret_cast<std::uint8_t*>(to.first + y * to.pitch);
    for (std::uint32_t x = 0; x < to.width; ++x, out += 4) {
      if (exact) {
        for (std::uint32_t c = 0; c < 3; ++c) out[c] = mean(color, upper + c, lower + c);
        out[3] = mean(alpha, upper + 3, lower + 3);
        upper += 8, lower += 8;
        continue;
      }
      for (std::uint32_t c = 0; c < 3; ++c) out[c] = filtered(color, upper + c, lower + c, columns[x], rows[y].weight);
      out[3] = filtered(alpha, upper + 3, lower + 3, columns[x], rows[y].weight);
    }
  }
}

}  // namespace

// Centre i + 0.5 of `to` lies at (i + 0.5) * from / to - 0.5 among the centres of `from`: in units of 1 / (2 to), so
// that whole numbers do.
std::vector<Tap> make_taps(std::uint32_t from, std::uint32_t to) {
  std::vector<Tap> taps(to);
  const std::uint64_t unit = std::uint64_t{2} * to;
  for (std::uint32_t i = 0; i < to; ++i) {
    const std::uint64_t place = (std::uint64_t{2} * i + 1) * from - to;
    const auto first = static_cast<std::uint32_t>(place / unit);
    taps[i] = {first, std::min(first + 1, from - 1), static_cast<std::uint32_t>(place % unit * kTapOne / unit)};
  }
  return taps;
}

void make_mip(const TexelRows& from, const TexelRows& to, bool srgb) {
  static const SrgbTables tables;
  if (srgb)
    make_mip_of(SrgbCodec{tables}, from, to);
  else
    make_mip_of(UnormCodec{}, from, to);
}

}  // namespace velarium::upload
