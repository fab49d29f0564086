#include "gltf_model.hpp"

namespace velarium::scene::test {
namespace {

namespace fs = std::filesystem;

// The triangle, its buffer named by `uri`.
std::string with_uri(const std::string& uri) {
  Model model = triangle();
  model.root["buffers"] = {{{"byteLength", model.buffer.size()}, {"uri", uri}}};
  return model.root.dump();
}

void expect_triangle(const Scene& scene) {
  EXPECT_EQ(scene.primitives.at(0).vertices.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

std::string percent_encoded(const std::string& bytes) {
  std::string text;
  for (const unsigned char byte : bytes) {
    char buffer[4];
    std::snprintf(buffer, sizeof buffer, "%%%02x", byte);
    text += buffer;
  }
  return text;
}

TEST(GltfUri, DataInBase64AndPercentEncoding) {
  const std::string bytes = triangle().buffer;
  expect_triangle(read_text(with_uri("data:application/octet-stream;base64," + base64(bytes))));
  expect_triangle(read_text(with_uri("data:;base64," + base64(bytes))));
  expect_triangle(read_text(with_uri("data:application/gltf-buffer;charset=utf-8;base64," + base64(bytes))));
  expect_triangle(read_text(with_uri("data:application/octet-stream," + percent_encoded(bytes))));
}

TEST(GltfUri, FilesBesideTheSceneWithAnyName) {
  const TemporaryFolder folder;
  const std::string bytes = triangle().buffer;
  const std::pair<const char*, const char*> names[] = {{"plain.bin", "plain.bin"},
                                                       {"with space.bin", "with%20space.bin"},
                                                       {"with space.bin", "with space.bin"},
                                                       {"\xe2\x9d\xa4.bin", "%E2%9D%A4.bin"},
                                                       {"\xe2\x9d\xa4.bin", "\xe2\x9d\xa4.bin"},
                                                       {"100%.bin", "100%25.bin"},
                                                       {"sub/folder.bin", "sub/./x/../folder.bin"}};
  for (const auto& [name, uri] : names) {
    folder.write(name, bytes);
    expect_triangle(read_gltf(folder.write("model.gltf", with_uri(uri))));
  }
}

TEST(GltfUri, NothingOutsideTheFolderUnlessAllowed) {
  const TemporaryFolder folder;
  const std::string bytes = triangle().buffer;
  const fs::path outside = folder.write("outside.bin", bytes);
  folder.write("scene-2/near.bin", bytes);  // shares the folder's name as a prefix
  fs::create_directories(folder.path() / "scene");
  fs::create_symlink(outside, folder.path() / "scene/link.bin");
  GltfOptions allowed;
  allowed.allow_outside_files = true;
  const std::vector<std::string> uris = {"../outside.bin", "%2e%2e/outside.bin",  outside.string(),
                                         "link.bin",       "x/../../outside.bin", "../scene-2/near.bin"};
  for (const std::string& uri : uris) {
    const fs::path file = folder.write("scene/model.gltf", with_uri(uri));
    expect_error(ErrorCode::input_invalid, "/buffers/0/uri: names ", [&] { static_cast<void>(read_gltf(file)); });
    if (uri[0] != 'x') expect_triangle(read_gltf(file, allowed));
  }
}

TEST(GltfUri, FilesThatCannotBeReadAreMissing) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "folder.bin");
  for (const char* uri : {"absent.bin", "folder.bin"}) {
    const fs::path file = folder.write("model.gltf", with_uri(uri));
    expect_error(ErrorCode::input_missing, std::string("/buffers/0/uri: '") + uri,
                 [&] { static_cast<void>(read_gltf(file)); });
  }
}

TEST(GltfUri, MalformedOnesAreRefused) {
  const std::pair<std::string, std::string> cases[] = {{"http://example.org/a.bin", "has a scheme"},
                                                       {"file:///etc/passwd", "has a scheme"},
                                                       {"C:\\a.bin", "has a scheme"},
                                                       {":", "has a scheme"},
                                                       {"//host/a.bin", "names no file"},
                                                       {"", "names no file"},
                                                       {"a%2", "has a '%'"},
                                                       {"a%zz", "has a '%'"},
                                                       {"a%00.bin", "holds a zero byte"},
                                                       {"data:base64", "without a comma"},
                                                       {"data:a/b;;base64,AA==", "has no '='"},
                                                       {"data:;base64,A*==", "not base64, number 1"},
                                                       {"data:;base64,AAAAA", "cut short"}};
  for (const auto& [uri, reason] : cases) {
    expect_error(ErrorCode::input_invalid,
                 "model.gltf: /buffers/0/uri: ", [&] { static_cast<void>(read_text(with_uri(uri))); });
    expect_error(ErrorCode::input_invalid, reason, [&] { static_cast<void>(read_text(with_uri(uri))); });
  }
}

TEST(GltfUri, BuffersTogetherAreBounded) {
  const TemporaryFolder folder;
  folder.write("big.bin", std::string(1000, '\0'));
  Json root = {{"asset", {{"version", "2.0"}}}, {"buffers", Json::array()}};
  GltfOptions options;
  options.limits.bytes = 50'000;
  for (int i = 0; i < 50; ++i) root["buffers"].push_back({{"byteLength", 1000}, {"uri", "big.bin"}});
  EXPECT_NO_THROW(static_cast<void>(read_gltf(folder.write("model.gltf", root.dump()), options)));
  root["buffers"].push_back({{"byteLength", 1000}, {"uri", "big.bin"}});
  const auto file = folder.write("model.gltf", root.dump());
  expect_error(ErrorCode::input_invalid,
               "model.gltf: /buffers/50/uri: with 'big.bin' there are 51000 bytes, more than load.bytes=50000 allows; "
               "-D load.bytes=51000 allows it",
               [&] { static_cast<void>(read_gltf(file, options)); });
}

// Zeros are no pictures: what is refused for its bytes alone was not decoded.
TEST(GltfUri, ImagesTogetherAreBounded) {
  const TemporaryFolder folder;
  const std::size_t enough = 100'000;
  folder.write("a.png", std::string(enough / 2, '\0'));
  folder.write("b.png", std::string(enough / 2 + 1, '\0'));
  Model model = triangle();
  model.root["images"] = {{{"uri", "a.png"}}, {{"uri", "b.png"}}};
  model.root["textures"] = {{{"source", 0}}, {{"source", 1}}};
  model.root["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 1}}}}};
  model.root["meshes"][0]["primitives"][0]["material"] = 0;
  const auto file = folder.write("model.gltf", model.text());
  const auto read = [&](std::uint64_t limit) {
    GltfOptions options;
    options.limits.bytes = limit;
    static_cast<void>(read_gltf(file, options));
  };
  expect_error(ErrorCode::input_invalid,
               "/images/1/uri: with 'b.png' there are 100001 bytes, more than load.bytes=100000 allows; "
               "-D load.bytes=100001 allows it",
               [&] { read(enough); });
  expect_error(ErrorCode::input_invalid, "/images/0 (a.png)", [&] { read(enough + 1); });  // within the limit, no PNG
}

TEST(GltfUri, BuffersHoldWhatTheyPromise) {
  Model model = triangle();
  model.root["buffers"] = {{{"byteLength", model.buffer.size() + 1}, {"uri", "data:;base64," + base64(model.buffer)}}};
  expect_error(ErrorCode::input_invalid, "/buffers/0: holds 72 bytes, fewer than its byteLength of 73",
               [&] { static_cast<void>(read_text(model.root.dump())); });
}

TEST(GltfUri, BuffersWithoutDataMatterOnlyWhereUsed) {
  Model model = triangle();
  model.root["buffers"] = {{{"byteLength", model.buffer.size()}}};
  expect_error(ErrorCode::input_invalid, "/accessors/0: lies in a buffer that has no uri",
               [&] { static_cast<void>(read_text(model.root.dump())); });
  model.root.erase("meshes");
  model.root.erase("nodes");
  model.root.erase("scenes");
  model.root.erase("scene");
  EXPECT_NO_THROW(static_cast<void>(read_text(model.root.dump())));
}

}  // namespace
}  // namespace velarium::scene::test
