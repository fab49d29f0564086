#include "bake/normal_lengths.hpp"

#include "bake/table_cache.hpp"
#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <limits>
#include <span>

namespace velarium::bake {
namespace {

// To be raised with every change of what best_fit_normal_lengths() returns.
constexpr int kVersion = 2;

// Nearest integer to v >= 0, halfway up.
float rounded(float v) {
  const float above = v + 0.5f;
  return static_cast<float>(static_cast<int>(above));
}

// The search at one direction n = (1, middle, smallest), over all k at once for a row of texels:
// the loops are kept free of branches so that the compiler makes vectors of them.
struct Candidate {
  float sin2 = std::numeric_limits<float>::infinity();  // of the angle to n, times |n|^2
  float k = 0.0f;
};

// Replaces `best` by k where k errs less. The angle comes from the residuals q - k n: n x q is built of them without
// the cancellation that 1 - cos^2 suffers, so that fp32 is enough.
Candidate better_of(const Candidate& best, float k, float middle, float smallest) {
  const float v1 = middle * k, v2 = smallest * k;
  const float q1 = rounded(v1), q2 = rounded(v2);
  const float r1 = q1 - v1, r2 = q2 - v2;
  const float r0 = middle * r2 - smallest * r1;
  const float sin2 = (r0 * r0 + r1 * r1 + r2 * r2) / (k * k + q1 * q1 + q2 * q2);
  // Multiples of a code err alike: a gain within rounding does not replace the larger k.
  const bool gains = sin2 < best.sin2 * 0.99999f;
  return {gains ? sin2 : best.sin2, gains ? k : best.k};
}

void fill_row(std::span<std::uint8_t> row, float y) {
  std::vector<float> middle(row.size()), smallest(row.size());
  std::vector<Candidate> best(row.size());
  for (std::size_t x = 0; x < row.size(); ++x) {
    const shading::vec2 center{static_cast<float>(x) + 0.5f, y};
    const shading::vec3 n = shading::bfn_table_direction(center, static_cast<float>(row.size()));
    middle[x] = n.y;
    smallest[x] = n.z;
  }
  for (int k = 127; k > 0; --k) {
    const float length = static_cast<float>(k);
    for (std::size_t x = 0; x < row.size(); ++x) best[x] = better_of(best[x], length, middle[x], smallest[x]);
  }
  for (std::size_t x = 0; x < row.size(); ++x) row[x] = static_cast<std::uint8_t>(best[x].k);
}

}  // namespace

std::vector<std::uint8_t> best_fit_normal_lengths(std::uint32_t size) {
  VEL_ASSERT(size >= 2);
  std::vector<std::uint8_t> table(std::size_t{size} * size);
  parallel_for(
      size, [&](std::size_t y) { fill_row(std::span(table).subspan(y * size, size), static_cast<float>(y) + 0.5f); });
  return table;
}

std::vector<std::uint8_t> cached_best_fit_normal_lengths(std::uint32_t size) {
  return cached_table<std::uint8_t>(fmt::format("best-fit-normal-lengths-{}-v{}.bin", size, kVersion),
                                    std::size_t{size} * size, [&] { return best_fit_normal_lengths(size); });
}

}  // namespace velarium::bake
