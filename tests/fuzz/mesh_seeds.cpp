#include "seeds.hpp"

#include <draco/compression/encode.h>
#include <draco/core/encoder_buffer.h>
#include <fmt/core.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace velarium::fuzz {
namespace {

// Quads bent to a half pipe.
constexpr std::uint32_t kColumns = 5, kRows = 4, kPoints = (kColumns + 1) * (kRows + 1);

std::vector<unsigned> triangles() {
  std::vector<unsigned> indices;
  for (std::uint32_t y = 0; y < kRows; ++y) {
    for (std::uint32_t x = 0; x < kColumns; ++x) {
      const std::uint32_t a = y * (kColumns + 1) + x, b = a + kColumns + 1;
      for (const std::uint32_t corner : {a, b, a + 1, a + 1, b, b + 1}) indices.push_back(corner);
    }
  }
  return indices;
}

using Vertex = std::array<float, 3>;

std::vector<Vertex> positions() {
  std::vector<Vertex> out;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const float turn = 0.6f * static_cast<float>(i % (kColumns + 1));
    out.push_back({std::cos(turn), std::sin(turn), 0.5f * static_cast<float>(i / (kColumns + 1))});
  }
  return out;
}

std::vector<Vertex> normals() {
  std::vector<Vertex> out = positions();
  for (Vertex& normal : out) normal[2] = 0.0f;
  return out;
}

template <class Value>
void add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data,
                   const std::vector<Value>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(sizeof(Value) / draco::DataTypeLength(data)), data, false,
                 sizeof(Value), 0);
  const int id = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(values.size()));
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i]);
  }
}

void fill(draco::Mesh& mesh) {
  const std::vector<unsigned> indices = triangles();
  mesh.set_num_points(kPoints);
  for (std::uint32_t i = 0; i < indices.size() / 3; ++i) {
    const unsigned* corner = indices.data() + 3 * static_cast<std::size_t>(i);
    mesh.SetFace(draco::FaceIndex(i),
                 {draco::PointIndex(corner[0]), draco::PointIndex(corner[1]), draco::PointIndex(corner[2])});
  }
  std::vector<std::array<float, 2>> uv;
  std::vector<std::array<std::uint8_t, 4>> colors;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    uv.push_back({0.2f * static_cast<float>(i % (kColumns + 1)), 0.25f * static_cast<float>(i / (kColumns + 1))});
    colors.push_back({static_cast<std::uint8_t>(9 * i), 100, 200, 255});
  }
  using Attribute = draco::GeometryAttribute;
  add_attribute(mesh, Attribute::POSITION, draco::DT_FLOAT32, positions());
  add_attribute(mesh, Attribute::NORMAL, draco::DT_FLOAT32, normals());
  add_attribute(mesh, Attribute::TEX_COORD, draco::DT_FLOAT32, uv);
  add_attribute(mesh, Attribute::COLOR, draco::DT_UINT8, colors);
}

// The fields of Description in draco.cpp, then the data.
std::string described(const draco::Encoder& encoder, const draco::EncoderBuffer& buffer, int attributes) {
  const std::size_t faces = encoder.num_encoded_faces(), points = encoder.num_encoded_points();
  std::string input;
  for (const std::size_t count : {faces, points}) {
    input.push_back(static_cast<char>(count % 256));
    input.push_back(static_cast<char>(count / 256));
  }
  input.push_back(static_cast<char>(attributes));
  return input.append(buffer.data(), buffer.size());
}

void add_draco(const Seeds& seeds, int speed, bool quantized, draco::MeshEncoderMethod method) {
  draco::Mesh mesh;
  fill(mesh);
  draco::Encoder encoder;
  encoder.SetTrackEncodedProperties(true);
  encoder.SetEncodingMethod(method);
  encoder.SetSpeedOptions(speed, speed);
  using Attribute = draco::GeometryAttribute;
  if (quantized) {
    for (const auto type : {Attribute::POSITION, Attribute::NORMAL, Attribute::TEX_COORD}) {
      encoder.SetAttributeQuantization(type, 10);
    }
  }
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) return;
  constexpr int kAll = 7;
  seeds.add("draco", fmt::format("{}-{}-{}", static_cast<int>(method), quantized ? "quantized" : "exact", speed),
            described(encoder, buffer, kAll));
}

// The fields of Description in meshopt.cpp, then the data.
void add_meshopt(const Seeds& seeds, std::string_view name, const std::array<std::size_t, 4>& fields,
                 const std::vector<unsigned char>& data) {
  const auto [mode, filter, stride, count] = fields;
  std::string input;
  for (const std::size_t field : {mode, filter, stride, count % 256, count / 256}) {
    input.push_back(static_cast<char>(field));
  }
  seeds.add("meshopt", name, input.append(data.begin(), data.end()));
}

std::vector<unsigned char> packed(const void* elements, std::size_t count, std::size_t stride) {
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, stride));
  meshopt_encodeVertexVersion(0);  // what the extension holds
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), elements, count, stride));
  return out;
}

void add_attributes(const Seeds& seeds) {
  const std::vector<Vertex> vertices = positions();
  add_meshopt(seeds, "positions", {0, 0, 12, kPoints}, packed(vertices.data(), kPoints, 12));
  std::vector<float> four(4 * std::size_t{kPoints}, 0.0f);  // x, y, z and 0: directions, and turns by them
  for (std::size_t i = 0; i < kPoints; ++i) std::copy(vertices[i].begin(), vertices[i].end() - 1, four.begin() + 4 * i);
  std::vector<unsigned char> filtered(16 * std::size_t{kPoints});
  meshopt_encodeFilterOct(filtered.data(), kPoints, 4, 8, four.data());
  add_meshopt(seeds, "octahedral", {0, 1, 4, kPoints}, packed(filtered.data(), kPoints, 4));
  meshopt_encodeFilterOct(filtered.data(), kPoints, 8, 12, four.data());
  add_meshopt(seeds, "octahedral-16", {0, 1, 8, kPoints}, packed(filtered.data(), kPoints, 8));
  meshopt_encodeFilterQuat(filtered.data(), kPoints, 8, 12, four.data());
  add_meshopt(seeds, "quaternion", {0, 2, 8, kPoints}, packed(filtered.data(), kPoints, 8));
  meshopt_encodeFilterExp(filtered.data(), kPoints, 12, 15, vertices.front().data());
  add_meshopt(seeds, "exponential", {0, 3, 12, kPoints}, packed(filtered.data(), kPoints, 12));
}

void add_indices(const Seeds& seeds) {
  const std::vector<unsigned> indices = triangles();
  for (const int version : {0, 1}) {
    meshopt_encodeIndexVersion(version);
    std::vector<unsigned char> out(meshopt_encodeIndexBufferBound(indices.size(), kPoints));
    out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
    add_meshopt(seeds, fmt::format("triangles-{}", version), {1, 0, 2, indices.size()}, out);
    out.resize(meshopt_encodeIndexSequenceBound(indices.size(), kPoints));
    out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
    add_meshopt(seeds, fmt::format("sequence-{}", version), {2, 0, 4, indices.size()}, out);
  }
}

}  // namespace

void add_meshes(const Seeds& seeds) {
  for (const int speed : {0, 3, 5, 7, 10}) {  // each chooses other predictions
    for (const bool quantized : {false, true}) {
      add_draco(seeds, speed, quantized, draco::MESH_SEQUENTIAL_ENCODING);
      add_draco(seeds, speed, quantized, draco::MESH_EDGEBREAKER_ENCODING);
    }
  }
  add_attributes(seeds);
  add_indices(seeds);
}

}  // namespace velarium::fuzz
