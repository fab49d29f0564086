#pragma once

// Materials as rays meet them: the CPU's reading of src/upload/material.glsl.

#include "reference/objects.hpp"
#include "reference/textures.hpp"
#include "scene/scene.hpp"

#include "shading/host.hpp"

#include <vector>

namespace velarium::reference {

// What a ray brings to a surface, for the choice of mips.
struct Footprint {
  float width_m = 0.0f;  // of the cone of the pixel, across the ray
  float choice = 0.0f;   // as BoundTexture::sample
};

// How much light passes a surface.
struct Transparency {
  float opacity = 1.0f;  // the share of rays that it stops: 0 or 1 for MASK, any for BLEND
  glm::vec3 tint{1.0f};  // what multiplies those that pass
};

// A surface point, ready to be lit.
struct Look {
  shading::Surface surface;
  glm::vec3 emission{0.0f};  // towards the side that was hit, nits
  bool unlit = false;        // emission is its colour; it reflects nothing
};

// Refers to the scene, which must outlive it.
class Materials {
 public:
  explicit Materials(const scene::Scene& scene);

  // Whether some of the surface may let rays through.
  [[nodiscard]] bool may_be_transparent(std::uint32_t material) const;
  [[nodiscard]] bool double_sided(std::uint32_t material) const { return table_[material].source->double_sided; }
  // Whether triangles of this material may give light of their own.
  [[nodiscard]] bool may_emit(std::uint32_t material) const;

  [[nodiscard]] Transparency transparency(const SurfacePoint& p, const Footprint& footprint) const;
  // The light that the surface gives towards its front, and the back where it is double-sided; opacity left out.
  [[nodiscard]] glm::vec3 emission(const SurfacePoint& p, const Footprint& footprint) const;
  // front: which side was hit. A surface that is not double-sided is lit from behind as if it were, but emits nothing.
  [[nodiscard]] Look look(const SurfacePoint& p, bool front, const Footprint& footprint) const;

 private:
  class Reader;
  // A texture, with what of its mip does not depend on the point.
  struct Slot {
    BoundTexture texture;
    float log2_texels = 0.0f;
  };
  struct Material {
    const scene::Material* source;
    Slot base_color, metallic_roughness, normal, emissive, specular, specular_color;
  };
  [[nodiscard]] static Material bound(const scene::Material& source, const Textures& textures);
  [[nodiscard]] static glm::vec4 base_color(const Material& m, Reader& reader);
  [[nodiscard]] static glm::vec3 emission(const Material& m, Reader& reader);
  [[nodiscard]] static glm::vec3 shading_normal(const Material& m, bool front, Reader& reader);
  [[nodiscard]] const Material& of(const SurfacePoint& p) const { return table_[p.object->material]; }

  Textures textures_;
  scene::Material default_;
  std::vector<Material> table_;  // the last is the default material
};

}  // namespace velarium::reference
