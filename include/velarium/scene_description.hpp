#pragma once

// A scene that a program makes, without a file: plain values that Scene::make() turns into a Scene.
//
//   velarium::SceneDescription description{
//       .materials = {{.base_color = {0.8f, 0.2f, 0.1f, 1}}},
//       .meshes = {{.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}, .material = 0}},
//       .lights = {{.kind = velarium::LightKind::point, .position = {0, 1, 2}, .intensity = 10}}};
//   const velarium::Scene scene = velarium::Scene::make(description);
//
// Axes and units are those of glTF: metres, right-handed, +Y up, counter-clockwise front faces; angles are degrees, as
// wherever a person types them. Colours are linear, with BT.709 primaries, but for the pixels of images. Tables refer
// to each other by index, counted from 0. A member that is left out means what its default says. What moves within a
// scene (skins, morph targets, animations) and the volumes that lights may end at come from files alone.

#include <velarium/look_at.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace velarium {

// 8 bits a channel, rows from the top, alpha straight. sRGB-encoded where a material takes colours from it.
struct ImageDescription {
  std::string name;
  std::uint32_t width = 0, height = 0;  // from 1 to 16384
  std::vector<std::uint8_t> rgba;       // 4 * width * height values
};

enum class TextureWrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };
enum class TextureFilter : std::uint8_t { nearest, linear };

// How a material reads an image, at the texture coordinates of the mesh.
struct TextureDescription {
  std::optional<std::uint32_t> image;  // into SceneDescription::images; none: no texture
  TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::linear;  // of texels larger than a pixel; smaller ones are always averaged
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

// The metallic-roughness material of glTF 2.0. A texture multiplies the value beside it. Unlike in files, what says
// nothing is not metallic.
struct MaterialDescription {
  std::string name;
  std::array<float, 4> base_color{1, 1, 1, 1};    // 0 to 1; the last is opacity
  TextureDescription base_color_texture;          // sRGB, opacity in A
  float metallic = 0.0f;                          // 0 to 1
  float perceptual_roughness = 1.0f;              // 0 to 1
  TextureDescription metallic_roughness_texture;  // roughness in G, metallic in B
  TextureDescription normal_texture;              // tangent space, +Y up in the picture
  float normal_scale = 1.0f;
  TextureDescription occlusion_texture;          // in R
  float occlusion_strength = 1.0f;               // 0 to 1
  std::array<float, 3> emissive{0, 0, 0};        // nits, not negative
  TextureDescription emissive_texture;           // sRGB
  float ior = 1.5f;                              // index of refraction, at least 1; 0: all light is reflected
  float specular = 1.0f;                         // 0 to 1: strength of reflections that are not metallic
  std::array<float, 3> specular_color{1, 1, 1};  // of these, not negative
  TextureDescription specular_texture;           // in A
  TextureDescription specular_color_texture;     // sRGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;  // AlphaMode::mask: less opaque than this is not there; not negative
  bool double_sided = false;
  bool unlit = false;  // shows its base colour as it is
};

// Triangles of one material. What shows several is several meshes.
struct MeshDescription {
  std::string name;
  std::vector<std::array<float, 3>> positions;  // metres; at least three
  std::vector<std::array<float, 3>> normals;    // as many, of any length above 0; none: each triangle is flat
  std::vector<std::array<float, 2>> uv;         // as many, from the top left of images; none: no texture can be read
  std::vector<std::array<float, 4>> colors;     // as many, 0 to 1, times the base colour; none: white
  std::vector<std::uint32_t> indices;           // three a triangle; none: positions are taken as they follow
  std::optional<std::uint32_t> material;        // into SceneDescription::materials; none: a material of defaults
};

// A place in the scene, and the mesh that stands there. Either a matrix, or translation * rotation * scale.
struct NodeDescription {
  std::string name;
  std::optional<std::uint32_t> parent;          // an earlier node, in whose space this one stands; none: the world's
  std::optional<std::uint32_t> mesh;            // into SceneDescription::meshes; none: a place for others
  std::array<float, 3> translation{0, 0, 0};    // metres
  std::array<float, 4> rotation{0, 0, 0, 1};    // quaternion x, y, z, w of length 1
  std::array<float, 3> scale{1, 1, 1};          // negative values mirror
  std::optional<std::array<float, 16>> matrix;  // column after column, its last row 0 0 0 1; takes points to the parent
};

enum class LightKind : std::uint8_t { directional, point, spot };

// How a light's light falls off with distance.
enum class LightFalloff : std::uint8_t {
  inverse_square,  // intensity in candela
  bulb,            // intensity in lux at 1 m from the surface of a bulb, which needs a radius
};

// docs/lights.md says what each means for the picture.
struct LightDescription {
  std::string name;
  LightKind kind = LightKind::point;
  std::optional<std::uint32_t> parent;  // into SceneDescription::nodes: in whose space the light is; none: the world's
  std::array<float, 3> position{0, 0, 0};    // metres; of no meaning for directional lights
  std::array<float, 3> direction{0, -1, 0};  // that it shines to, of any length above 0; of no meaning for points
  std::array<float, 3> up{0, 1, 0};  // of a projected picture: its upper side, as far as at right angles to `direction`
  std::array<float, 3> color{1, 1, 1};  // not negative
  float intensity = 1.0f;               // not negative: lux (directional), else as `falloff` says
  LightFalloff falloff = LightFalloff::inverse_square;
  float range_m = 0.0f;             // where the light of a light ends; 0: nowhere
  float radius_m = 0.0f;            // of a light's bulb; 0: a point
  float angular_radius_deg = 0.0f;  // directional: of the disc that is seen, less than 90; 0: one direction
  float inner_cone_deg = 0.0f;      // spot: from the axis, less than the outer; as bright as on the axis
  float outer_cone_deg = 45.0f;     // spot: from the axis, at most 90; no light beyond
  bool casts_shadow = true;
  std::optional<std::uint32_t> projected_image;  // spot: into SceneDescription::images, thrown along the axis
  float projected_fov_deg = 0.0f;                // of its longer side, less than 180; 0: twice the outer cone
  float projected_soft_edge = 0.1f;              // 0 to 1: share of half of that over which it fades to its border
};

struct CameraDescription {
  std::string name;                     // that RenderRequest::camera can name
  std::optional<std::uint32_t> parent;  // into SceneDescription::nodes: in whose space `view` is; none: the world's
  LookAt view;                          // field of view: more than 0, less than 180 degrees
  float orthographic_height_m = 0.0f;   // that an orthographic camera sees; 0: perspective, by the field of view
  float aspect = 0.0f;  // width / height of what it frames; 0: the picture's, or 1 of an orthographic camera
  float near_m = 0.0f;  // nothing nearer is seen; 0: chosen (perspective), or 0
  float far_m = 0.0f;   // nothing farther is seen, more than near_m; 0: no end (perspective)
};

struct SceneDescription {
  std::string name;  // for SceneInfo::source
  std::vector<ImageDescription> images;
  std::vector<MaterialDescription> materials;
  std::vector<MeshDescription> meshes;
  std::vector<NodeDescription> nodes;  // none: each mesh stands in the world once, as it is
  std::vector<LightDescription> lights;
  std::vector<CameraDescription> cameras;
};

}  // namespace velarium
