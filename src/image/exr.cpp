#include "image/codecs.hpp"
#include "image/exr_header.hpp"
#include "image/exr_light.hpp"
#include "image/exr_output.hpp"

#include "core/assert.hpp"
#include "core/log.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace velarium::image {
namespace {

using Imath::Box2i;

// --- bytes --------------------------------------------------------------------------------------------------------

class MemoryInput final : public Imf::IStream {
 public:
  MemoryInput(Bytes data, const std::string& what) : IStream(what.c_str()), data_(data) {}

  bool read(char to[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (count < 0 || position_ > data_.size() || size > data_.size() - position_) {
      throw std::runtime_error("the file ends early");
    }
    std::memcpy(to, data_.data() + position_, size);
    position_ += size;
    return position_ < data_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  Bytes data_;
  std::uint64_t position_ = 0;
};

// --- pixels -------------------------------------------------------------------------------------------------------

Size size_of(const Box2i& window) {
  return {static_cast<std::uint32_t>(window.max.x - window.min.x + 1),
          static_cast<std::uint32_t>(window.max.y - window.min.y + 1)};
}

std::string channel_names(const Imf::ChannelList& channels) {
  std::string names;
  for (auto i = channels.begin(); i != channels.end(); ++i)
    names += (names.empty() ? "" : ", ") + std::string(i.name());
  return names;
}

bool has_full(const Imf::ChannelList& channels, const char* name) {
  const Imf::Channel* channel = channels.findChannel(name);
  return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
}

// Which file channels go to R, G, B and A, of which only the last may be absent.
using ChannelNames = std::array<std::string, 4>;

// `prefix` is empty, or the name of a layer and a dot.
ChannelNames find_channels(const Imf::ChannelList& channels, const std::string& prefix, const std::string& what) {
  const auto has = [&](const char* name) { return has_full(channels, (prefix + name).c_str()); };
  const std::string alpha = prefix + "A";
  if (has("R") && has("G") && has("B")) return {prefix + "R", prefix + "G", prefix + "B", alpha};
  // Directions and depths, as render layers have them.
  const std::string y = prefix + "Y", z = prefix + "Z";
  if (has("X") && has("Y") && has("Z")) return {prefix + "X", y, z, alpha};
  if (has("Z") && !has("Y")) return {z, z, z, alpha};
  const bool chroma = channels.findChannel(prefix + "RY") != nullptr || channels.findChannel(prefix + "BY") != nullptr;
  if (has("Y") && !chroma) return {y, y, y, alpha};
  throw Error(chroma ? ErrorCode::unsupported : ErrorCode::input_invalid, what,
              fmt::format("OpenEXR: channels {0}R, {0}G and {0}B, or {0}X, {0}Y and {0}Z, or {0}Y or {0}Z alone, are "
                          "read; the file has {1}",
                          prefix, channel_names(channels)));
}

FloatImage read_data_window(Imf::InputPart& file, const std::string& prefix, const std::string& what) {
  const Box2i window = file.header().dataWindow();
  const Size size = size_of(window);
  const ChannelNames names = find_channels(file.header().channels(), prefix, what);
  const bool grey = names[0] == names[1];
  FloatImage image{size.width, size.height, std::vector<float>(channel_count(size))};

  constexpr std::size_t kPixelBytes = 4 * sizeof(float);
  const auto slice = [&](std::size_t channel, double fill) {
    return Imf::Slice::Make(Imf::FLOAT, image.rgba.data() + channel, window, kPixelBytes, kPixelBytes * size.width, 1,
                            1, fill);
  };
  Imf::FrameBuffer target;
  for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) target.insert(names[c], slice(c, 0.0));
  target.insert(names[3], slice(3, 1.0));
  file.setFrameBuffer(target);
  file.readPixels(window.min.y, window.max.y);

  for (std::size_t i = 0; grey && i < image.rgba.size(); i += 4) image.rgba[i + 1] = image.rgba[i + 2] = image.rgba[i];
  return image;
}

// The picture is the display window; what the data window leaves of it is transparent black.
FloatImage placed(const FloatImage& data, const Box2i& from, const Box2i& display) {
  const Size size = size_of(display);
  FloatImage image{size.width, size.height, std::vector<float>(channel_count(size))};
  const int left = std::max(from.min.x, display.min.x), right = std::min(from.max.x, display.max.x);
  for (int y = std::max(from.min.y, display.min.y); y <= std::min(from.max.y, display.max.y) && left <= right; ++y) {
    const auto offset = [&](const Box2i& box, std::size_t width) {
      return 4 * (static_cast<std::size_t>(y - box.min.y) * width + static_cast<std::size_t>(left - box.min.x));
    };
    std::copy_n(data.rgba.begin() + static_cast<std::ptrdiff_t>(offset(from, data.width)), 4 * (right - left + 1),
                image.rgba.begin() + static_cast<std::ptrdiff_t>(offset(display, image.width)));
  }
  return image;
}

FloatImage read_picture(Imf::InputPart& file, const std::string& prefix, const std::string& what) {
  FloatImage image = read_data_window(file, prefix, what);
  const Box2i from = file.header().dataWindow(), display = file.header().displayWindow();
  return from == display ? image : placed(image, from, display);
}

// --- layers -------------------------------------------------------------------------------------------------------

// A layer is a part of that name, or those channels of the first part whose names begin with it and a dot.
struct Place {
  int part = 0;
  std::string prefix;
};

std::set<std::string> layer_names(const Imf::MultiPartInputFile& file) {
  std::set<std::string> names;
  file.header(0).channels().layers(names);
  for (int part = 0; part < file.parts(); ++part)
    if (file.header(part).hasName()) names.insert(file.header(part).name());
  return names;
}

bool has_rgb(const Imf::ChannelList& channels, const std::string& prefix) {
  return has_full(channels, (prefix + "R").c_str()) && has_full(channels, (prefix + "G").c_str()) &&
         has_full(channels, (prefix + "B").c_str());
}

// The first part with R, G and B, which need not be the first: renderers put depth before it. Else the layer of
// channels that has them, where there is but one or one is called Combined (Blender's word for the picture). Else the
// first part.
Place main_picture(const Imf::MultiPartInputFile& file) {
  for (int part = 0; part < file.parts(); ++part)
    if (has_rgb(file.header(part).channels(), "")) return {part, ""};
  std::vector<Place> found;
  for (int part = 0; part < file.parts(); ++part) {
    std::set<std::string> layers;
    file.header(part).channels().layers(layers);
    for (const std::string& layer : layers) {
      if (!has_rgb(file.header(part).channels(), layer + ".")) continue;
      found.push_back({part, layer + "."});
      if (layer.ends_with("Combined")) return found.back();
    }
  }
  return found.size() == 1 ? found.front() : Place{};
}

// Luminance at every pixel, and differences of colour at every fourth: OpenEXR knows how to put them together.
bool has_subsampled_colour(const Imf::ChannelList& channels) {
  const auto is_halved = [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && channel->xSampling == 2 && channel->ySampling == 2;
  };
  return has_full(channels, "Y") && is_halved("RY") && is_halved("BY");
}

FloatImage read_subsampled_colour(Bytes data, const std::string& what) {
  MemoryInput stream(data, what);
  Imf::RgbaInputFile file(stream);
  const Box2i window = file.dataWindow();
  const Size size = size_of(window);
  std::vector<Imf::Rgba> pixels(std::size_t{size.width} * size.height);
  const std::ptrdiff_t first = window.min.x + static_cast<std::ptrdiff_t>(window.min.y) * size.width;
  file.setFrameBuffer(pixels.data() - first, 1, size.width);
  file.readPixels(window.min.y, window.max.y);
  FloatImage image{size.width, size.height, {}};
  image.rgba.reserve(channel_count(size));
  for (const Imf::Rgba& pixel : pixels)
    for (const half value : {pixel.r, pixel.g, pixel.b, pixel.a}) image.rgba.push_back(value);
  return window == file.displayWindow() ? image : placed(image, window, file.displayWindow());
}

Place find_layer(const Imf::MultiPartInputFile& file, const std::string& layer, const std::string& what) {
  for (int part = 0; part < file.parts(); ++part)
    if (file.header(part).hasName() && file.header(part).name() == layer) return {part, ""};
  const std::set<std::string> names = layer_names(file);
  if (names.contains(layer)) return {0, layer + "."};
  throw Error(ErrorCode::usage, what,
              names.empty() ? fmt::format("has no layers, so none is named '{}'", layer)
                            : fmt::format("has no layer '{}'; there are {}", layer, fmt::join(names, ", ")));
}

// --- writing ------------------------------------------------------------------------------------------------------

bool opaque(const FloatImage& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 1.0f) return false;
  }
  return true;
}

std::vector<half> halves(const FloatImage& image, const std::string& what) {
  std::size_t clamped = 0;
  std::vector<half> values(image.rgba.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = image.rgba[i];
    const bool too_large = std::isfinite(value) && std::abs(value) > HALF_MAX;
    clamped += too_large ? 1 : 0;
    values[i] = half(too_large ? std::copysign(HALF_MAX, value) : value);
  }
  if (clamped > 0)
    log_warning("{}: {} values above {} were clamped; 32-bit channels hold them", what, clamped, HALF_MAX);
  return values;
}

template <class Channel>
std::vector<std::byte> write_channels(const FloatImage& image, const std::vector<Channel>& rgba, Imf::PixelType type,
                                      const std::string& what) {
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer source;
  constexpr std::array kNames{"R", "G", "B", "A"};
  for (std::size_t c = 0; c < (opaque(image) ? 3 : 4); ++c) {
    header.channels().insert(kNames[c], Imf::Channel(type));
    // A slice has no constant form; OutputFile only reads through it.
    auto* base = reinterpret_cast<char*>(const_cast<Channel*>(rgba.data() + c));
    source.insert(kNames[c], Imf::Slice(type, base, 4 * sizeof(Channel), 4 * sizeof(Channel) * image.width));
  }
  MemoryOutput out(what);
  {
    Imf::OutputFile file(out, header);  // its destructor writes the table of lines
    file.setFrameBuffer(source);
    file.writePixels(static_cast<int>(image.height));
  }
  return out.take();
}

}  // namespace

FloatImage read_exr(Bytes data, const std::string& what, const Limits& limits, const std::string& layer,
                    ExrMeaning meaning) {
  check_exr_headers(data, what, limits);
  try {
    MemoryInput stream(data, what);
    Imf::MultiPartInputFile file(stream);
    const Place place = layer.empty() ? main_picture(file) : find_layer(file, layer, what);
    const Imf::Header& header = file.header(place.part);
    const auto read = [&] {
      if (place.part == 0 && place.prefix.empty() && has_subsampled_colour(header.channels()))
        return read_subsampled_colour(data, what);
      Imf::InputPart part(file, place.part);
      return read_picture(part, place.prefix, what);
    };
    FloatImage image = read();
    if (meaning == ExrMeaning::pixels) return image;
    convert_to_bt709(header, image);
    return panorama_of(header, std::move(image), what, limits);
  } catch (const Error&) { throw; } catch (const std::exception& error) {
    invalid(what, fmt::format("OpenEXR: {}", error.what()));
  }
}

std::vector<std::byte> write_exr(const FloatImage& image, bool half_floats, const std::string& what) {
  VEL_ASSERT(image.rgba.size() == channel_count({image.width, image.height}));
  try {
    return half_floats ? write_channels(image, halves(image, what), Imf::HALF, what)
                       : write_channels(image, image.rgba, Imf::FLOAT, what);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::output_not_written, what, fmt::format("OpenEXR: {}", error.what()));
  }
}

}  // namespace velarium::image
