#include <velarium/picture.hpp>

#include "core/files.hpp"
#include "image/image.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>
#include <string_view>

namespace velarium {
namespace {

namespace fs = std::filesystem;

// Display values are 8-bit steps widened to 16: step n is stored as 257 n, so that 255 becomes 65535.
constexpr std::uint32_t kStep = 257;

image::ByteImage bytes_of(const Picture& picture) {
  image::ByteImage bytes{picture.width, picture.height, std::vector<std::uint8_t>(picture.display.size())};
  std::transform(picture.display.begin(), picture.display.end(), bytes.rgba.begin(),
                 [](std::uint32_t value) { return static_cast<std::uint8_t>((value + kStep / 2) / kStep); });
  return bytes;
}

void save_png(const fs::path& file, const Picture& picture, const Settings& settings) {
  if (settings.output.bits == 8) return image::save_png(file, bytes_of(picture), picture.attributes);
  image::save_png(file, image::WordImage{picture.width, picture.height, picture.display}, picture.attributes);
}
void save_jpeg(const fs::path& file, const Picture& picture, const Settings& settings) {
  image::save_jpeg(file, bytes_of(picture), settings.output.quality);
}
void save_webp(const fs::path& file, const Picture& picture, const Settings& settings) {
  image::save_webp(file, bytes_of(picture), settings.output.quality);
}
void save_exr(const fs::path& file, const Picture& picture, const Settings& settings) {
  const bool half = settings.output.exr == ExrType::half;
  if (picture.layers.empty() && picture.attributes.empty())
    return image::save_exr(file, {picture.width, picture.height, picture.linear}, half);
  std::vector<image::ExrPart> parts{{"beauty", {"R", "G", "B", "A"}, picture.linear, half}};
  for (const PictureLayer& layer : picture.layers)
    parts.push_back({layer.name, layer.channels, layer.values, half && !layer.exact});
  image::save_exr_parts(file, {picture.width, picture.height}, parts, picture.attributes);
}
void save_hdr(const fs::path& file, const Picture& picture, const Settings&) {
  image::save_hdr(file, {picture.width, picture.height, picture.linear});
}

struct Ending {
  std::string_view text;
  bool linear;  // which half of the picture it stores
  void (*save)(const fs::path&, const Picture&, const Settings&);
  std::uint32_t largest_side = std::numeric_limits<std::uint32_t>::max();  // that the format has room for
};

// A WebP file counts sides in 14 bits. JPEG counts in 16, of which libjpeg takes fewer (JPEG_MAX_DIMENSION).
constexpr std::uint32_t kLargestWebp = 16383, kLargestJpeg = 65500;

constexpr std::array kEndings{
    Ending{".png", false, save_png},
    Ending{".jpg", false, save_jpeg, kLargestJpeg},
    Ending{".jpeg", false, save_jpeg, kLargestJpeg},
    Ending{".webp", false, save_webp, kLargestWebp},
    Ending{".exr", true, save_exr},
    Ending{".hdr", true, save_hdr},
};

const Ending& ending_of(const fs::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto found = std::find_if(kEndings.begin(), kEndings.end(), [&](const Ending& e) { return e.text == text; });
  if (found != kEndings.end()) return *found;
  std::string known;
  for (const Ending& ending : kEndings) known += fmt::format(" {}", ending.text);
  throw Error(
      ErrorCode::usage, file,
      fmt::format("{}; pictures end in one of{}",
                  text.empty() ? "has no ending that names a format" : fmt::format("'{}' is not a format", text),
                  known));
}

}  // namespace

void Picture::save(const fs::path& file, const Settings& settings) const {
  const Ending& ending = ending_of(file);
  const std::size_t stored = ending.linear ? linear.size() : display.size();
  if (stored != 4 * static_cast<std::size_t>(width) * height) {
    throw Error(ErrorCode::usage, file,
                fmt::format("{} stores {} values, which this picture was made without", ending.text,
                            ending.linear ? "linear" : "display"));
  }
  ending.save(file, *this, settings);
}

void Picture::check_destination(const fs::path& file, std::uint32_t width, std::uint32_t height) {
  const Ending& ending = ending_of(file);
  check_writable(file);
  if (std::max(width, height) > ending.largest_side)
    throw Error(ErrorCode::output_not_written, file,
                fmt::format("pictures of this format have at most {} pixels a side; {} x {} fits .png and .exr",
                            ending.largest_side, width, height));
}

bool Picture::stores_linear(const fs::path& file) {
  return ending_of(file).linear;
}

}  // namespace velarium
