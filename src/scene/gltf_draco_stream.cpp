#include "scene/gltf_draco_stream.hpp"

#include <velarium/error.hpp>

#include <draco/compression/entropy/symbol_decoding.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <fmt/core.h>

#include <new>
#include <optional>
#include <stdexcept>
#include <string>

namespace velarium::scene::gltf {

// Reads a stream from its start; throws where it ends early.
class DracoCursor {
 public:
  DracoCursor(const Value& at, std::span<const std::byte> bytes) : at_(at), rest_(bytes) {}

  [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

  std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) at_.fail("the compressed data ends within its header");
    const std::span<const std::byte> taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  std::uint8_t byte() { return std::to_integer<std::uint8_t>(take(1).front()); }

  // Seven bits a byte, the lowest first. As the library reads it: bits beyond 32 are lost, a sixth byte is an error.
  std::uint32_t varint() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      const std::uint32_t next = byte();
      value |= (next & 0x7fu) << shift;
      if (next < 0x80u) return value;
    }
    at_.fail("the compressed data has a number of more than five bytes in its header");
  }

 private:
  const Value& at_;
  std::span<const std::byte> rest_;
};

namespace {

// "Draco Bitstream Specification", 2.2: DRACO, two bytes of version, kind, method, two bytes of flags.
constexpr std::string_view kMagic = "DRACO";
constexpr std::size_t kHeaderSize = 11;
constexpr std::uint8_t kMajor = 2, kMinor = 2, kTriangleMesh = 1, kSequential = 0, kEdgebreaker = 1;
constexpr std::uint8_t kMetadataFlag = 0x80;  // in the second byte of the flags
constexpr std::uint8_t kStandardTraversal = 0, kValenceTraversal = 2;

// Metadata has no place in glTF. The library would decode it into memory that grows as the square of its length, so
// it is skipped here: trees of entries, whose order matters only to those who read them.
void skip_metadata(DracoCursor& cursor) {
  const auto skip_entries = [&] {
    for (std::uint32_t entries = cursor.varint(); entries > 0; --entries) {
      cursor.take(cursor.byte());
      cursor.take(cursor.varint());
    }
  };
  const auto skip_tree = [&] {
    skip_entries();
    for (std::uint64_t pending = cursor.varint(); pending > 0; --pending) {
      cursor.take(cursor.byte());
      skip_entries();
      pending += cursor.varint();
    }
  };
  for (std::uint32_t attributes = cursor.varint(); attributes > 0; --attributes) {
    static_cast<void>(cursor.varint());  // whose
    skip_tree();
  }
  skip_tree();
}

struct Header {
  std::uint8_t method = 0;
  bool has_metadata = false;
};

Header read_header(const Value& at, DracoCursor& cursor) {
  for (const char letter : kMagic) {
    if (cursor.byte() != static_cast<std::uint8_t>(letter)) at.fail("the compressed data does not begin with DRACO");
  }
  const std::uint8_t major = cursor.byte(), minor = cursor.byte();
  if (major != kMajor || minor != kMinor) {
    throw Error(ErrorCode::unsupported, at.file(),
                fmt::format("{}: the data is of version {}.{} of Draco's bitstream, must be 2.2; compress it anew",
                            at.pointer(), major, minor));
  }
  if (cursor.byte() != kTriangleMesh) at.fail("the compressed data is a cloud of points, must be triangles");
  Header header;
  header.method = cursor.byte();
  if (header.method > kEdgebreaker) at.fail(fmt::format("the compressed data is of unknown method {}", header.method));
  static_cast<void>(cursor.byte());
  header.has_metadata = (cursor.byte() & kMetadataFlag) != 0;
  return header;
}

// In elements of 16 bytes, what an attribute of so many points takes: its values, and 32 bits a component to decode
// them from.
std::uint64_t elements_of(const draco::PointAttribute& attribute, std::uint64_t points) {
  const std::uint64_t bytes = static_cast<std::uint64_t>(attribute.byte_stride()) + 4ull * attribute.num_components();
  return points * ((bytes + 15) / 16);
}

// Why the attributes are not to be decoded; empty where they may.
std::string objection(const draco::Mesh& mesh, const DracoStream::Bounds& bounds) {
  if (mesh.num_points() != bounds.points) {
    return fmt::format("the compressed data has {} vertices, but its accessors have {}", mesh.num_points(),
                       bounds.points);
  }
  std::uint64_t elements = 0;
  for (std::int32_t i = 0; i < mesh.num_attributes(); ++i) elements += elements_of(*mesh.attribute(i), bounds.points);
  return bounds.elements.fits(elements) ? ""
                                        : "with its attributes, the scene has " + bounds.elements.refusal(elements);
}

constexpr int kUvComponents = 2;

// How many bits of orientation a prediction of texture coordinates has, which the library would read as long as zeros
// last: `ahead` stands before the values that they follow. None where the stream ends before.
std::optional<std::int32_t> orientations_after(draco::DecoderBuffer ahead, std::uint32_t values) {
  std::uint8_t compressed = 0, bytes = 0;
  if (!ahead.Decode(&compressed)) return std::nullopt;
  std::vector<std::uint32_t> skipped(std::size_t{values} * kUvComponents);
  if (compressed > 0) {
    if (!draco::DecodeSymbols(values * kUvComponents, kUvComponents, &ahead, skipped.data())) return std::nullopt;
  } else {
    if (!ahead.Decode(&bytes) || bytes > sizeof skipped.front()) return std::nullopt;
    if (!ahead.Decode(skipped.data(), skipped.size() * bytes)) return std::nullopt;
  }
  std::int32_t orientations = 0;
  return ahead.Decode(&orientations) ? std::optional(orientations) : std::nullopt;
}

// The library's decoder, which stops to ask between the connectivity, of bounded size, and attributes of any size, and
// looks ahead where the library takes a count as it comes.
template <class Decoder>
class BoundedDecoder final : public Decoder {
 public:
  BoundedDecoder(const draco::DecoderBuffer& input, const DracoStream::Bounds& bounds)
      : input_(input), bounds_(bounds) {}
  [[nodiscard]] const std::string& objections() const { return objection_; }

 private:
  bool DecodeAllAttributes() override {
    objection_ = objection(*this->mesh(), bounds_);
    return objection_.empty() && Decoder::DecodeAllAttributes();
  }

  // Asked when two bytes have been read of an attribute that is predicted along the mesh: the method and its transform.
  // Without an answer, the library predicts in a simpler way; what it then reads is thrown away.
  const draco::MeshAttributeIndicesEncodingData* GetAttributeEncodingData(int id) const override {
    const draco::MeshAttributeIndicesEncodingData* data = Decoder::GetAttributeEncodingData(id);
    if (!data) return nullptr;
    const draco::PointAttribute& attribute = *this->point_cloud()->attribute(id);
    const std::size_t values = attribute.size();
    const auto method = static_cast<std::uint8_t>(input_.data_head()[-2]);
    // Predictions write a value for each corner of the map.
    bool sound = data->encoded_attribute_value_index_to_corner_map.size() == values &&
                 method != draco::MESH_PREDICTION_TEX_COORDS_DEPRECATED;
    if (sound && method == draco::MESH_PREDICTION_TEX_COORDS_PORTABLE) {
      const auto count = orientations_after(input_, static_cast<std::uint32_t>(values));
      sound = attribute.num_components() == kUvComponents && count && *count >= 0 &&
              static_cast<std::size_t>(*count) <= values;
    }
    if (!sound) objection_ = "the compressed data is damaged";
    return sound ? data : nullptr;
  }

  const draco::DecoderBuffer& input_;
  const DracoStream::Bounds& bounds_;
  mutable std::string objection_;  // where the library asks, it takes us for constant
};

template <class Decoder>
std::unique_ptr<draco::Mesh> decode_by(const Value& at, std::span<const std::byte> bytes,
                                       const DracoStream::Bounds& bounds) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const draco::DecoderOptions options;
  auto mesh = std::make_unique<draco::Mesh>();
  BoundedDecoder<Decoder> decoder(buffer, bounds);
  const draco::Status status = decoder.Decode(options, &buffer, mesh.get());
  if (!decoder.objections().empty()) at.fail(decoder.objections());
  if (!status.ok()) at.fail("the compressed data is damaged");
  return mesh;
}

}  // namespace

DracoStream::DracoStream(const Value& at, std::span<const std::byte> bytes) : at_(at), bytes_(bytes) {
  DracoCursor cursor(at_, bytes);
  const Header header = read_header(at_, cursor);
  if (header.has_metadata) {
    skip_metadata(cursor);
    without_metadata_.assign(bytes.begin(), bytes.begin() + kHeaderSize);
    without_metadata_.back() &= ~std::byte{kMetadataFlag};
    without_metadata_.insert(without_metadata_.end(), cursor.rest().begin(), cursor.rest().end());
    bytes_ = without_metadata_;
  }
  edgebreaker_ = header.method == kEdgebreaker;
  read_counts(cursor);
}

// The first fields of the connectivity: "Sequential Decoder" and "EdgeBreaker Decoder" of the specification.
void DracoStream::read_counts(DracoCursor& cursor) {
  if (!edgebreaker_) {
    faces_ = cursor.varint();
    fewest_points_ = cursor.varint();
    return;
  }
  const std::uint8_t traversal = cursor.byte();
  if (traversal != kStandardTraversal && traversal != kValenceTraversal) {
    at_.fail(fmt::format("the compressed data is of unknown traversal {}", traversal));
  }
  fewest_points_ = cursor.varint();
  faces_ = cursor.varint();
  attribute_tables_ = cursor.byte();
}

// Per corner, the tables of the connectivity hold four indices, and one more for each attribute with seams.
void DracoStream::check_tables(const Bounds& bounds) const {
  const std::uint64_t elements = 3ull * faces_ * (4 + attribute_tables_) / 4;
  if (!bounds.elements.fits(elements)) at_.fail("to decode it takes " + bounds.elements.refusal(elements));
}

std::unique_ptr<draco::Mesh> DracoStream::decode(const Bounds& bounds) const {
  check_tables(bounds);
  try {
    return edgebreaker_ ? decode_by<draco::MeshEdgebreakerDecoder>(at_, bytes_, bounds)
                        : decode_by<draco::MeshSequentialDecoder>(at_, bytes_, bounds);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::temporary, at_.file(), fmt::format("{}: memory ran out while decoding", at_.pointer()));
  } catch (const std::length_error&) { at_.fail("the compressed data is damaged"); }
}

}  // namespace velarium::scene::gltf
