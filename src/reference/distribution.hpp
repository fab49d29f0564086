#pragma once

// Discrete and piecewise constant distributions, sampled by inverting their sums: points that are well spread before
// stay so after.

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace velarium::reference {

// Entries chosen in proportion to their weights. An entry of weight 0 is never chosen.
class Distribution1d {
 public:
  struct Sample {
    std::uint32_t index;
    float probability;  // of this entry, > 0
    float rest;         // what the choice leaves of u: uniform in [0, 1), as for a place inside the entry
  };

  // Weights are finite and not negative.
  explicit Distribution1d(std::span<const float> weights);

  // No weight is above 0, or there are no entries: nothing can be sampled, and every probability is 0.
  [[nodiscard]] bool empty() const { return total_ == 0.0; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(probabilities_.size()); }
  [[nodiscard]] double total() const { return total_; }

  // u in [0, 1). Precondition: not empty().
  [[nodiscard]] Sample sample(float u) const;
  [[nodiscard]] float probability(std::uint32_t index) const { return probabilities_[index]; }

 private:
  double total_ = 0.0;
  std::vector<float> probabilities_;
  std::vector<float> sums_;  // of the probabilities before each entry, and 1 at the end
};

// A density over the unit square that is constant in each cell of a grid.
class Distribution2d {
 public:
  struct Sample {
    glm::vec2 uv;     // in [0, 1)^2
    float pdf;        // at uv, per unit of area of the square, > 0
    glm::uvec2 cell;  // column and row that uv lies in, rounding of uv aside
  };

  // weights: row by row, width x height, finite and not negative; a cell is chosen in proportion to its weight.
  Distribution2d(std::span<const float> weights, std::uint32_t width, std::uint32_t height);

  // No weight is above 0: nothing can be sampled, and the density is 0.
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] double total() const { return rows_.total(); }

  // u in [0, 1)^2. Precondition: not empty().
  [[nodiscard]] Sample sample(const glm::vec2& u) const;
  // uv in [0, 1]^2.
  [[nodiscard]] float pdf(const glm::vec2& uv) const;

 private:
  [[nodiscard]] float pdf_of(const glm::uvec2& cell) const;

  std::vector<Distribution1d> columns_;  // within each row
  Distribution1d rows_;
};

}  // namespace velarium::reference
