// EXT_meshopt_compression, with data that the codec's own encoder makes here.

#include "gltf_model.hpp"

#include <glm/geometric.hpp>
#include <meshoptimizer.h>

#include <random>

namespace velarium::scene::test {
namespace {

constexpr const char* kName = "EXT_meshopt_compression";

std::string encode_attributes(const void* data, std::size_t count, std::size_t stride) {
  std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
  meshopt_encodeVertexVersion(0);
  out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), data, count, stride));
  return out;
}

std::string encode_triangles(const std::vector<unsigned>& indices, std::size_t vertices) {
  std::string out(meshopt_encodeIndexBufferBound(indices.size(), vertices), '\0');
  out.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(),
                                       indices.size()));
  return out;
}

std::string encode_sequence(const std::vector<unsigned>& indices, std::size_t vertices) {
  std::string out(meshopt_encodeIndexSequenceBound(indices.size(), vertices), '\0');
  out.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(),
                                         indices.size()));
  return out;
}

// Makes the view that this accessor reads a compressed one of a fallback buffer without data.
Json& compress(Model& model, int accessor, const std::string& bytes, const char* mode, int stride, int count,
               const char* name = kName) {
  const int packed = model.add_view(bytes);
  const Json source = model.root["bufferViews"][packed];
  Json& view = model.root["bufferViews"][model.root["accessors"][accessor]["bufferView"].get<int>()];
  view["buffer"] = 1;
  view["byteOffset"] = 0;
  view["byteLength"] = stride * count;
  Json& extension = view["extensions"][name];
  extension = {{"buffer", 0},
               {"byteOffset", source["byteOffset"]},
               {"byteLength", bytes.size()},
               {"byteStride", stride},
               {"count", count},
               {"mode", mode}};
  model.root["extensionsUsed"] = {name};
  return extension;
}

std::string text_with_fallback(const Model& model) {
  Json document = Json::parse(model.text());
  document["buffers"].push_back({{"byteLength", 1 << 20}, {"extensions", {{kName, {{"fallback", true}}}}}});
  return document.dump();
}
Scene read_compressed(const Model& model) {
  return read_text(text_with_fallback(model));
}

void refuse(const Model& model, const std::string& part) {
  expect_error(ErrorCode::input_invalid, part, [&] { static_cast<void>(read_compressed(model)); });
}

const std::vector<float> kPositions = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Model compressed_triangle(const char* name = kName) {
  Model model = triangle();
  model.primitive()["indices"] = model.add<std::uint16_t>("SCALAR", kUnsignedShort, 3, {0, 1, 2});
  compress(model, 0, encode_attributes(kPositions.data(), 3, 12), "ATTRIBUTES", 12, 3, name);
  compress(model, 2, encode_triangles({0, 1, 2}, 3), "TRIANGLES", 2, 3, name);
  return model;
}

Json& extension_of(Model& model, int view) {
  return model.root["bufferViews"][view]["extensions"][kName];
}

TEST(GltfMeshopt, AttributesAndTriangles) {
  for (const char* name : {kName, "KHR_meshopt_compression"}) {
    const Scene scene = read_compressed(compressed_triangle(name));
    const Primitive& primitive = scene.primitives.at(0);
    EXPECT_EQ(primitive.vertices.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  }
}

TEST(GltfMeshopt, IndexSequences) {
  Model model = triangle();
  model.primitive()["mode"] = 1;
  model.primitive()["indices"] = model.add<std::uint32_t>("SCALAR", kUnsignedInt, 4, {2, 0, 0, 1});
  compress(model, 2, encode_sequence({2, 0, 0, 1}, 3), "INDICES", 4, 4);
  EXPECT_EQ(read_compressed(model).primitives.at(0).indices, (std::vector<std::uint32_t>{2, 0, 0, 1}));
}

// 16 bits of octahedron hold a direction to about 1e-4.
TEST(GltfMeshopt, OctahedralNormals) {
  const std::vector<float> normals = {0.6f, 0, 0.8f, 0, 0, -0.6f, 0.8f, 0, 0, 0, -1, 0};
  std::vector<std::int16_t> encoded(12);
  meshopt_encodeFilterOct(encoded.data(), 3, 8, 16, normals.data());
  Model model = triangle();
  model.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  model.root["accessors"][1].update({{"componentType", kShort}, {"normalized", true}});
  model.root["bufferViews"][1]["byteStride"] = 8;
  compress(model, 1, encode_attributes(encoded.data(), 3, 8), "ATTRIBUTES", 8, 3)["filter"] = "OCTAHEDRAL";
  model.root["extensionsUsed"].push_back("KHR_mesh_quantization");
  const Scene scene = read_compressed(model);
  const std::vector<glm::vec3>& read = scene.primitives.at(0).vertices.normals;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::length(read[i] - glm::vec3(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2])), 2e-4f) << i;
  }
}

TEST(GltfMeshopt, ExponentialPositions) {
  std::vector<std::uint32_t> encoded(9);
  meshopt_encodeFilterExp(encoded.data(), 3, 12, 15, kPositions.data());
  Model model = triangle();
  compress(model, 0, encode_attributes(encoded.data(), 3, 12), "ATTRIBUTES", 12, 3)["filter"] = "EXPONENTIAL";
  EXPECT_EQ(read_compressed(model).primitives.at(0).vertices.positions[1], glm::vec3(1, 0, 0));
}

TEST(GltfMeshopt, QuaternionsOfInstances) {
  const std::vector<float> turned = {0, 0, 0.6f, 0.8f, 0, 0, 0, 1};
  std::vector<std::int16_t> encoded(8);
  meshopt_encodeFilterQuat(encoded.data(), 2, 8, 16, turned.data());
  Model model = triangle();
  const int rotations = model.add<std::int16_t>("VEC4", kShort, 2, std::vector<std::int16_t>(8), true);
  compress(model, rotations, encode_attributes(encoded.data(), 2, 8), "ATTRIBUTES", 8, 2)["filter"] = "QUATERNION";
  model.root["extensionsUsed"].push_back("EXT_mesh_gpu_instancing");
  model.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] = rotations;
  const glm::quat read = read_compressed(model).nodes.at(0).instances.at(0).rotation;
  EXPECT_NEAR(std::abs(glm::dot(read, glm::quat(0.8f, 0, 0, 0.6f))), 1.0f, 1e-6f);
}

TEST(GltfMeshopt, RulesOfTheExtensionAreChecked) {
  const auto broken = [](int view, const char* key, const Json& value, const std::string& part) {
    Model model = compressed_triangle();
    extension_of(model, view)[key] = value;
    refuse(model, "/bufferViews/" + std::to_string(view) + "/extensions/EXT_meshopt_compression" + part);
  };
  broken(0, "mode", "VERTICES", "/mode: ");
  broken(0, "filter", "COLOR", "/filter: ");
  broken(0, "filter", "OCTAHEDRAL", "/byteStride: is 12, must be 4 or 8");
  broken(0, "count", 4, "/count: 4 elements of 12 bytes do not fill the view of 36 bytes");
  broken(0, "byteStride", 0, "/byteStride: ");
  broken(0, "byteStride", 260, "/byteStride: ");
  broken(0, "buffer", 1, "/buffer: has no data");
  broken(0, "byteLength", 1 << 20, "/byteLength: ");
  broken(0, "byteLength", 2, ": the compressed data is damaged");
  broken(2, "filter", "EXPONENTIAL", "/filter: is for attributes only");
}

// A file of a few bytes that promises much is refused before there is memory for it.
TEST(GltfMeshopt, PromisesAreHeldAgainstTheBytesThereAre) {
  Model model = compressed_triangle();
  extension_of(model, 0)["count"] = 85000;
  model.root["bufferViews"][0]["byteLength"] = 12 * 85000;
  refuse(model, "cannot hold 85000 elements, which take 15937 at least");
}

TEST(GltfMeshopt, LaterVersionsAreNamed) {
  Model model = compressed_triangle();
  const std::size_t place = extension_of(model, 0)["byteOffset"];
  model.buffer[place] = static_cast<char>(model.buffer[place] | 1);
  expect_error(ErrorCode::unsupported, "is of version 1 of the codec",
               [&] { static_cast<void>(read_compressed(model)); });
}

TEST(GltfMeshopt, DamagedDataIsReadOrRefused) {
  const Model whole = compressed_triangle();
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    Model model = whole;
    for (std::uint32_t i = random() % 4 + 1; i > 0; --i) {
      model.buffer[random() % model.buffer.size()] = static_cast<char>(random());
    }
    try {
      static_cast<void>(read_compressed(model));
    } catch (const Error& error) { EXPECT_NE(error.code(), ErrorCode::internal) << error.what(); }
  }
}

}  // namespace
}  // namespace velarium::scene::test
