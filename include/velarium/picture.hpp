#pragma once

#include <velarium/settings.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace velarium {

// Pixels beside the colours of a picture, such as its depth: of the picture's size, channels interleaved.
struct PictureLayer {
  std::string name;
  std::vector<std::string> channels;  // "R", "G", "B"; "X", "Y", "Z"; "Z"
  std::vector<float> values;
  bool exact = false;  // stored as 32-bit floats whatever the settings say
};

// A finished picture: rows from the top, pixels from the left, four channels (red, green, blue, alpha).
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  // Linear, scene-referred, BT.709 primaries, premultiplied by alpha; before exposure and tone curve.
  std::vector<float> linear;
  // Display values (tone-mapped, sRGB-encoded, straight alpha), 16 bits a channel; dithered for `display_bits`.
  std::vector<std::uint16_t> display;
  int display_bits = 8;
  // What .exr stores besides `linear`, each as a part of its own; other formats leave them out.
  std::vector<PictureLayer> layers;
  // Names and texts that .png and .exr store with the pixels.
  std::vector<std::pair<std::string, std::string>> attributes;

  // Writes the format that the ending names: .png .jpg .jpeg .webp from `display`, .exr .hdr from `linear`.
  // The file appears whole or not at all. Throws Error(output_not_written), or Error(usage) for an unknown ending.
  void save(const std::filesystem::path& file, const Settings& settings = {}) const;

  // Throws what save() would throw for a reason that can be seen beforehand, so that nobody renders for nothing. Where
  // the size of the picture is known, that the format cannot hold it is such a reason.
  static void check_destination(const std::filesystem::path& file, std::uint32_t width = 0, std::uint32_t height = 0);

  // Whether save() needs `linear` for this ending, or else `display`. Throws Error(usage) for an unknown ending.
  [[nodiscard]] static bool stores_linear(const std::filesystem::path& file);
};

}  // namespace velarium
