#include "image/exr_header.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace velarium::image {
namespace {

// The most bytes of a chunk, which is unpacked whole: 16384 pixels of eight floats, 256 rows of them, four times over.
constexpr std::uint64_t kMaxChunkBytes = 1u << 29;

// Walks the attributes of headers (OpenEXR file layout: name, type, size, value).
class AttributeReader {
 public:
  AttributeReader(Bytes data, const std::string& what) : unread_(data), what_(what) {}

  [[nodiscard]] bool at_end() const { return unread_.empty(); }
  [[nodiscard]] std::uint32_t integer() { return bytes_as<std::uint32_t>(take(4)); }
  [[nodiscard]] std::string_view text() {
    const auto end = std::find(unread_.begin(), unread_.end(), std::byte{0});
    if (end == unread_.end()) ends_early();
    const Bytes found = take(static_cast<std::size_t>(end - unread_.begin()));
    (void)take(1);
    return {reinterpret_cast<const char*>(found.data()), found.size()};
  }
  [[nodiscard]] Bytes take(std::size_t size) {
    if (size > unread_.size()) ends_early();
    const Bytes taken = unread_.first(size);
    unread_ = unread_.subspan(size);
    return taken;
  }
  template <class T>
  [[nodiscard]] static T bytes_as(Bytes bytes) {  // files and the machines we run on are little-endian
    T value{};
    std::memcpy(&value, bytes.data(), std::min(sizeof value, bytes.size()));
    return value;
  }

 private:
  [[noreturn]] void ends_early() const { invalid(what_, "OpenEXR: the file ends in its header"); }

  Bytes unread_;
  const std::string& what_;
};

// What decides how large a chunk of pixels is: a block of rows, or a tile.
struct Claims {
  std::uint64_t width = 0, height = 0;
  std::uint64_t tile_width = 0, tile_height = 0;  // 0: not tiled
  std::uint64_t pixel_bytes = 0;                  // of all channels
  std::uint64_t rows = 1;                         // a chunk
};

Size window_size(const std::array<std::int32_t, 4>& box, const std::string& what, const Limits& limits) {
  const std::int64_t width = std::int64_t{box[2]} - box[0] + 1, height = std::int64_t{box[3]} - box[1] + 1;
  if (width < 1 || height < 1 || std::max(width, height) > limits.size) {
    invalid(what, fmt::format("OpenEXR: a window of {} x {} pixels; from 1 to {} a side are read", width, height,
                              limits.size));
  }
  const Size size{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  check_size(size, what, limits);
  return size;
}

// A channel: name, type (1 is half, the others have four bytes), linearity, and how often it is sampled. An empty name
// ends the list, and must do so where the attribute ends: OpenEXR looks at the name alone.
std::uint64_t bytes_of_channels(Bytes value, const std::string& what) {
  constexpr std::uint32_t kHalf = 1;
  constexpr std::size_t kLinearityAndSampling = 12;
  std::uint64_t bytes = 0;
  AttributeReader reader(value, what);
  while (!reader.text().empty()) {
    bytes += reader.integer() == kHalf ? 2 : 4;
    (void)reader.take(kLinearityAndSampling);
  }
  if (!reader.at_end()) invalid(what, "OpenEXR: the list of channels ends before its attribute");
  return bytes;
}

// OpenEXR reads these types without looking at the size that the file gives. Where that is wrong, it and this check
// would see different attributes in what follows.
void check_attribute_size(std::string_view type, std::size_t size, const std::string& what) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 24> kSizes{{
      {"box2f", 16},
      {"box2i", 16},
      {"chromaticities", 32},
      {"compression", 1},
      {"deepImageState", 1},
      {"double", 8},
      {"envmap", 1},
      {"float", 4},
      {"int", 4},
      {"keycode", 28},
      {"lineOrder", 1},
      {"m33d", 72},
      {"m33f", 36},
      {"m44d", 128},
      {"m44f", 64},
      {"rational", 8},
      {"tiledesc", 9},
      {"timecode", 8},
      {"v2d", 16},
      {"v2f", 8},
      {"v2i", 8},
      {"v3d", 24},
      {"v3f", 12},
      {"v3i", 12},
  }};
  const auto row = std::find_if(kSizes.begin(), kSizes.end(), [&](const auto& r) { return r.first == type; });
  if (row != kSizes.end() && row->second != size)
    invalid(what, fmt::format("OpenEXR: an attribute of type {} has {} bytes instead of {}", type, size, row->second));
}

// In the order of the format's compression methods: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
std::uint64_t rows_of_chunk(std::uint8_t compression, const std::string& what) {
  constexpr std::array<std::uint64_t, 10> kRows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  if (compression >= kRows.size()) invalid(what, fmt::format("OpenEXR: compression {} does not exist", compression));
  return kRows[compression];
}

void read_attribute(std::string_view name, std::string_view type, Bytes value, const std::string& what,
                    const Limits& limits, Claims& claims) {
  check_attribute_size(type, value.size(), what);
  if (type == "box2i" && (name == "dataWindow" || name == "displayWindow")) {
    const Size size = window_size(AttributeReader::bytes_as<std::array<std::int32_t, 4>>(value), what, limits);
    if (name == "displayWindow") return;
    claims.width = size.width;
    claims.height = size.height;
  }
  if (type == "chlist") claims.pixel_bytes = std::max(claims.pixel_bytes, bytes_of_channels(value, what));
  if (type == "compression") claims.rows = rows_of_chunk(AttributeReader::bytes_as<std::uint8_t>(value), what);
  if (type == "tiledesc") {
    const auto tile = AttributeReader::bytes_as<std::array<std::uint32_t, 2>>(value);
    if (std::max(tile[0], tile[1]) > limits.size)
      invalid(what, fmt::format("OpenEXR: tiles of {} x {} pixels", tile[0], tile[1]));
    claims.tile_width = tile[0];
    claims.tile_height = tile[1];
  }
}

// The attributes of one header; an empty name ends it.
void check_header(AttributeReader& reader, std::string_view name, const std::string& what, const Limits& limits) {
  Claims claims;
  for (; !name.empty(); name = reader.text()) {
    const std::string_view type = reader.text();
    read_attribute(name, type, reader.take(reader.integer()), what, limits, claims);
  }
  const std::uint64_t pixels =
      std::max(claims.width * std::min(claims.rows, claims.height), claims.tile_width * claims.tile_height);
  const std::uint64_t bytes = pixels * claims.pixel_bytes;
  if (bytes > kMaxChunkBytes)
    invalid(what, fmt::format("OpenEXR: chunks of {} bytes; up to {} are read", bytes, kMaxChunkBytes));
}

}  // namespace

void check_exr_headers(Bytes data, const std::string& what, const Limits& limits) {
  constexpr std::uint32_t kDeepFlag = 0x800, kPartsFlag = 0x1000;  // "non-image" and "multipart", of the version field
  AttributeReader reader(data, what);
  (void)reader.integer();
  const std::uint32_t flags = reader.integer();
  if ((flags & kDeepFlag) != 0) throw Error(ErrorCode::unsupported, what, "OpenEXR: deep data is not supported");
  check_header(reader, reader.text(), what, limits);
  if ((flags & kPartsFlag) == 0) return;
  // A header a part; an empty one ends them.
  for (std::string_view name; !(name = reader.text()).empty();) check_header(reader, name, what, limits);
}

}  // namespace velarium::image
