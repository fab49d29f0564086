#pragma once

// URIs of buffers and images: data inside the JSON, or files beside it.

#include "core/budget.hpp"
#include "scene/gltf.hpp"
#include "scene/gltf_json.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace velarium::scene::gltf {

[[nodiscard]] bool is_data_uri(std::string_view text);

// What a URI names, found but not read.
struct UriData {
  Value uri;
  std::filesystem::path file;  // empty: the data is in the URI itself
  std::uint64_t bytes = 0;     // of the file, or of the URI's text, which is never shorter than its data
};

// `uri` is a JSON string: a data URI in base64 or percent encoding, or the name of a file, percent-encoded and relative
// to the glTF file. A file that is there under another spelling is taken with a repair: in other cases of letters, with
// backslashes between folders, without a query or fragment behind its name. Spends its bytes. Throws
// Error(input_invalid) at the value's pointer for a malformed name, another scheme, a file outside the folder although
// options forbid it, or more bytes than the budget has left; Error(input_missing) where there is no such file.
[[nodiscard]] UriData find_uri(const Value& uri, const GltfOptions& options, Budget& budget);

// Throws Error(input_invalid) where the data is malformed or the file has grown since it was found,
// Error(input_missing) where it cannot be read. Safe to call from several threads.
[[nodiscard]] std::vector<std::byte> read_uri(const UriData& found);

}  // namespace velarium::scene::gltf
