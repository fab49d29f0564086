#pragma once

// URIs of buffers and images: data inside the JSON, or files beside it.

#include "core/budget.hpp"
#include "scene/gltf.hpp"
#include "scene/gltf_json.hpp"

#include <cstddef>
#include <vector>

namespace velarium::scene::gltf {

// The bytes that `uri` (a JSON string) stands for: a data URI in base64 or percent encoding, or a file whose name is
// percent-encoded and relative to the glTF file. Throws Error(input_invalid) at the value's pointer for a malformed
// URI, one with another scheme, one that leaves the folder although options forbid it, or one of more bytes than
// the budget has left;
// Error(input_missing) where the file cannot be read. Safe to call from several threads.
[[nodiscard]] std::vector<std::byte> load_uri(const Value& uri, const GltfOptions& options, const Budget& budget);

}  // namespace velarium::scene::gltf
