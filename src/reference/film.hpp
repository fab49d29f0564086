#pragma once

// What the paths of a picture add up to: means and variances, pixel by pixel, in the order of the paths.

#include "reference/path.hpp"

#include <cstdint>
#include <vector>

namespace velarium::reference {

class Film {
 public:
  Film(std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height), pixels_(std::size_t{width} * height) {}

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::uint32_t height() const { return height_; }

  // Different threads may add to different pixels.
  void add(std::size_t pixel, const PathSample& sample) { pixels_[pixel].add(sample); }

  // How far the picture is off, by estimate: the standard errors of all pixels' luminances, summed, as a share of the
  // summed luminance. Infinite before the second path, and 0 for a black picture.
  [[nodiscard]] double relative_error() const;
  // Paths that were left out because their light was not a finite number.
  [[nodiscard]] std::uint64_t lost_paths() const;
  // Fewest paths of a pixel.
  [[nodiscard]] std::uint32_t finished_samples() const;

  // Interleaved channels, row by row.
  [[nodiscard]] std::vector<float> beauty() const;    // RGBA, premultiplied
  [[nodiscard]] std::vector<float> variance() const;  // RGB: of the mean, estimated as if paths were independent
  [[nodiscard]] std::vector<float> albedo() const;    // RGB, of what is hit first; misses count as 0
  [[nodiscard]] std::vector<float> normal() const;    // XYZ, world space, mean over the paths that hit; not unit
  [[nodiscard]] std::vector<float> depth() const;     // Z, view depth, mean over the paths that hit; 0 where none did
  [[nodiscard]] std::vector<float> direct() const;    // RGB
  [[nodiscard]] std::vector<float> indirect() const;  // RGB

 private:
  struct Pixel {
    glm::vec3 direct{0.0f}, indirect{0.0f};  // means
    glm::vec3 squares{0.0f};                 // of the differences from the mean of the sum of both [Welford 1962]
    glm::vec3 albedo{0.0f}, normal{0.0f};
    float alpha = 0.0f, depth = 0.0f;
    std::uint32_t count = 0, hits = 0, lost = 0;

    void add(const PathSample& sample);
    [[nodiscard]] glm::vec3 variance_of_mean() const;
  };
  template <std::size_t kChannels, class Function>
  [[nodiscard]] std::vector<float> channels(Function of) const;

  std::uint32_t width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace velarium::reference
