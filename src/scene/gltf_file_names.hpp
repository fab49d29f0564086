#pragma once

// Files that URIs name, as the folders beside the scene spell them.

#include "scene/gltf.hpp"
#include "scene/gltf_json.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace velarium::scene::gltf {

[[nodiscard]] std::string lower_case(std::string_view text);

// RFC 3986, 2.1. Bytes that are not encoded, spaces and UTF-8 among them, stand for themselves. Throws
// Error(input_invalid) at `uri` for a '%' that encodes nothing.
[[nodiscard]] std::string percent_decoded(const Value& uri, std::string_view text);

struct NamedFile {
  std::string name;            // relative to the scene's folder
  std::filesystem::path file;  // every `..` and link resolved
};

// The file that `text` names relative to the folder of the scene, there or not. A file that is there under another
// spelling is taken with a repair: in other cases of letters, with backslashes between folders, without a query or
// fragment behind its name. Throws Error(input_invalid) at `uri` for a malformed name, or one outside the folder
// although options forbid it.
[[nodiscard]] NamedFile find_beside(const Value& uri, std::string_view text, const GltfOptions& options);

}  // namespace velarium::scene::gltf
