#include "support.hpp"

#include "scene/gltf_buffers.hpp"

#include <fmt/core.h>

#include <array>

namespace velarium::fuzz {
namespace {

using namespace scene::gltf;  // the target is that namespace's reader

constexpr std::array<const char*, 4> kModes{"ATTRIBUTES", "TRIANGLES", "INDICES", "OTHERS"};
constexpr std::array<const char*, 4> kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};

// What the first bytes of the input choose. Two bytes make the count, the low one first.
struct Description {
  std::uint8_t mode, filter, stride, count[2];
};

std::string document_of(const Description& d, std::size_t buffer_bytes) {
  const int count = d.count[0] + 256 * d.count[1];
  return fmt::format(
      R"({{"buffers":[{{"byteLength":{0}}},{{"byteLength":{1}}}],"bufferViews":[{{"buffer":1,"byteLength":{1},)"
      R"("extensions":{{"EXT_meshopt_compression":{{"buffer":0,"byteLength":{0},"byteStride":{2},"count":{3},)"
      R"("mode":"{4}","filter":"{5}"}}}}}}]}})",
      buffer_bytes, std::max(1, d.stride * count), d.stride, count, kModes[d.mode % kModes.size()],
      kFilters[d.filter % kFilters.size()]);
}

}  // namespace

void meshopt(Bytes input) {
  const auto parts = described<Description>(input);
  if (!parts) return;
  expect_orderly([&] {
    Container container;
    container.binary = parts->data;
    Document document("input.gltf", document_of(parts->description, parts->data.size()), {.depth = 16});
    const Buffers buffers(document.root(), container, {});
  });
}

}  // namespace velarium::fuzz
