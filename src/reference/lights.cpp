#include "reference/lights.hpp"

#include "shading/host.hpp"

#include <algorithm>
#include <cmath>

namespace velarium::reference {
namespace {

using shading::GpuLight, shading::kPi, shading::vec3;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// How far before a glowing triangle its shadow rays end, in units of what rounding may have moved it.
constexpr float kEmitterClearance = 4.0f;

constexpr scene::Sampler kProjectorSampler{.wrap_u = scene::Wrap::clamp_to_edge, .wrap_v = scene::Wrap::clamp_to_edge};

// Each kind of light that there is gets at least this chance: the estimates behind the rest may be far off.
constexpr float kLeastChance = 0.1f;

bool casts_shadow(const GpuLight& light) {
  return (light.flags & shading::kLightCastsShadow) != 0;
}

// How far a ray along wi goes before it enters an area light, or the sun's disc, which is infinitely far.
// Nothing where it misses.
std::optional<float> entry_distance(const GpuLight& light, const vec3& position, const vec3& wi) {
  if (shading::is_directional(light)) {
    const vec3 axis(light.direction), off = glm::cross(axis, wi);
    const bool meets = glm::dot(axis, wi) < 0.0f && glm::dot(off, off) < light.color.w * light.color.w;
    return meets ? std::optional(kInfinity) : std::nullopt;
  }
  const vec3 to_center = vec3(light.position_range) - position;
  const float along = glm::dot(to_center, wi);
  const vec3 off = to_center - along * wi;
  const float gap = light.color.w * light.color.w - glm::dot(off, off);
  if (along <= 0.0f || gap <= 0.0f) return std::nullopt;
  return along - std::sqrt(gap);
}

float sphere_pdf_sr(float sine) {
  return shading::pdf_sr_cone(shading::cone_height(sine * sine));
}

// A sphere of even radiance lights a plane that faces it as a point of the same intensity does: E = pi L sin^2.
vec3 sphere_radiance(const vec3& irradiance, float sine) {
  return irradiance / (kPi * sine * sine);
}

float mean_luminance(const image::FloatImage& image) {
  double sum = 0.0, weights = 0.0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const double weight = std::sin((y + 0.5) * static_cast<double>(kPi) / image.height);
    const float* row = &image.rgba[4 * std::size_t{y} * image.width];
    for (std::uint32_t x = 0; x < image.width; ++x, row += 4)
      sum += weight * static_cast<double>(shading::luminance({row[0], row[1], row[2]}));
    weights += weight * image.width;
  }
  return weights > 0.0 ? static_cast<float>(sum / weights) : 0.0f;
}

}  // namespace

Lights::Lights(std::vector<GpuLight> lights, std::span<const scene::Image> projectors,
               std::span<const glm::vec4> clip_records, const image::FloatImage* environment, float rotation_deg,
               float intensity, const std::vector<Object>& objects, const Materials& materials)
    : punctual_(std::move(lights)), clip_records_(clip_records), emitters_(objects, materials) {
  for (const scene::Image& picture : projectors) projectors_.emplace_back(picture, true);
  for (std::size_t i = 0; i < punctual_.size(); ++i)
    if (punctual_[i].color.w > 0.0f) spheres_.push_back(i);
  if (environment == nullptr) return;
  environment_.emplace(*environment, rotation_deg, intensity);
  environment_irradiance_ = kPi * intensity * mean_luminance(*environment);
}

vec3 Lights::environment(const vec3& direction) const {
  return environment_ ? environment_->radiance(direction) : vec3(0.0f);
}

bool Lights::reaches(const GpuLight& light, const Receiver& receiver) const {
  if (light.clip_volume == 0) return true;
  const auto planes = shading::clip_planes(clip_records_[light.clip_volume - 1]);
  const vec3 point = shading::clip_point(receiver.position_ws, receiver.normal_ws);
  return std::ranges::all_of(clip_records_.subspan(planes.first, planes.count),
                             [&](const glm::vec4& plane) { return shading::before_clip_plane(plane, point); });
}

shading::LightSample Lights::arriving(const GpuLight& light, const vec3& position) const {
  shading::LightSample at = shading::sample_light(light, position);
  if (light.projector_layer == 0) return at;
  const glm::vec2 uv = shading::projector_uv(light, at.wi);
  const BoundTexture picture{&projectors_[light.projector_layer - 1], kProjectorSampler};
  at.irradiance *= shading::in_projector(uv) ? vec3(picture.sample(uv, 0.0f, 0.0f)) : vec3(0.0f);
  return at;
}

float Lights::weight_of(const GpuLight& light, const Receiver& receiver) const {
  if (!reaches(light, receiver)) return 0.0f;
  const shading::LightSample at = arriving(light, receiver.position_ws);
  const float cosine = std::min(glm::dot(receiver.normal_ws, at.wi) + at.sine, 1.0f);
  return cosine > 0.0f ? shading::luminance(at.irradiance) * cosine : 0.0f;
}

LightChances Lights::chances(const Receiver& receiver, LightKinds kinds) const {
  LightChances c;
  for (const GpuLight& light : punctual_) c.punctual_total += weight_of(light, receiver);
  c.punctual = c.punctual_total;
  if (kinds.environment && has_environment()) c.environment = environment_irradiance_;
  if (kinds.emitters && has_emitters()) c.emitters = emitters_.irradiance_at(receiver.position_ws);
  const float total = c.punctual + c.environment + c.emitters;
  if (!(total > 0.0f)) return {};
  float floored = 0.0f;
  for (float* chance : {&c.punctual, &c.environment, &c.emitters})
    if (*chance > 0.0f) floored += * chance = std::max(*chance / total, kLeastChance);
  for (float* chance : {&c.punctual, &c.environment, &c.emitters}) *chance /= floored;
  return c;
}

std::optional<LightSample> Lights::sample(const Receiver& receiver, const LightChances& chances, float u_light,
                                          const glm::vec2& u) const {
  if (u_light < chances.punctual) return sample_punctual(receiver, chances, u_light / chances.punctual, u);
  u_light -= chances.punctual;
  if (u_light < chances.emitters) return sample_emitter(receiver, chances, u_light / chances.emitters, u);
  if (!(chances.environment > 0.0f)) return std::nullopt;
  const EnvironmentLight::Sample at = environment_->sample(u);
  const float pdf_sr = at.pdf_sr * chances.environment;
  return LightSample{at.wi, at.radiance / pdf_sr, kInfinity, pdf_sr};
}

// The lights' weights are added up a second time rather than kept: most scenes have a handful.
std::optional<LightSample> Lights::sample_punctual(const Receiver& receiver, const LightChances& chances, float u,
                                                   const glm::vec2& place) const {
  const GpuLight* chosen = nullptr;
  float sum = 0.0f, chosen_weight = 0.0f;
  for (const GpuLight& light : punctual_) {
    const float weight = weight_of(light, receiver);
    if (weight == 0.0f) continue;
    chosen = &light;
    chosen_weight = weight;
    sum += weight;
    if (u * chances.punctual_total < sum) break;
  }
  if (chosen == nullptr) return std::nullopt;
  const float chance = chances.punctual * chosen_weight / chances.punctual_total;
  const shading::LightSample at = arriving(*chosen, receiver.position_ws);
  const bool directional = shading::is_directional(*chosen), shadowed = casts_shadow(*chosen);
  const float distance = directional ? kInfinity : glm::length(vec3(chosen->position_range) - receiver.position_ws);
  const float sine = at.sine;
  if (sine == 0.0f) return LightSample{at.wi, at.irradiance / chance, distance, 0.0f, false, shadowed};
  if (sine >= 1.0f) return std::nullopt;  // inside the bulb
  const vec3 off_axis = shading::sample_cone(place, shading::cone_height(sine * sine));
  const vec3 wi = glm::normalize(shading::from_tangent_space(off_axis, at.wi));
  const float pdf_sr = sphere_pdf_sr(sine) * chance;
  // To the near side of the sphere, so that what touches its far side does not hide it.
  const float sine2 = off_axis.x * off_axis.x + off_axis.y * off_axis.y;
  const float near = directional ? kInfinity : distance * (off_axis.z - std::sqrt(std::max(sine * sine - sine2, 0.0f)));
  return LightSample{wi, sphere_radiance(at.irradiance, sine) / pdf_sr, near, pdf_sr, false, shadowed};
}

std::optional<LightSample> Lights::sample_emitter(const Receiver& receiver, const LightChances& chances, float u_light,
                                                  const glm::vec2& u) const {
  const auto at = emitters_.sample(receiver.position_ws, u_light, u);
  if (!at) return std::nullopt;
  const vec3 way = at->point.position_ws - receiver.position_ws;
  const float squared = glm::dot(way, way), distance = std::sqrt(squared);
  if (!(distance > 0.0f)) return std::nullopt;
  const vec3 wi = way / distance;
  const float cosine = std::abs(glm::dot(wi, at->point.geometric_normal_ws));
  if (!(cosine > 0.0f)) return std::nullopt;
  const float pdf_sr = chances.emitters * at->pdf_m2 * squared / cosine;
  return LightSample{wi, at->radiance / pdf_sr, distance - kEmitterClearance * at->point.rounding_m / cosine, pdf_sr,
                     true};
}

float Lights::pdf_sr_environment(const LightChances& chances, const vec3& wi) const {
  return chances.environment > 0.0f ? chances.environment * environment_->pdf_sr(wi) : 0.0f;
}

float Lights::pdf_sr_emitter(const LightChances& chances, const Hit& hit, const SurfacePoint& p, const vec3& wi) const {
  if (chances.emitters == 0.0f) return 0.0f;
  const float cosine = std::abs(glm::dot(wi, p.geometric_normal_ws));
  if (!(cosine > 0.0f)) return 0.0f;
  return chances.emitters * emitters_.pdf_m2(hit.object, hit.triangle, p.area_m2) * hit.distance * hit.distance /
         cosine;
}

std::optional<Lights::SphereHit> Lights::meet_sphere(const GpuLight& light, const Receiver& receiver,
                                                     const LightChances& chances, const vec3& wi,
                                                     float distance) const {
  const std::optional<float> entry = entry_distance(light, receiver.position_ws, wi);
  if (!entry) return std::nullopt;
  const float near = casts_shadow(light) ? *entry : 0.0f;
  const shading::LightSample at = arriving(light, receiver.position_ws);
  if (near > distance || at.sine >= 1.0f) return std::nullopt;
  const float weight = weight_of(light, receiver);
  if (weight == 0.0f) return std::nullopt;
  const float chance = chances.punctual * weight / chances.punctual_total;
  return SphereHit{sphere_radiance(at.irradiance, at.sine), sphere_pdf_sr(at.sine) * chance, near};
}

}  // namespace velarium::reference
