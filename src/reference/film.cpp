#include "reference/film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace velarium::reference {
namespace {

template <class T>
void move_mean(T& mean, const T& value, float share) {
  mean += (value - mean) * share;
}

std::array<float, 3> three(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

void Film::Pixel::add(const PathSample& sample) {
  glm::vec3 light = sample.direct + sample.indirect;
  const bool counts = finite(light);
  if (!counts) {
    light = glm::vec3(0.0f);
    ++lost;
  }
  const float share = 1.0f / static_cast<float>(++count);
  const glm::vec3 before = light - (direct + indirect);
  move_mean(direct, counts ? sample.direct : glm::vec3(0.0f), share);
  move_mean(indirect, counts ? sample.indirect : glm::vec3(0.0f), share);
  squares += before * (light - (direct + indirect));
  move_mean(alpha, sample.alpha, share);
  move_mean(albedo, sample.albedo, share);
  if (!sample.hit) return;
  const float hit_share = 1.0f / static_cast<float>(++hits);
  move_mean(normal, sample.normal_ws, hit_share);
  move_mean(depth, sample.depth, hit_share);
}

glm::vec3 Film::Pixel::variance_of_mean() const {
  if (count < 2) return glm::vec3(0.0f);
  const float n = static_cast<float>(count);
  return glm::max(squares, glm::vec3(0.0f)) / (n * (n - 1.0f));
}

double Film::relative_error() const {
  double errors = 0.0, light = 0.0;
  for (const Pixel& p : pixels_) {
    if (p.count < 2) return std::numeric_limits<double>::infinity();
    // The channels of a path rise and fall together, nearly: their errors add.
    errors += static_cast<double>(shading::luminance(glm::sqrt(p.variance_of_mean())));
    light += static_cast<double>(shading::luminance(p.direct + p.indirect));
  }
  return light > 0.0 ? errors / light : 0.0;
}

std::uint64_t Film::lost_paths() const {
  std::uint64_t sum = 0;
  for (const Pixel& p : pixels_) sum += p.lost;
  return sum;
}

std::uint32_t Film::finished_samples() const {
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (const Pixel& p : pixels_) least = std::min(least, p.count);
  return least;
}

template <std::size_t kChannels, class Function>
std::vector<float> Film::channels(Function of) const {
  std::vector<float> values;
  values.reserve(kChannels * pixels_.size());
  for (const Pixel& p : pixels_) {
    const std::array<float, kChannels> value = of(p);
    values.insert(values.end(), value.begin(), value.end());
  }
  return values;
}

std::vector<float> Film::beauty() const {
  return channels<4>([](const Pixel& p) {
    const glm::vec3 sum = p.direct + p.indirect;
    return std::array{sum.x, sum.y, sum.z, p.alpha};
  });
}

std::vector<float> Film::variance() const {
  return channels<3>([](const Pixel& p) { return three(p.variance_of_mean()); });
}

std::vector<float> Film::albedo() const {
  return channels<3>([](const Pixel& p) { return three(p.albedo); });
}

std::vector<float> Film::normal() const {
  return channels<3>([](const Pixel& p) { return three(p.normal); });
}

std::vector<float> Film::depth() const {
  return channels<1>([](const Pixel& p) { return std::array{p.depth}; });
}

std::vector<float> Film::direct() const {
  return channels<3>([](const Pixel& p) { return three(p.direct); });
}

std::vector<float> Film::indirect() const {
  return channels<3>([](const Pixel& p) { return three(p.indirect); });
}

}  // namespace velarium::reference
