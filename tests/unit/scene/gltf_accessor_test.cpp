#include "gltf_model.hpp"

#include <cmath>
#include <limits>

namespace velarium::scene::test {
namespace {

std::vector<glm::vec2> uv_of(const Model& model) {
  return read(model).primitives.at(0).uv[0];
}

Model with_uv(int accessor_of(Model&)) {
  Model model = triangle();
  model.primitive()["attributes"]["TEXCOORD_0"] = accessor_of(model);
  return model;
}

Model quantized(Model model) {
  model.root["extensionsUsed"] = {"KHR_mesh_quantization"};
  model.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  return model;
}

TEST(GltfAccessor, UnsignedNormalisedIntegersAreFractions) {
  EXPECT_EQ(uv_of(with_uv([](Model& m) {
              return m.add<std::uint8_t>("VEC2", kUnsignedByte, 3, {0, 255, 51, 0, 0, 0}, true);
            })),
            (std::vector<glm::vec2>{{0, 1}, {0.2f, 0}, {0, 0}}));
  EXPECT_EQ(uv_of(with_uv([](Model& m) {
              return m.add<std::uint16_t>("VEC2", kUnsignedShort, 3, {0, 65535, 13107, 0, 0, 0}, true);
            })),
            (std::vector<glm::vec2>{{0, 1}, {0.2f, 0}, {0, 0}}));
}

TEST(GltfAccessor, QuantisedFormatsOfTheExtension) {
  // KHR_mesh_quantization: signed normalised integers are max(c / (2^(bits-1) - 1), -1).
  EXPECT_EQ(uv_of(quantized(with_uv([](Model& m) {
              return m.add<std::int8_t>("VEC2", kByte, 3, {127, -127, -128, 0, 0, 0}, true);
            }))),
            (std::vector<glm::vec2>{{1, -1}, {-1, 0}, {0, 0}}));
  EXPECT_EQ(uv_of(quantized(with_uv([](Model& m) {
              return m.add<std::int16_t>("VEC2", kShort, 3, {-300, 7, 0, 0, 0, 0});
            }))),
            (std::vector<glm::vec2>{{-300, 7}, {0, 0}, {0, 0}}));
  EXPECT_EQ(uv_of(quantized(with_uv([](Model& m) {
              return m.add<std::uint8_t>("VEC2", kUnsignedByte, 3, {200, 7, 0, 0, 0, 0});
            }))),
            (std::vector<glm::vec2>{{200, 7}, {0, 0}, {0, 0}}));
  Model model = triangle();
  model.primitive()["attributes"]["POSITION"] =
      model.add<std::int16_t>("VEC3", kShort, 3, {0, 0, 0, 1000, 0, -5, 0, 7, 0});
  EXPECT_EQ(read(quantized(model)).primitives.at(0).vertices.positions.at(1), glm::vec3(1000, 0, -5));
  expect_refused(
      model, "/meshes/0/primitives/0/attributes/POSITION: is an accessor of VEC3 SHORT, must be one of: VEC3 FLOAT");
}

TEST(GltfAccessor, InterleavedDataIsGathered) {
  Model model = triangle();
  const int view = model.add_view(bytes_of<float>({0, 0, 0, 9, 2, 0, 0, 9, 0, 2, 0, 9}), 16);
  model.root["accessors"][0]["bufferView"] = view;
  EXPECT_EQ(read(model).primitives.at(0).vertices.positions, (std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
  model.root["accessors"][0]["byteOffset"] = 4;  // the last element ends with the view
  EXPECT_EQ(read(model).primitives.at(0).vertices.positions.at(0), glm::vec3(0, 0, 9));
  model.root["accessors"][0]["byteOffset"] = 8;
  expect_refused(model, "/accessors/0: 44 bytes from 8 on do not fit its view of 48 bytes");
}

TEST(GltfAccessor, WithoutAViewItIsZero) {
  Model model = triangle();
  model.root["accessors"][0].erase("bufferView");
  EXPECT_EQ(read(model).primitives.at(0).vertices.positions, (std::vector<glm::vec3>(3, glm::vec3(0.0f))));
}

template <class Index>
void expect_sparse(int component) {
  Model model = triangle();
  const int indices = model.add_view(bytes_of<Index>({0, 2}));
  const int values = model.add_view(bytes_of<float>({5, 5, 5, 6, 6, 6}));
  Json& accessor = model.root["accessors"][0];
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", indices}, {"componentType", component}}},
                        {"values", {{"bufferView", values}}}};
  EXPECT_EQ(read(model).primitives.at(0).vertices.positions, (std::vector<glm::vec3>{{5, 5, 5}, {1, 0, 0}, {6, 6, 6}}));
  accessor.erase("bufferView");
  EXPECT_EQ(read(model).primitives.at(0).vertices.positions, (std::vector<glm::vec3>{{5, 5, 5}, {0, 0, 0}, {6, 6, 6}}));
}

TEST(GltfAccessor, SparseElementsReplaceOthers) {
  expect_sparse<std::uint8_t>(kUnsignedByte);
  expect_sparse<std::uint16_t>(kUnsignedShort);
  expect_sparse<std::uint32_t>(kUnsignedInt);
}

Model sparse(const std::vector<std::uint16_t>& indices) {
  Model model = triangle();
  const int index_view = model.add_view(bytes_of(indices));
  const int values = model.add_view(bytes_of<float>({5, 5, 5, 6, 6, 6}));
  model.root["accessors"][0]["sparse"] = {{"count", 2},
                                          {"indices", {{"bufferView", index_view}, {"componentType", kUnsignedShort}}},
                                          {"values", {{"bufferView", values}}}};
  return model;
}

TEST(GltfAccessor, SparseIndicesAreChecked) {
  expect_refused(sparse({0, 3}), "/accessors/0/sparse/indices: number 1 is 3, but the accessor has 3 elements");
  expect_refused(sparse({1, 1}), "/accessors/0/sparse/indices: number 1 is 1, not more than the one before");
  expect_refused(sparse({2, 0}), "/accessors/0/sparse/indices: number 1 is 0");
  Model model = sparse({0, 1});
  Json& part = model.root["accessors"][0]["sparse"];
  part["count"] = 4;
  expect_refused(model, "/accessors/0/sparse/count: is 4, must be a whole number from 1 to 3");
  part["count"] = 3;
  expect_refused(model, "/accessors/0/sparse/indices: 6 bytes from 0 on do not fit its view of 4 bytes");
  part["count"] = 2;
  part["indices"]["componentType"] = kFloat;
  expect_refused(model, "/accessors/0/sparse/indices/componentType: ");
  part["indices"]["componentType"] = kUnsignedShort;
  part["values"]["bufferView"] = model.add_view(bytes_of<float>({5, 5, 5, 6, 6, 6}), 12);
  expect_refused(model, "/accessors/0/sparse/values/bufferView: ");
}

TEST(GltfAccessor, MinAndMaxAreNotTrusted) {
  Model model = triangle();
  model.root["accessors"][0]["min"] = {10, 10, 10};
  model.root["accessors"][0]["max"] = {11, 11, 11};
  const Aabb bounds = read(model).primitives.at(0).bounds;
  EXPECT_EQ(bounds.min, glm::vec3(0, 0, 0));
  EXPECT_EQ(bounds.max, glm::vec3(1, 1, 0));
}

TEST(GltfAccessor, PropertiesAreChecked) {
  const auto refuse = [](const char* key, const Json& value, const std::string& part) {
    Model model = triangle();
    model.root["accessors"][0][key] = value;
    expect_refused(model, "/accessors/0" + part);
  };
  refuse("count", 0, "/count: is 0");
  refuse("count", -3, "/count: is -3");
  refuse("count", 3.5, "/count: is 3.5");
  refuse("count", "3", "/count: is \"3\"");
  refuse("count", 4, ": 48 bytes from 0 on do not fit");
  refuse("count", 4294967295u, "/count: is 4294967295 elements, more than load.elements=");
  refuse("count", 200'000'000, ": 2400000000 bytes from 0 on do not fit");
  refuse("componentType", 5124, "/componentType: is 5124");
  refuse("type", "VEC5", "/type: is 'VEC5'");
  refuse("byteOffset", 2, "/byteOffset: is 2, must be a multiple of 4");
  refuse("byteOffset", 9223372036854775804ull, ": ");
  refuse("byteOffset", 18446744073709551615ull, "/byteOffset: ");
  refuse("bufferView", 7, "/bufferView: is 7, but there are 2 bufferViews");
  refuse("normalized", true, "/normalized: FLOAT cannot be normalized");
}

TEST(GltfAccessor, ColumnsOfMatricesArePaddedButTheLast) {  // glTF 2.0, 3.6.2.4
  Model model = triangle();
  const int view = model.add_view(std::string(14, '\0'));  // two times two columns of two bytes, at multiples of 4
  model.root["accessors"].push_back(
      {{"bufferView", view}, {"componentType", kUnsignedByte}, {"type", "MAT2"}, {"count", 2}});
  EXPECT_NO_THROW(static_cast<void>(read(model)));
  model.root["bufferViews"][static_cast<std::size_t>(view)]["byteLength"] = 13;
  expect_refused(model, "/accessors/2: 14 bytes from 0 on do not fit its view of 13 bytes");
}

TEST(GltfAccessor, ViewsAreChecked) {
  const auto refuse = [](const char* key, const Json& value, const std::string& part) {
    Model model = triangle();
    model.root["bufferViews"][0][key] = value;
    expect_refused(model, part);
  };
  refuse("buffer", 1, "/bufferViews/0/buffer: is 1, but there are 1 buffers");
  refuse("byteLength", 1000, "/bufferViews/0/byteLength: ");
  refuse("byteLength", 0, "/bufferViews/0/byteLength: is 0");
  refuse("byteOffset", 72, "/bufferViews/0/byteOffset: is 72, beyond");
  refuse("byteOffset", 9223372036854775807ull, "/bufferViews/0/byteOffset: ");
  refuse("byteOffset", 2, "/accessors/0: starts at byte 2 of its buffer");
  refuse("byteStride", 6, "/accessors/0: its view's byteStride, 6, is less than an element's 12 bytes");
  refuse("byteStride", 256, "/accessors/0: 524 bytes from 0 on do not fit");
  refuse("byteStride", 8, "/accessors/0: its view's byteStride, 8, is less than an element's 12 bytes");
}

TEST(GltfAccessor, StridesOutOfTheRulesAreRead) {
  const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Model packed = triangle();
  packed.root["bufferViews"][0]["byteStride"] = 0;
  EXPECT_EQ(expect_repaired(packed, "/bufferViews/0/byteStride: is 0").primitives.at(0).vertices.positions, corners);
  for (const std::size_t stride : {14, 256}) {
    Model wide = triangle();
    std::vector<std::uint8_t> bytes(2 * stride + sizeof(glm::vec3));
    for (std::size_t i = 0; i < 3; ++i) std::memcpy(bytes.data() + i * stride, &corners[i], sizeof(glm::vec3));
    const int view = wide.root["accessors"][wide.add<std::uint8_t>(
        "SCALAR", kUnsignedByte, static_cast<int>(bytes.size()), bytes)]["bufferView"];
    wide.root["bufferViews"][view]["byteStride"] = stride;
    wide.root["accessors"][0]["bufferView"] = view;
    wide.root["accessors"].erase(2);
    const Scene scene = expect_repaired(wide, "/byteStride: is " + std::to_string(stride) + ", not a multiple of 4");
    EXPECT_EQ(scene.primitives.at(0).vertices.positions, corners);
  }
}

TEST(GltfAccessor, NotANumberIsRefused) {
  for (const float wrong :
       {std::nanf(""), std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    Model model = triangle();
    model.primitive()["attributes"]["POSITION"] = model.add<float>("VEC3", kFloat, 3, {0, 0, 0, 1, wrong, 0, 0, 1, 0});
    expect_refused(model, "/accessors/2: element 1 holds ");
  }
}

TEST(GltfAccessor, GiganticCountsAreRefusedBeforeMemoryIsTaken) {
  Model model = triangle();
  model.root["accessors"][0].erase("bufferView");
  model.root["accessors"][0]["count"] = 4'000'000'000u;
  expect_refused(model, "/accessors/0/count: ");
  GltfOptions options;
  options.limits.elements = 2;
  expect_refused(triangle(), "/accessors/0/count: is 3 elements, more than load.elements=2 allows", options);
  options.limits.elements = 5;  // three positions, then three normals
  expect_refused(triangle(),
                 "/accessors/1: with it, the scene has 6 elements, more than load.elements=5 allows; "
                 "-D load.elements=6 allows it",
                 options);
  options.limits.elements = 9;  // and three indices, which are made
  EXPECT_NO_THROW(static_cast<void>(read(triangle(), options)));
}

}  // namespace
}  // namespace velarium::scene::test
