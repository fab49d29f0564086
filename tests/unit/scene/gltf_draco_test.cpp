// KHR_draco_mesh_compression, with data that the format's own encoder makes here.

#include "gltf_model.hpp"

#include <draco/compression/encode.h>
#include <draco/core/encoder_buffer.h>
#include <draco/metadata/geometry_metadata.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

namespace velarium::scene::test {
namespace {

constexpr const char* kName = "KHR_draco_mesh_compression";

// A bowl of (kSide + 1)^2 vertices with normals, bytes of colour and texture coordinates; 7 to 10 in the data.
constexpr std::uint32_t kSide = 6, kPoints = (kSide + 1) * (kSide + 1), kFaces = 2 * kSide * kSide;
constexpr std::uint32_t kPositionId = 7, kNormalId = 8, kColorId = 9, kUvId = 10;

glm::vec3 position_of(std::uint32_t point) {
  const float x = static_cast<float>(point % (kSide + 1)) / kSide, z = static_cast<float>(point / (kSide + 1)) / kSide;
  return {x, (x - 0.5f) * (x - 0.5f) + (z - 0.5f) * (z - 0.5f), z};
}
glm::vec3 normal_of(std::uint32_t point) {
  const glm::vec3 p = position_of(point);
  return glm::normalize(glm::vec3(1 - 2 * p.x, 1, 1 - 2 * p.z));
}
std::array<std::uint8_t, 4> color_of(std::uint32_t point) {
  return {static_cast<std::uint8_t>(point), static_cast<std::uint8_t>(5 * point), 200, 255};
}

glm::vec2 uv_of(std::uint32_t point) {
  return {position_of(point).x, 1.0f - position_of(point).z};
}

std::array<std::uint32_t, 3> face_of(std::uint32_t face) {
  const std::uint32_t cell = face / 2, corner = cell / kSide * (kSide + 1) + cell % kSide;
  if (face % 2 == 0) return {corner, corner + kSide + 1, corner + 1};
  return {corner + 1, corner + kSide + 1, corner + kSide + 2};
}

template <class ValueOf>
void add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data, std::int8_t components,
                   std::uint32_t unique_id, const ValueOf& value_of) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(components), data, false,
                 draco::DataTypeLength(data) * components, 0);
  const int id = mesh.AddAttribute(attribute, true, kPoints);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const auto value = value_of(i);
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &value);
  }
  mesh.attribute(id)->set_unique_id(unique_id);
}

std::unique_ptr<draco::Mesh> bowl() {
  auto out = std::make_unique<draco::Mesh>();
  draco::Mesh& mesh = *out;
  mesh.set_num_points(kPoints);
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    const auto [a, b, c] = face_of(i);
    mesh.SetFace(draco::FaceIndex(i), {draco::PointIndex(a), draco::PointIndex(b), draco::PointIndex(c)});
  }
  using Attribute = draco::GeometryAttribute;
  add_attribute(mesh, Attribute::POSITION, draco::DT_FLOAT32, 3, kPositionId, position_of);
  add_attribute(mesh, Attribute::NORMAL, draco::DT_FLOAT32, 3, kNormalId, normal_of);
  add_attribute(mesh, Attribute::COLOR, draco::DT_UINT8, 4, kColorId, color_of);
  add_attribute(mesh, Attribute::TEX_COORD, draco::DT_FLOAT32, 2, kUvId, uv_of);
  return out;
}

constexpr int kPositionBits = 14, kNormalBits = 10;

enum class Method { sequential, edgebreaker };  // the first keeps the order of points, and here floats as they are

std::string encode(const draco::Mesh& mesh, Method method) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method == Method::sequential ? draco::MESH_SEQUENTIAL_ENCODING
                                                         : draco::MESH_EDGEBREAKER_ENCODING);
  if (method == Method::edgebreaker) {
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, kPositionBits);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, kNormalBits);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, kPositionBits);
    encoder.SetSpeedOptions(0, 0);  // every prediction that there is
  }
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

// A primitive whose accessors have no views but are as the data is.
Model compressed(const std::string& data) {
  Model model = triangle();
  model.root["accessors"] = {{{"componentType", kFloat}, {"count", kPoints}, {"type", "VEC3"}},
                             {{"componentType", kFloat}, {"count", kPoints}, {"type", "VEC3"}},
                             {{"componentType", kUnsignedByte}, {"count", kPoints}, {"type", "VEC4"}},
                             {{"componentType", kUnsignedShort}, {"count", 3 * kFaces}, {"type", "SCALAR"}},
                             {{"componentType", kFloat}, {"count", kPoints}, {"type", "VEC2"}}};
  model.root["accessors"][2]["normalized"] = true;
  model.primitive() = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}, {"TEXCOORD_0", 4}}},
                       {"indices", 3}};
  model.primitive()["extensions"][kName] = {
      {"bufferView", model.add_view(data)},
      {"attributes", {{"POSITION", kPositionId}, {"NORMAL", kNormalId}, {"COLOR_0", kColorId}, {"TEXCOORD_0", kUvId}}}};
  model.root["extensionsUsed"] = {kName};
  model.root["extensionsRequired"] = {kName};
  return model;
}

const std::string& sequential_data() {
  static const std::string data = encode(*bowl(), Method::sequential);
  return data;
}

constexpr const char* kAt = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
constexpr const char* kPrimitive = "/meshes/0/primitives/0";

void expect_the_bowl(const Primitive& primitive) {
  ASSERT_EQ(primitive.vertex_count(), kPoints);
  ASSERT_EQ(primitive.indices.size(), 3 * kFaces);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    EXPECT_EQ(primitive.vertices.positions[i], position_of(i)) << i;
    EXPECT_LT(glm::length(primitive.vertices.normals[i] - normal_of(i)), 1e-6f) << i;
    EXPECT_NEAR(primitive.colors[i].y * 255.0f, color_of(i)[1], 1e-3) << i;
    EXPECT_EQ(primitive.uv[0][i], uv_of(i)) << i;
  }
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    EXPECT_TRUE(std::ranges::equal(face_of(i), std::span(primitive.indices).subspan(3 * i, 3))) << i;
  }
}

// The points of `primitive` that lie at the points of the bowl, one each; position_of() is injective.
std::vector<std::uint32_t> match_points(const Primitive& primitive) {
  std::vector<std::uint32_t> matches;
  for (const glm::vec3& position : primitive.vertices.positions) {
    const auto x = static_cast<std::uint32_t>(std::lround(position.x * kSide));
    const auto z = static_cast<std::uint32_t>(std::lround(position.z * kSide));
    matches.push_back(z * (kSide + 1) + x);
  }
  return matches;
}

TEST(GltfDraco, SequentialDataIsReadAsItWas) {
  const Scene scene = read(compressed(sequential_data()));
  EXPECT_TRUE(scene.warnings.empty());
  expect_the_bowl(scene.primitives.at(0));
}

// The encoder orders points and faces anew; half a step of the quantisation is how far a value may move.
TEST(GltfDraco, EdgebreakerDataIsReadWithinItsQuantisation) {
  const Scene scene = read(compressed(encode(*bowl(), Method::edgebreaker)));
  const Primitive& primitive = scene.primitives.at(0);
  const std::vector<std::uint32_t> original = match_points(primitive);
  const float step = 1.0f / ((1 << kPositionBits) - 1);  // of the longest side, which is 1
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const glm::vec3 moved = glm::abs(primitive.vertices.positions[i] - position_of(original[i]));
    EXPECT_LT(std::max({moved.x, moved.y, moved.z}), 0.51f * step) << i;
    // An octahedron of 2^10 steps across a width of 2 is never finer than this on the sphere.
    EXPECT_LT(glm::length(primitive.vertices.normals[i] - normal_of(original[i])), 4.0f / (1 << kNormalBits)) << i;
    EXPECT_NEAR(primitive.colors[i].x * 255.0f, color_of(original[i])[0], 1e-3) << i;
    EXPECT_LT(glm::length(primitive.uv[0][i] - uv_of(original[i])), 0.75f * step) << i;
  }
  std::vector<std::array<std::uint32_t, 3>> expected, read_faces;
  const auto from_lowest = [](std::array<std::uint32_t, 3> face) {  // the same triangle of the same winding
    std::ranges::rotate(face, std::ranges::min_element(face));
    return face;
  };
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    const std::uint32_t* corner = primitive.indices.data() + 3 * i;
    expected.push_back(from_lowest(face_of(i)));
    read_faces.push_back(from_lowest({original[corner[0]], original[corner[1]], original[corner[2]]}));
  }
  std::ranges::sort(expected);
  std::ranges::sort(read_faces);
  EXPECT_EQ(expected, read_faces);
}

TEST(GltfDraco, AFallbackStaysWithPrimitivesThatAreNotCompressed) {
  Model model = compressed(sequential_data());
  const int flat = model.add_view(bytes_of(std::vector<float>(3 * kPoints)));
  const int none = model.add_view(bytes_of(std::vector<std::uint16_t>(3 * kFaces)));
  for (const int accessor : {0, 1}) model.root["accessors"][accessor]["bufferView"] = flat;
  model.root["accessors"][3]["bufferView"] = none;
  Json plain = model.primitive();
  plain.erase("extensions");
  plain["attributes"].erase("NORMAL");
  model.root["meshes"][0]["primitives"].push_back(plain);
  model.root.erase("extensionsRequired");
  const Scene scene = read(model);
  expect_the_bowl(scene.primitives.at(0));
  for (const glm::vec3& position : scene.primitives.at(1).vertices.positions) EXPECT_EQ(position, glm::vec3(0));
}

TEST(GltfDraco, OtherAttributesAreReadAsUsual) {
  Model model = compressed(sequential_data());
  const int uv = model.add<float>("VEC2", kFloat, kPoints, std::vector<float>(2 * kPoints, 0.25f));
  model.primitive()["attributes"]["TEXCOORD_1"] = uv;
  EXPECT_EQ(read(model).primitives.at(0).uv[1], std::vector<glm::vec2>(kPoints, glm::vec2(0.25f)));
}

// What the data calls metadata is no part of the mesh, however deep it is.
TEST(GltfDraco, MetadataIsSkipped) {
  const std::unique_ptr<draco::Mesh> mesh = bowl();
  auto metadata = std::make_unique<draco::GeometryMetadata>();
  metadata->AddEntryString("name", "bowl");
  auto inner = std::make_unique<draco::Metadata>();
  inner->AddEntryInt("depth", 1);
  inner->AddSubMetadata("inmost", std::make_unique<draco::Metadata>());
  metadata->AddSubMetadata("inner", std::move(inner));
  metadata->AddSubMetadata("other", std::make_unique<draco::Metadata>());
  mesh->AddMetadata(std::move(metadata));
  auto of_color = std::make_unique<draco::AttributeMetadata>();
  of_color->AddEntryDouble("gamma", 2.2);
  mesh->AddAttributeMetadata(2, std::move(of_color));
  const std::string data = encode(*mesh, Method::sequential);
  ASSERT_GT(data.size(), sequential_data().size() + 30);
  expect_the_bowl(read(compressed(data)).primitives.at(0));
}

// The extension lets a strip be compressed; what comes out are triangles.
TEST(GltfDraco, StripsBecomeTriangles) {
  Model model = compressed(sequential_data());
  model.primitive()["mode"] = 5;
  model.root["accessors"][3]["count"] = kFaces + 2;
  expect_the_bowl(read(model).primitives.at(0));
  model.root["accessors"][3]["count"] = kFaces + 1;
  expect_refused(model, std::string(kPrimitive) + "/indices: has 73 elements, but the compressed data has 72 tri");
}

TEST(GltfDraco, WhatIsNotListedAsUsedIsReadWithAWarning) {
  Model model = compressed(sequential_data());
  model.root.erase("extensionsRequired");
  model.root.erase("extensionsUsed");
  EXPECT_TRUE(has_warning(read(model), "is not listed in /extensionsUsed"));
}

TEST(GltfDraco, AccessorsMustMatchTheData) {
  const auto refused = [](const std::string& part, const std::function<void(Model&)>& change) {
    Model model = compressed(sequential_data());
    change(model);
    expect_refused(model, part);
  };
  const std::string at = kAt, primitive = kPrimitive;
  refused(primitive + "/mode: must be 4 or 5", [](Model& m) { m.primitive()["mode"] = 1; });
  refused(primitive + ": has no property 'indices'", [](Model& m) { m.primitive().erase("indices"); });
  refused(primitive + "/indices: has 213 elements, but the compressed data has 72 triangles",
          [](Model& m) { m.root["accessors"][3]["count"] = 3 * kFaces - 3; });
  refused(primitive + "/attributes/NORMAL: has 50 elements, but other attributes have 49",
          [](Model& m) { m.root["accessors"][1]["count"] = kPoints + 1; });
  for (const std::uint32_t count : {kPoints - 1, kPoints + 1}) {
    refused(at + ": the compressed data has 49 vertices, but its accessors have " + std::to_string(count),
            [=](Model& m) {
              for (const int accessor : {0, 1, 2, 4}) m.root["accessors"][accessor]["count"] = count;
            });
  }
  refused(at + "/attributes/POSITION: is 3, which no attribute",
          [](Model& m) { m.primitive()["extensions"][kName]["attributes"]["POSITION"] = 3; });
  refused(at + "/attributes/POSITION: its compressed data is of another type",
          [](Model& m) { m.primitive()["extensions"][kName]["attributes"]["POSITION"] = kColorId; });
  refused(at + "/attributes/TANGENT: is not among the primitive's own",
          [](Model& m) { m.primitive()["extensions"][kName]["attributes"]["TANGENT"] = kNormalId; });
  refused(at + "/attributes: is empty",
          [](Model& m) { m.primitive()["extensions"][kName]["attributes"] = Json::object(); });
  refused(at + "/bufferView: ", [](Model& m) { m.primitive()["extensions"][kName]["bufferView"] = 99; });
  refused("/accessors/0/sparse: stands in an accessor that compressed data fills", [](Model& m) {
    const int zeros = m.add_view(std::string(12, '\0'));
    m.root["accessors"][0]["sparse"] = {{"count", 1},
                                        {"indices", {{"bufferView", zeros}, {"componentType", kUnsignedByte}}},
                                        {"values", {{"bufferView", zeros}}}};
  });
}

// Bytes 5 and 6 are the version, 7 the kind, 8 the method, 11 and on the counts.
TEST(GltfDraco, OnlyMeshesOfVersion22AreRead) {
  const auto changed = [](std::size_t place, char value) {
    std::string data = sequential_data();
    data[place] = value;
    return compressed(data);
  };
  expect_error(ErrorCode::unsupported, "is of version 2.1 of Draco's bitstream",
               [&] { static_cast<void>(read(changed(6, 1))); });
  const std::string at = kAt;
  expect_refused(changed(0, 'd'), at + ": the compressed data does not begin with DRACO");
  expect_refused(changed(7, 0), at + ": the compressed data is a cloud of points");
  expect_refused(changed(8, 2), at + ": the compressed data is of unknown method 2");
  std::string data = encode(*bowl(), Method::edgebreaker);
  data[11] = 1;
  expect_refused(compressed(data), at + ": the compressed data is of unknown traversal 1");
  expect_refused(compressed(data.substr(0, 11)), at + ": the compressed data ends within its header");
}

// A header of some bytes that promises much is refused before there is memory for it.
TEST(GltfDraco, PromisesAreHeldAgainstTheLimits) {
  std::string data = encode(*bowl(), Method::edgebreaker);
  data.replace(13, 1, "\xff\xff\xff\x1f");  // 2^26 - 1 faces, after one byte of vertices
  Model model = compressed(data);
  expect_refused(model, std::string(kPrimitive) + "/indices: has 216 elements, but the compressed data has 67108863");
  model.root["accessors"][3]["count"] = 3 * ((1 << 26) - 1);
  GltfOptions options;
  options.limits.elements = 3 << 26;
  expect_refused(model, std::string(kAt) + ": to decode it takes ", options);
}

TEST(GltfDraco, DamagedDataIsReadOrRefused) {
  std::mt19937 random(5);
  for (const Method method : {Method::sequential, Method::edgebreaker}) {
    const std::string whole = encode(*bowl(), method);
    for (int round = 0; round < 300; ++round) {
      std::string data = whole;
      for (std::uint32_t i = random() % 4 + 1; i > 0; --i) {
        data[11 + random() % (data.size() - 11)] = static_cast<char>(random());
      }
      try {
        static_cast<void>(read(compressed(data)));
      } catch (const Error& error) { EXPECT_NE(error.code(), ErrorCode::internal) << error.what(); }
    }
  }
}

}  // namespace
}  // namespace velarium::scene::test
