#include "reference/distribution.hpp"

#include "core/assert.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace velarium::reference {
namespace {

// Largest number below 1 that a float holds.
constexpr float kAlmostOne = 0x1.fffffep-1f;

std::vector<Distribution1d> make_columns(std::span<const float> weights, std::uint32_t width, std::uint32_t height) {
  VEL_ASSERT(weights.size() == std::size_t{width} * height);
  std::vector<Distribution1d> columns;
  columns.reserve(height);
  for (std::uint32_t y = 0; y < height; ++y) columns.emplace_back(weights.subspan(std::size_t{y} * width, width));
  return columns;
}

// Of the largest, since a row's sum may be more than a float holds.
std::vector<float> relative_totals(const std::vector<Distribution1d>& columns) {
  double largest = 0.0;
  for (const auto& row : columns) largest = std::max(largest, row.total());
  std::vector<float> totals;
  totals.reserve(columns.size());
  for (const auto& row : columns) totals.push_back(largest > 0.0 ? static_cast<float>(row.total() / largest) : 0.0f);
  return totals;
}

std::uint32_t cell_of(float u, std::uint32_t count) {
  return std::min(static_cast<std::uint32_t>(u * static_cast<float>(count)), count - 1);
}

}  // namespace

Distribution1d::Distribution1d(std::span<const float> weights) {
  for (const float weight : weights) {
    VEL_ASSERT(weight >= 0.0f);
    total_ += weight;
  }
  probabilities_.reserve(weights.size());
  sums_.reserve(weights.size() + 1);
  double sum = 0.0;
  for (const float weight : weights) {
    probabilities_.push_back(total_ > 0.0 ? static_cast<float>(weight / total_) : 0.0f);
    sums_.push_back(total_ > 0.0 ? static_cast<float>(sum / total_) : 0.0f);
    sum += weight;
  }
  sums_.push_back(1.0f);
}

Distribution1d::Sample Distribution1d::sample(float u) const {
  VEL_ASSERT(!empty() && u >= 0.0f && u < 1.0f);
  // The last entry that begins at or before u: those of weight 0 end where they begin, and the next is taken.
  const auto next = std::upper_bound(sums_.begin(), sums_.end(), u);
  const auto index = static_cast<std::uint32_t>(next - sums_.begin() - 1);
  const float begin = sums_[index], end = sums_[index + 1];
  return {index, probabilities_[index], std::min((u - begin) / (end - begin), kAlmostOne)};
}

Distribution2d::Distribution2d(std::span<const float> weights, std::uint32_t width, std::uint32_t height)
    : columns_(make_columns(weights, width, height)), rows_(relative_totals(columns_)) {}

Distribution2d::Sample Distribution2d::sample(const glm::vec2& u) const {
  const auto row = rows_.sample(u.y);
  const auto column = columns_[row.index].sample(u.x);
  const glm::uvec2 cell(column.index, row.index);
  const glm::vec2 size(columns_[row.index].size(), rows_.size());
  const glm::vec2 uv = (glm::vec2(cell) + glm::vec2(column.rest, row.rest)) / size;
  return {glm::min(uv, kAlmostOne), pdf_of(cell), cell};
}

float Distribution2d::pdf(const glm::vec2& uv) const {
  if (empty()) return 0.0f;
  const std::uint32_t row = cell_of(uv.y, rows_.size());
  return pdf_of({cell_of(uv.x, columns_[row].size()), row});
}

float Distribution2d::pdf_of(const glm::uvec2& cell) const {
  const Distribution1d& row = columns_[cell.y];
  const float cells = static_cast<float>(row.size()) * static_cast<float>(rows_.size());
  return row.probability(cell.x) * rows_.probability(cell.y) * cells;
}

}  // namespace velarium::reference
