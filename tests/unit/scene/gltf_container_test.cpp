#include "gltf_model.hpp"

namespace velarium::scene::test {
namespace {

std::string word(std::uint32_t value) {
  return bytes_of<std::uint32_t>({value});
}
std::string chunk(const char* type, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  return word(static_cast<std::uint32_t>(content.size())) + std::string(type, 4) + content;
}
std::string glb(const std::string& chunks, std::uint32_t version = 2) {
  return "glTF" + word(version) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

// The triangle with its buffer in the BIN chunk.
std::string triangle_glb() {
  Model model = triangle();
  model.root["buffers"] = {{{"byteLength", model.buffer.size()}}};
  return glb(chunk("JSON", model.root.dump(), ' ') + chunk("BIN\0", model.buffer, '\0'));
}

void refuse(std::string_view content, const std::string& part) {
  const TemporaryFolder folder;
  const auto file = folder.write("model.glb", content);
  expect_error(ErrorCode::input_invalid, "model.glb: " + part, [&] { static_cast<void>(read_gltf(file)); });
}

TEST(GltfContainer, WhatIsNotThereIsMissing) {
  const TemporaryFolder folder;
  expect_error(ErrorCode::input_missing, "absent.gltf",
               [&] { static_cast<void>(read_gltf(folder.path() / "absent.gltf")); });
  expect_error(ErrorCode::input_missing, folder.path().string(), [&] { static_cast<void>(read_gltf(folder.path())); });
}

TEST(GltfContainer, OtherFilesAreRefused) {
  refuse("", "the file is empty");
  refuse("  \n ", "byte 0: neither glTF");
  refuse("\x89PNG\r\n", "byte 0: neither glTF");
  refuse("[]", "byte 0: neither glTF");
  refuse("{}", "/: has no property 'asset'");
}

TEST(GltfContainer, BinaryIsKnownByContent) {
  const TemporaryFolder folder;
  const Scene scene = read_gltf(folder.write("named.gltf", triangle_glb()));
  EXPECT_EQ(scene.primitives.at(0).vertices.positions.at(1), glm::vec3(1, 0, 0));
}

TEST(GltfContainer, AByteOrderMarkIsSkipped) {
  EXPECT_NO_THROW(static_cast<void>(read_text("\xef\xbb\xbf{\"asset\":{\"version\":\"2.0\"}}")));
}

TEST(GltfContainer, EveryTruncationIsRefused) {
  const std::string whole = triangle_glb();
  for (std::size_t size = 0; size < whole.size(); ++size) refuse(std::string_view(whole).substr(0, size), "");
}

TEST(GltfContainer, TruncationIsNamed) {
  refuse(triangle_glb().substr(0, 100), "byte 100: the file is cut short");
}

TEST(GltfContainer, ChunksAreChecked) {
  const std::string json = chunk("JSON", R"({"asset":{"version":"2.0"}})", ' ');
  const std::string bin = chunk("BIN\0", "1234", '\0');
  refuse(glb(json, 1), "byte 4: GLB version 1");
  refuse(glb(bin + json), "byte 16: the first chunk");
  refuse(glb(json + json), "byte 52: the first chunk, and no other");
  refuse(glb(json + bin + bin), "byte 64: a chunk of type BIN must be the second");
  refuse(glb(word(1000) + "JSON"), "byte 12: a chunk of 1000 bytes does not fit");
  refuse(glb(word(4)), "byte 8: a GLB of 16 bytes holds no chunk");
  refuse(glb(word(3) + "JSON{}  \n  "), "byte 12: the chunk's length, 3, is no multiple of 4");
  refuse(glb(word(0xffffffff) + "JSON{}  "), "byte 12: ");
  refuse(glb(chunk("JSON", "", ' ')), "byte 12: the file has no JSON chunk");
}

TEST(GltfContainer, UnknownChunksAreSkipped) {
  const TemporaryFolder folder;
  const std::string json = chunk("JSON", R"({"asset":{"version":"2.0"}})", ' ');
  const auto file = folder.write("m.glb", glb(json + chunk("LATR", "data", '\0')));
  EXPECT_NO_THROW(static_cast<void>(read_gltf(file)));
}

TEST(GltfContainer, FilesBeyondTheLimitAreRefused) {
  GltfOptions options;
  const TemporaryFolder folder;
  const std::string text = R"({"asset":{"version":"2.0"}})";
  ASSERT_EQ(text.size(), 27u);
  const auto file = folder.write("model.gltf", text);
  options.limits.bytes = 27;
  EXPECT_NO_THROW(static_cast<void>(read_gltf(file, options)));
  options.limits.bytes = 26;
  expect_error(ErrorCode::input_invalid,
               "model.gltf: is 27 bytes, more than load.bytes=26 allows; -D load.bytes=27 allows it",
               [&] { static_cast<void>(read_gltf(file, options)); });
}

TEST(GltfContainer, VersionsAreChecked) {
  const auto versioned = [](const char* asset) { return std::string("{\"asset\":") + asset + "}"; };
  EXPECT_NO_THROW(static_cast<void>(read_text(versioned(R"({"version":"2.0"})"))));
  EXPECT_NO_THROW(static_cast<void>(read_text(versioned(R"({"version":"2.1"})"))));
  EXPECT_NO_THROW(static_cast<void>(read_text(versioned(R"({"version":"2.1","minVersion":"2.0"})"))));
  const auto fails = [&](const char* asset, ErrorCode code, const char* part) {
    expect_error(code, part, [&] { static_cast<void>(read_text(versioned(asset))); });
  };
  fails(R"({"version":"1.0"})", ErrorCode::unsupported, "/asset/version: ");
  fails(R"({"version":"3.0"})", ErrorCode::unsupported, "/asset/version: ");
  fails(R"({"version":"2.1","minVersion":"2.1"})", ErrorCode::unsupported, "/asset/minVersion: ");
  for (const char* wrong : {R"({"version":"2"})", R"({"version":"2.x"})", R"({"version":"2.0.1"})", R"({"version":""})",
                            R"({"version":2.0})", R"({"version":"-2.0"})"}) {
    fails(wrong, ErrorCode::input_invalid, "/asset/version: ");
  }
  fails("{}", ErrorCode::input_invalid, "/asset: has no property 'version'");
}

}  // namespace
}  // namespace velarium::scene::test
