#include "core/foreign_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace velarium {
namespace {

struct Kind {
  std::string_view start, meaning;
};

// Signatures of the formats' own documents.
constexpr std::array kKinds{
    Kind{"version https://git-lfs", "is a pointer of Git LFS, not the file; `git lfs pull` fetches it"},
    Kind{"PK\3\4", "is a ZIP archive; unpack it"},
    Kind{"\x1f\x8b", "is compressed by gzip; unpack it"},
    Kind{"\xfd"
         "7zXZ",
         "is compressed by xz; unpack it"},
    Kind{"\x28\xb5\x2f\xfd", "is compressed by Zstandard; unpack it"},
    Kind{"7z\xbc\xaf\x27\x1c", "is a 7-Zip archive; unpack it"},
    Kind{"#usda", "is a USD scene; export it as glTF"},
    Kind{"PXR-USDC", "is a USD scene; export it as glTF"},
    Kind{"ply\n", "is a PLY mesh; convert it to glTF"},
    Kind{"ply\r", "is a PLY mesh; convert it to glTF"},
    Kind{"Kaydara FBX", "is an FBX scene; export it as glTF"},
    Kind{"; FBX", "is an FBX scene; export it as glTF"},
    Kind{"BLENDER", "is a Blender file; export the scene as glTF"},
    Kind{"solid ", "is an STL mesh; convert it to glTF"},
    Kind{"\x89PNG", "is a PNG picture"},
    Kind{"\xff\xd8\xff", "is a JPEG picture"},
    Kind{"\x76\x2f\x31\x01", "is an OpenEXR picture"},
    Kind{"#?RADIANCE", "is a Radiance picture"},
    Kind{"%PDF", "is a PDF document"},
    Kind{"\x7f"
         "ELF",
         "is a program"},
};

std::string lower_start(std::string_view text) {
  std::string start(text.substr(0, 64));
  std::ranges::transform(start, start.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return start;
}

// Its lines are statements: comments, `mtllib`, `o`, `v` and others.
bool looks_like_obj(std::string_view text) {
  for (int line = 0; line < 64 && !text.empty(); ++line) {
    const std::string_view statement = text.substr(0, text.find('\n'));
    if (statement.starts_with("v ") || statement.starts_with("mtllib ")) return true;
    const bool passed = statement.empty() || statement == "\r" || statement.starts_with('#') ||
                        statement.starts_with("o ") || statement.starts_with("g ");
    if (!passed) return false;
    text.remove_prefix(std::min(text.size(), statement.size() + 1));
  }
  return false;
}

// 80 bytes of anything, the number of triangles, 50 bytes each.
bool is_binary_stl(std::span<const std::byte> bytes) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  if (bytes.size() <= kHeader) return false;
  std::size_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count << 8u | std::to_integer<std::size_t>(bytes[80 + i]);
  return bytes.size() == kHeader + kTriangle * count;
}

}  // namespace

std::string_view foreign_kind(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const Kind& kind : kKinds)
    if (text.starts_with(kind.start)) return kind.meaning;
  const std::string start = lower_start(text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size())));
  if (start.starts_with("<!doctype html") || start.starts_with("<html"))
    return "is a web page, perhaps of a failed download; fetch the file itself";
  if (start.starts_with("<?xml") || start.starts_with("<collada")) return "is XML; scenes are read as glTF";
  if (looks_like_obj(text)) return "is an OBJ mesh; convert it to glTF";
  if (is_binary_stl(bytes)) return "is an STL mesh; convert it to glTF";
  return {};
}

}  // namespace velarium
