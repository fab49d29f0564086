#pragma once

// All light of a scene, as sources to aim at: the scene's lights, its glowing triangles, and the environment.

#include "reference/emitters.hpp"
#include "reference/environment_light.hpp"
#include "reference/textures.hpp"

#include "shading/host.hpp"

#include <optional>
#include <span>
#include <vector>

namespace velarium::reference {

// Where light is to be found.
struct Receiver {
  glm::vec3 position_ws{0.0f};
  glm::vec3 normal_ws{0.0f};  // the shading normal: what lies behind it lights nothing
};

// With which chance each kind of light is aimed at from a receiver; they sum to 1, or are 0 where there is no light.
struct LightChances {
  float environment = 0.0f, emitters = 0.0f, punctual = 0.0f;
  float punctual_total = 0.0f;  // the sum of the weights of all lights
};

struct LightSample {
  glm::vec3 wi{0.0f};     // unit, towards the light
  glm::vec3 light{0.0f};  // irradiance on a plane that faces it (points), or radiance / pdf_sr (all others)
  float distance = 0.0f;  // metres to it: nothing nearer may stand between; infinite for the environment and the sun
  float pdf_sr = 0.0f;    // of wi with all choices counted; 0: light from one direction alone, found no other way
  bool emitter = false;   // a triangle's
  bool shadowed = true;   // something may stand between; false: nothing counts
};

// Which kinds of light a path may find at its end.
struct LightKinds {
  bool environment = true, emitters = true;
};

class Lights {
 public:
  // lights: relative to the eye. projectors: square sRGB pictures, which GpuLight::projector_layer counts from 1.
  // clip_records: of the volumes that they end at, as shading/clip_volume.glsl reads them.
  // environment: null where there is none. All but the lights must outlive this.
  Lights(std::vector<shading::GpuLight> lights, std::span<const scene::Image> projectors,
         std::span<const glm::vec4> clip_records, const image::FloatImage* environment, float rotation_deg,
         float intensity, const std::vector<Object>& objects, const Materials& materials);

  [[nodiscard]] bool has_environment() const { return environment_ && !environment_->dark(); }
  [[nodiscard]] bool has_emitters() const { return !emitters_.empty(); }
  [[nodiscard]] bool has_spheres() const { return !spheres_.empty(); }
  // What is seen of the environment in a direction; black where there is none.
  [[nodiscard]] glm::vec3 environment(const glm::vec3& direction) const;

  [[nodiscard]] LightChances chances(const Receiver& receiver, LightKinds kinds) const;

  // One light, by its chance. Nothing where the chosen one does not reach the receiver. u: in [0, 1).
  [[nodiscard]] std::optional<LightSample> sample(const Receiver& receiver, const LightChances& chances, float u_light,
                                                  const glm::vec2& u) const;

  // With which density sample() returns these directions, per steradian, for the balance with reflected rays.
  [[nodiscard]] float pdf_sr_environment(const LightChances& chances, const glm::vec3& wi) const;
  [[nodiscard]] float pdf_sr_emitter(const LightChances& chances, const Hit& hit, const SurfacePoint& p,
                                     const glm::vec3& wi) const;

  // Spherical lights and discs that a ray from the receiver meets before `distance`, and those that nothing hides,
  // however near that is. They hide nothing and are not seen themselves: they are lights only.
  struct SphereHit {
    glm::vec3 radiance;
    float pdf_sr;
    float distance;  // to its near side, metres; 0 where nothing that stands between counts
  };
  template <class Function>
  void for_each_sphere(const Receiver& receiver, const LightChances& chances, const glm::vec3& wi, float distance,
                       Function function) const {
    for (const std::size_t light : spheres_)
      if (const auto hit = meet_sphere(punctual_[light], receiver, chances, wi, distance)) function(*hit);
  }

 private:
  // Is the receiver in the volume that the light ends at?
  [[nodiscard]] bool reaches(const shading::GpuLight& light, const Receiver& receiver) const;
  // What the light sends to a position, its picture included, shadows aside.
  [[nodiscard]] shading::LightSample arriving(const shading::GpuLight& light, const glm::vec3& position) const;
  // How much of the light's light the receiver can use at most. 0 where it can use none.
  [[nodiscard]] float weight_of(const shading::GpuLight& light, const Receiver& receiver) const;
  [[nodiscard]] std::optional<LightSample> sample_punctual(const Receiver& receiver, const LightChances& chances,
                                                           float u, const glm::vec2& place) const;
  [[nodiscard]] std::optional<LightSample> sample_emitter(const Receiver& receiver, const LightChances& chances,
                                                          float u_light, const glm::vec2& u) const;
  [[nodiscard]] std::optional<SphereHit> meet_sphere(const shading::GpuLight& light, const Receiver& receiver,
                                                     const LightChances& chances, const glm::vec3& wi,
                                                     float distance) const;

  std::vector<shading::GpuLight> punctual_;
  std::vector<MipChain> projectors_;
  std::span<const glm::vec4> clip_records_;
  std::vector<std::size_t> spheres_;  // area lights
  std::optional<EnvironmentLight> environment_;
  float environment_irradiance_ = 0.0f;  // its mean over all directions
  Emitters emitters_;
};

}  // namespace velarium::reference
