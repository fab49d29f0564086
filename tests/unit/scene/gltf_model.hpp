#pragma once

// Small glTF files for tests: built in memory, written to a folder of their own, read back.

#include "scene/gltf.hpp"
#include "support/temporary_folder.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace velarium::scene::test {

using Json = nlohmann::json;

// componentType of glTF 2.0, 3.6.2.2.
inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
                     kFloat = 5126;

// A folder of small files, removed with everything in it.
class TemporaryFolder : public velarium::test::TemporaryFolder {
 public:
  std::filesystem::path write(const std::string& name, std::string_view content) const {
    const std::filesystem::path file = path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::remove(file);  // truncating instead makes some file systems flush to disk, thousands of times here
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
};

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    }
    for (std::size_t j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * j) & 63u];
  }
  return text;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

// A glTF document with one buffer that grows as accessors are added.
struct Model {
  Json root = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  // Index of a new view of these bytes, which start at a multiple of 4.
  int add_view(std::string_view bytes, int stride = 0) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) view["byteStride"] = stride;
    buffer += bytes;
    root["bufferViews"].push_back(view);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  // Index of a new accessor over a view of its own.
  template <class T>
  int add(const char* type, int component, std::size_t count, const std::vector<T>& values, bool normalized = false) {
    Json accessor = {
        {"bufferView", add_view(bytes_of(values))}, {"componentType", component}, {"count", count}, {"type", type}};
    if (normalized) accessor["normalized"] = true;
    root["accessors"].push_back(accessor);
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  Json& primitive() { return root["meshes"][0]["primitives"][0]; }

  // The JSON text with the buffer as a data URI.
  [[nodiscard]] std::string text() const {
    Json document = root;
    if (!buffer.empty()) {
      document["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    }
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
};

// One node with one mesh of one primitive: the triangle (0,0,0) (1,0,0) (0,1,0) with normals +Z, not indexed.
inline Model triangle() {
  Model model;
  model.root["scene"] = 0;
  model.root["scenes"] = {{{"nodes", {0}}}};
  model.root["nodes"] = {{{"mesh", 0}}};
  const int positions = model.add<float>("VEC3", kFloat, 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int normals = model.add<float>("VEC3", kFloat, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  model.root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}}}}}};
  return model;
}

inline Scene read_text(std::string_view text, const GltfOptions& options = {}) {
  const TemporaryFolder folder;
  return read_gltf(folder.write("model.gltf", text), options);
}
inline Scene read(const Model& model, const GltfOptions& options = {}) {
  return read_text(model.text(), options);
}

// That `work` throws an Error with this code whose message holds `part`.
inline void expect_error(ErrorCode code, const std::string& part, const std::function<void()>& work) {
  try {
    work();
    ADD_FAILURE() << "no error; expected one with: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what() << "\nhas no: " << part;
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "errors are one line";
  }
}
// Refusals name the pointer right after the file name.
inline void expect_refused(const Model& model, const std::string& part, const GltfOptions& options = {}) {
  expect_error(ErrorCode::input_invalid, "model.gltf: " + part, [&] { static_cast<void>(read(model, options)); });
}

inline bool has_warning(const Scene& scene, std::string_view part) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

// A breach of the specification that is read with a warning, and refused by a strict reader.
inline Scene expect_repaired(const Model& model, const std::string& part) {
  GltfOptions strict;
  strict.strict = true;
  expect_error(ErrorCode::input_invalid, part, [&] { static_cast<void>(read(model, strict)); });
  Scene scene = read(model);
  EXPECT_TRUE(has_warning(scene, part)) << part;
  return scene;
}

}  // namespace velarium::scene::test
