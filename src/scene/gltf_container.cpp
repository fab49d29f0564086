#include "scene/gltf_container.hpp"

#include "core/files.hpp"
#include "core/foreign_files.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <bit>
#include <cstring>

namespace velarium::scene::gltf {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and its data is read as it lies");

namespace {

// glTF 2.0, 4.4: "glTF", "JSON" and "BIN\0" as little-endian words.
constexpr std::uint32_t kMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr std::size_t kHeaderSize = 12, kChunkHeaderSize = 8;

// Walks the chunks of a GLB and says, on failure, at which byte.
class GlbParser {
 public:
  GlbParser(const std::filesystem::path& file, Container& container) : file_(file), container_(container) {}

  void parse() {
    parse_header();
    for (std::size_t index = 0; offset_ < end_; ++index) parse_chunk(index);
    if (container_.json.empty()) fail(kHeaderSize, "the file has no JSON chunk");
  }

 private:
  [[noreturn]] void fail(std::size_t offset, const std::string& reason) const {
    throw Error(ErrorCode::input_invalid, file_, fmt::format("byte {}: {}", offset, reason));
  }

  [[nodiscard]] std::uint32_t word(std::size_t offset) const {
    std::uint32_t value = 0;
    std::memcpy(&value, container_.bytes.data() + offset, sizeof value);
    return value;
  }

  void parse_header() {
    const std::size_t size = container_.bytes.size();
    if (size < kHeaderSize) fail(size, "the file ends within the GLB header; fetch it again");
    if (word(4) != 2) fail(4, fmt::format("GLB version {} is not supported; export the scene as glTF 2.0", word(4)));
    end_ = word(8);
    if (end_ < kHeaderSize + kChunkHeaderSize) fail(8, fmt::format("a GLB of {} bytes holds no chunk", end_));
    if (end_ > size) {
      fail(size, fmt::format("the file is cut short: its header promises {} bytes; fetch it again", end_));
    }
    offset_ = kHeaderSize;
  }

  void parse_chunk(std::size_t index) {
    if (end_ - offset_ < kChunkHeaderSize) fail(offset_, "the file ends within a chunk header");
    const std::uint32_t length = word(offset_), type = word(offset_ + 4);
    const std::size_t start = offset_ + kChunkHeaderSize;
    if (length > end_ - start) fail(offset_, fmt::format("a chunk of {} bytes does not fit the file", length));
    if (length % 4 != 0) fail(offset_, fmt::format("the chunk's length, {}, is no multiple of 4", length));
    if ((index == 0) != (type == kJsonChunk)) fail(offset_ + 4, "the first chunk, and no other, must be of type JSON");
    if (type == kBinaryChunk && index != 1) fail(offset_ + 4, "a chunk of type BIN must be the second one");

    const std::span<const std::byte> data(container_.bytes.data() + start, length);
    if (type == kJsonChunk) container_.json = {reinterpret_cast<const char*>(data.data()), data.size()};
    if (type == kBinaryChunk) container_.binary = data;
    offset_ = start + length;
  }

  const std::filesystem::path& file_;
  Container& container_;
  std::size_t offset_ = 0, end_ = 0;
};

// Says of a file of another kind what it is not, where the JSON parser would speak of tokens.
void check_is_json(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  const std::size_t start = text.find_first_not_of(" \t\r\n", text.starts_with(kByteOrderMark) ? 3 : 0);
  if (start != std::string_view::npos && text[start] == '{') return;
  const std::string_view kind = foreign_kind(bytes);
  throw Error(ErrorCode::input_invalid, file,
              fmt::format("byte 0: neither glTF, which begins with '{{', nor GLB, which begins with \"glTF\"{}{}",
                          kind.empty() ? "" : "; the file ", kind));
}

}  // namespace

Container open_container(const std::filesystem::path& file, const GltfLimits& limits) {
  Container container;
  container.bytes = read_file(file, Budget("load.bytes", limits.bytes));
  if (container.bytes.empty()) throw Error(ErrorCode::input_invalid, file, "the file is empty");
  std::uint32_t magic = 0;
  std::memcpy(&magic, container.bytes.data(), std::min(sizeof magic, container.bytes.size()));
  if (magic == kMagic) {
    GlbParser(file, container).parse();
  } else {
    check_is_json(file, container.bytes);
    container.json = {reinterpret_cast<const char*>(container.bytes.data()), container.bytes.size()};
  }
  return container;
}

}  // namespace velarium::scene::gltf
