#pragma once

// The scene as plain tables. Whatever the file was, this is all that the rest of the program sees of it:
// indices into vectors, kNone for "none", units and axes as in glTF (metres, +Y up, right-handed,
// counter-clockwise front faces, cameras look along -Z), colours linear.

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace velarium::scene {

inline constexpr std::int32_t kNone = -1;
inline constexpr std::size_t kMaxUvSets = 8;

// Box whose sides lie along the axes.
template <class Vector>
struct Box {
  using Number = typename Vector::value_type;
  Vector min{std::numeric_limits<Number>::infinity()};
  Vector max{-std::numeric_limits<Number>::infinity()};
  [[nodiscard]] bool empty() const { return min.x > max.x; }
  void add(const Vector& point);
  void add(const Box& box);
};
using Aabb = Box<glm::vec3>;
// The world is measured in doubles: a metre on a planet's surface is a float's last bit.
using WorldAabb = Box<glm::dvec3>;

// World space, of a box in an object's space.
[[nodiscard]] WorldAabb transformed(const Aabb& box, const glm::dmat4& world_from_object);

// --- textures ---------------------------------------------------------------------------------------------------

enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter : std::uint8_t { nearest, linear };

struct Sampler {
  Filter mag = Filter::linear, min = Filter::linear, mip = Filter::linear;
  bool mipmapped = true;  // false: only the full-size image is read
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  auto operator<=>(const Sampler&) const = default;
};

// 8-bit RGBA as stored in the file (no transfer function applied: use decides), rows from the top.
struct Image {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // 4 * width * height
};

struct Texture {
  std::int32_t image = kNone;
  Sampler sampler;
};

// A use of a texture by a material, with KHR_texture_transform: uv' = translate * rotate * scale * uv.
struct TextureRef {
  std::int32_t texture = kNone;
  std::uint32_t uv_set = 0;
  glm::vec2 offset{0.0f}, scale{1.0f};
  float rotation = 0.0f;  // radians, counter-clockwise in the sense of the extension's matrix
  [[nodiscard]] bool present() const { return texture != kNone; }
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};  // linear, times the texture (sRGB) and the vertex colour
  TextureRef base_color_texture;
  float metallic = 1.0f, perceptual_roughness = 1.0f;
  TextureRef metallic_roughness_texture;  // G roughness, B metallic
  float normal_scale = 1.0f;
  TextureRef normal_texture;
  float occlusion_strength = 1.0f;
  TextureRef occlusion_texture;  // R
  glm::vec3 emissive{0.0f};      // factor times KHR_materials_emissive_strength, nits
  TextureRef emissive_texture;   // sRGB
  float ior = 1.5f;              // KHR_materials_ior; 0 means F0 = 1
  float specular = 1.0f;         // KHR_materials_specular
  glm::vec3 specular_color{1.0f};
  TextureRef specular_texture;        // A
  TextureRef specular_color_texture;  // sRGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  // KHR_materials_unlit
};

// --- geometry ---------------------------------------------------------------------------------------------------

enum class Topology : std::uint8_t { points, lines, triangles };  // strips, fans and loops are lists after reading

// What deformation changes. Empty vectors where absent; otherwise one entry a vertex.
struct VertexFrames {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;  // w: sign of the bitangent
};

// Displacements; empty where the target does not move that attribute.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals, tangents;
};

struct Primitive {
  Topology topology = Topology::triangles;
  std::int32_t material = kNone;  // kNone: the default material
  VertexFrames vertices;          // triangles always have normals after reading; tangents where a normal map needs them
  std::array<std::vector<glm::vec2>, kMaxUvSets> uv;
  std::vector<glm::vec4> colors;       // linear
  std::vector<glm::u16vec4> joints;    // first index into Skin::joints; 4 a vertex and set, set after set
  std::vector<glm::vec4> weights;      // parallel to `joints`; sum to 1
  std::uint32_t skin_sets = 0;         // joints.size() == skin_sets * vertex count
  std::vector<std::uint32_t> indices;  // never empty after reading
  std::vector<MorphTarget> morph_targets;
  Aabb bounds;  // of `vertices.positions`, object space, undeformed
  [[nodiscard]] std::size_t vertex_count() const { return vertices.positions.size(); }
};

struct Mesh {
  std::string name;
  std::vector<std::uint32_t> primitives;
  std::vector<float> weights;  // default morph weights
};

// --- the node tree ----------------------------------------------------------------------------------------------

// EXT_mesh_gpu_instancing: where a copy of a node's mesh stands in the space of the node.
struct Placement {
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
};

struct Node {
  std::string name;
  std::int32_t parent = kNone;
  std::vector<std::uint32_t> children;
  glm::dvec3 translation{0.0};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
  std::optional<glm::dmat4> matrix;  // instead of the three above; such a node is never animated
  std::int32_t mesh = kNone, skin = kNone, camera = kNone, light = kNone;
  std::vector<float> weights;        // morph weights; empty: the mesh's
  std::vector<Placement> instances;  // of the mesh; empty: one, at the node itself
};

struct Skin {
  std::string name;
  std::vector<std::uint32_t> joints;         // nodes
  std::vector<glm::mat4> joint_from_object;  // inverse bind matrices, one a joint
};

struct Camera {
  std::string name;
  enum class Kind : std::uint8_t { perspective, orthographic } kind = Kind::perspective;
  float vertical_fov = 0.7853982f;  // radians
  std::optional<float> aspect;      // width / height; absent: the picture's
  glm::vec2 half_size{1.0f};        // orthographic: xmag, ymag in metres
  float z_near = 0.1f;
  float z_far = std::numeric_limits<float>::infinity();
};

enum class LightKind : std::uint8_t { directional, point, spot };

// How a light's light falls off with distance. Both are the irradiance of a sphere exactly; they differ in their unit.
enum class Falloff : std::uint8_t {
  inverse_square,  // intensity in candela; KHR_lights_punctual's window at `range`
  bulb,            // intensity in lux at 1 m from the bulb's surface; fades over the last fifth of `range`
};

// A picture that a spot light throws along its axis.
struct Projector {
  std::int32_t image = kNone;  // into Scene::images
  float field_of_view = 0.0f;  // radians, of the picture's longer side
  float soft_edge = 0.1f;      // share of half the field of view over which the picture fades to its border
  [[nodiscard]] bool present() const { return image != kNone; }
};

// KHR_lights_punctual: shines along -Z of its node. What else there is comes from extras: docs/lights.md
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;  // lux (directional), else as `falloff` says
  Falloff falloff = Falloff::inverse_square;
  float range = 0.0f;  // metres; 0: infinite
  bool casts_shadow = true;
  float radius = 0.0f;                               // of a bulb whose light this is, metres; 0: a point
  float angular_radius = 0.0f;                       // directional: of the disc that is seen, radians; 0: one direction
  float inner_cone = 0.0f, outer_cone = 0.7853982f;  // radians from the axis
  std::int32_t clip_volume = kNone;                  // that it ends at. From extras.clip_volume
  Projector projector;                               // spot
};

// A convex volume that lights may end at: extras.clip_volume of a node. Never drawn.
struct ClipVolume {
  std::string name;  // no two have the same
  std::uint32_t node = 0;
  // In the space of the node. xyz: unit, inward; the inside is where dot(xyz, p) + w >= 0 for all.
  std::vector<glm::vec4> planes;
  Aabb bounds;
};

// A volume in which environment light is multiplied: extras.ambient_light of a node. The sphere of `range` about the
// node's origin, in the space of the node, whose scale makes it an ellipsoid.
struct AmbientLight {
  std::uint32_t node = 0;
  glm::vec3 color{1.0f};  // linear, at the centre; above 1 brightens
  float range = 1.0f;     // metres
};

// --- animation --------------------------------------------------------------------------------------------------

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };
enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };

struct AnimationSampler {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;      // seconds, strictly increasing, not empty
  std::vector<float> values;     // components after components; cubic: in-tangent, value, out-tangent each
  std::uint32_t components = 0;  // floats a value: 3, 4, or the number of morph targets
};

struct AnimationChannel {
  std::uint32_t sampler = 0, node = 0;
  AnimatedPath path = AnimatedPath::translation;
};

struct Animation {
  std::string name;
  std::vector<AnimationSampler> samplers;
  std::vector<AnimationChannel> channels;
  float duration = 0.0f;  // seconds: the largest time of its samplers
};

struct Scene {
  std::string source;  // file or "builtin:NAME"
  std::string generator;
  std::string environment;  // that the scene is made for ("white", "none"); empty: none is named
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Primitive> primitives;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<std::uint32_t> roots;  // of the scene that is shown
  std::vector<Skin> skins;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<ClipVolume> clip_volumes;
  std::vector<AmbientLight> ambient_lights;
  std::vector<Animation> animations;
  std::vector<std::string> variants;  // KHR_materials_variants; primitives have the materials of the one asked for
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<std::string> warnings;
};

}  // namespace velarium::scene
