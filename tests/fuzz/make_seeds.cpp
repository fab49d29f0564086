// Writes what the fuzzers begin with, a folder a target: small valid inputs, which mutations then damage.
// usage: make_seeds FOLDER

#include "core/files.hpp"
#include "image/codecs.hpp"
#include "seeds.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace velarium::fuzz {
namespace {

namespace fs = std::filesystem;

// A mutation of a long file rarely meets anything but vertices.
constexpr std::uintmax_t kLongest = 8192;

void add_files(const Seeds& seeds, const fs::path& folder, std::string_view prefix) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path ending = entry.path().extension();
    const bool scene = ending == ".gltf" || ending == ".glb";
    const bool picture = ending == ".png" || ending == ".jpg" || ending == ".webp";
    if (!entry.is_regular_file() || entry.file_size() > kLongest || !(scene || picture)) continue;
    std::string name = fmt::format("{}-{}", prefix, fs::relative(entry.path(), folder).string());
    for (char& c : name) c = c == '/' ? '-' : c;
    const std::vector<std::byte> bytes = read_file(entry.path(), kLongest);
    seeds.add(scene ? "gltf" : "picture", name, bytes);
    if (ending == ".glb") seeds.add("glb", name, bytes);
  }
}

template <class Image>
Image sample(std::uint32_t width, std::uint32_t height, double scale) {
  Image image{width, height, {}};
  for (std::uint32_t i = 0; i < 4 * width * height; ++i) {
    const double value = static_cast<double>(i * 37 % 101) / 100.0;  // neither flat nor a run
    image.rgba.push_back(static_cast<typename decltype(image.rgba)::value_type>(value * scale));
  }
  return image;
}

void add_pictures(const Seeds& seeds) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, std::pair{17u, 9u}}) {
    const std::string size = fmt::format("{}x{}", width, height);
    const auto bytes = sample<image::ByteImage>(width, height, 255);
    const auto words = sample<image::WordImage>(width, height, 65535);
    const auto floats = sample<image::FloatImage>(width, height, 4);
    seeds.add("picture", size + ".png", image::write_png(bytes, size));
    seeds.add("picture", size + "-16.png", image::write_png(words, size));
    seeds.add("picture", size + ".jpg", image::write_jpeg(bytes, 90, size));
    seeds.add("picture", size + "-lossy.webp", image::write_webp(bytes, 50, size));
    seeds.add("picture", size + "-lossless.webp", image::write_webp(bytes, 100, size));
    seeds.add("exr", size + "-half.exr", image::write_exr(floats, true, size));
    seeds.add("exr", size + "-full.exr", image::write_exr(floats, false, size));
    seeds.add("hdr", size + ".hdr", image::write_hdr(floats));
  }
  // The older run-length code: four pixels, of which three are a run of the first.
  seeds.add("hdr", "old.hdr",
            std::string_view("#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n\x80\x40\x20\x81\1\1\1\3"));
}

void add_texts(const Seeds& seeds) {
  seeds.add("json", "types", R"({"a":[0,-1,1.5e3,true,null,"\u00e9\ud83d\ude00\n"],"b":{"name":{}},"c":[0,0,1]})");
  seeds.add("json", "numbers", R"([18446744073709551615,-9223372036854775808,1e308,1e-308,0.1,4294967296])");
  seeds.add("uri", "base64", "data:application/octet-stream;base64,AAECAwQ=");
  seeds.add("uri", "percent", "data:text/plain,a%20b%FF");
  seeds.add("uri", "file", "./a%20folder/../input.gltf");
  seeds.add("uri", "scheme", "https://example.org/a.bin");
  seeds.add("config", "all",
            "[render]\nsize = '48x32'\neye = [1, 2.5, 3]\n[frame]\nspp = 1\nseed = 0x10\n[display]\nexposure = -1.5\n"
            "tonemap = 'agx'\ndither = false\n[lighting]\nmodel = \"ryse\"\n[output]\nbits = 16\n");
  seeds.add("config", "values",
            "[environment]\nrotation = 1e2\nintensity = inf\ndiffuse = 'sh'\n[x.y]\nz = 1979-05-27\n");
}

void add_accessors(const Seeds& seeds) {
  // The fields of Description in accessors.cpp, then a buffer.
  using Fields = std::array<unsigned char, 11>;
  const auto add = [&](std::string_view name, const Fields& fields) {
    std::string input(fields.begin(), fields.end());
    for (int i = 0; i < 96; ++i) input.push_back(static_cast<char>(i % 64));
    seeds.add("accessors", name, input);
  };
  add("vec3", {6, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0});
  add("strided_bytes", {1, 3, 1, 5, 0, 0, 8, 0, 0, 0, 0});
  add("matrices", {6, 6, 0, 1, 4, 8, 0, 0, 0, 0, 0});
  add("sparse_scalars", {3, 0, 0, 8, 0, 0, 0, 2, 1, 1, 16});
}

void run(const fs::path& folder) {
  const Seeds seeds(folder);
  add_files(seeds, VELARIUM_TEST_DATA, "data");
  if (const char* assets = std::getenv("VELARIUM_ASSETS")) add_files(seeds, assets, "assets");
  add_pictures(seeds);
  add_texts(seeds);
  add_accessors(seeds);
  add_meshes(seeds);
}

}  // namespace
}  // namespace velarium::fuzz

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  velarium::fuzz::run(argv[1]);
  return 0;
}
