#pragma once

// Scenes made in code, as glTF files that the library then reads.

#include "image/image.hpp"

#include <velarium/scene.hpp>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace velarium::test {

struct TestMaterial {
  glm::vec4 base_color{1.0f};
  float metallic = 0.0f, perceptual_roughness = 1.0f;
  float specular = 0.0f;  // KHR_materials_specular; 0: nothing but Lambert's diffuse light
  glm::vec3 emissive{0.0f};
  float emissive_strength = 1.0f;
  bool unlit = false, double_sided = false;
  std::string alpha_mode = "OPAQUE";
  int base_color_image = -1, normal_image = -1;  // as add_image() counts them; -1: none
};

// Triangles; what is empty is left out of the file, and `normals` and `uv` are otherwise as many as `positions`.
struct TestMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uv;
  std::vector<std::uint32_t> indices;
};

struct TestPlace {
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
};

struct TestLight {
  std::string type = "point";
  float intensity = 1.0f;  // lux or candela
  glm::vec3 color{1.0f};
  float range = 0.0f;  // metres; 0: none
  float inner_cone = 0.0f, outer_cone = 0.7853982f;
  glm::vec3 position{0.0f}, direction{0.0f, 0.0f, -1.0f};  // direction: need not be unit
  nlohmann::json extras = nullptr;                         // null: none
};

// Lists of primitives in world space; everything hangs below one node, so that the whole can be moved.
class GltfWriter {
 public:
  explicit GltfWriter(const glm::dvec3& origin = glm::dvec3(0.0));

  // Read with the default sampler.
  int add_image(image::ByteImage image);
  int add_material(const TestMaterial& material);
  void add_mesh(int material, const TestMesh& mesh, const TestPlace& place);
  // A rectangle of `size` metres, seen from where `normal` (need not be unit) points to.
  void add_quad(int material, const glm::vec3& center, const glm::vec3& normal, const glm::vec2& size);
  // Six of them around `center`.
  void add_box(int material, const glm::vec3& center, const glm::vec3& size);
  void add_light(const TestLight& light);
  // A box that lights may end at, by its name in their extras.
  void add_clip_box(const std::string& name, const glm::vec3& center, const glm::vec3& half_size);
  // A sphere in which environment light is multiplied by a colour.
  void add_ambient_light(const glm::vec3& center, const glm::vec3& color, float range);
  // Looks from `eye` to `target`; half of the height it sees, and the depths, in metres.
  void add_orthographic_camera(const glm::vec3& eye, const glm::vec3& target, float half_height, float far_depth);

  // Writes the file to a temporary folder, reads it, and removes it.
  [[nodiscard]] Scene load() const;

 private:
  int add_accessor(const std::vector<float>& values, int components, bool bounds);
  int add_indices(const std::vector<std::uint32_t>& indices);
  int add_view(const void* bytes, std::size_t size);
  int add_child(nlohmann::json node);

  nlohmann::json root_;
  std::string bytes_;
  std::vector<image::ByteImage> images_;
};

}  // namespace velarium::test
