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

// Each kind of light that there is gets at least this chance: the estimates behind the rest may be far off.
constexpr float kLeastChance = 0.1f;

float radius_of(const GpuLight& lamp) {
  return shading::is_directional(lamp) ? 0.0f : lamp.color.w;
}

// Sine of the half angle under which a spherical lamp is seen; 0 for points, 1 from inside.
float sine_of(const GpuLight& lamp, const vec3& position) {
  const float radius = radius_of(lamp);
  if (radius == 0.0f) return 0.0f;
  return std::min(radius / std::max(glm::length(vec3(lamp.position_range) - position), 1e-20f), 1.0f);
}

// How much of the lamp's light the receiver can use at most. 0 where it can use none.
float weight_of(const GpuLight& lamp, const Receiver& receiver) {
  const shading::LightSample at = shading::sample_light(lamp, receiver.position_ws);
  const float cosine = std::min(glm::dot(receiver.normal_ws, at.wi) + sine_of(lamp, receiver.position_ws), 1.0f);
  return cosine > 0.0f ? shading::luminance(at.irradiance) * cosine : 0.0f;
}

// 1 - cos of the half angle, without the loss of digits of narrow cones.
float one_minus_cosine(float sine) {
  return sine * sine / (1.0f + std::sqrt(std::max(1.0f - sine * sine, 0.0f)));
}

float sphere_pdf_sr(float sine) {
  return 1.0f / (2.0f * kPi * one_minus_cosine(sine));
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
    for (std::uint32_t x = 0; x < image.width; ++x)
      sum += weight * static_cast<double>(shading::luminance({row[4 * x], row[4 * x + 1], row[4 * x + 2]}));
    weights += weight * image.width;
  }
  return weights > 0.0 ? static_cast<float>(sum / weights) : 0.0f;
}

}  // namespace

Lights::Lights(std::vector<GpuLight> lamps, const image::FloatImage* environment, float rotation_deg, float intensity,
               const std::vector<Object>& objects, const Materials& materials)
    : lamps_(std::move(lamps)), emitters_(objects, materials) {
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    if (radius_of(lamps_[i]) > 0.0f) spheres_.push_back(i);
  if (environment == nullptr) return;
  environment_.emplace(*environment, rotation_deg, intensity);
  environment_irradiance_ = kPi * intensity * mean_luminance(*environment);
}

vec3 Lights::environment(const vec3& direction) const {
  return environment_ ? environment_->radiance(direction) : vec3(0.0f);
}

LightChances Lights::chances(const Receiver& receiver, LightKinds kinds) const {
  LightChances c;
  for (const GpuLight& lamp : lamps_) c.lamp_total += weight_of(lamp, receiver);
  c.lamps = c.lamp_total;
  if (kinds.environment && has_environment()) c.environment = environment_irradiance_;
  if (kinds.emitters && has_emitters()) c.emitters = emitters_.irradiance_at(receiver.position_ws);
  const float total = c.lamps + c.environment + c.emitters;
  if (!(total > 0.0f)) return {};
  float floored = 0.0f;
  for (float* chance : {&c.lamps, &c.environment, &c.emitters})
    if (*chance > 0.0f) floored += * chance = std::max(*chance / total, kLeastChance);
  for (float* chance : {&c.lamps, &c.environment, &c.emitters}) *chance /= floored;
  return c;
}

std::optional<LightSample> Lights::sample(const Receiver& receiver, const LightChances& chances, float u_light,
                                          const glm::vec2& u) const {
  if (u_light < chances.lamps) return sample_lamp(receiver, chances, u_light / chances.lamps, u);
  u_light -= chances.lamps;
  if (u_light < chances.emitters) return sample_emitter(receiver, chances, u_light / chances.emitters, u);
  if (!(chances.environment > 0.0f)) return std::nullopt;
  const EnvironmentLight::Sample at = environment_->sample(u);
  const float pdf_sr = at.pdf_sr * chances.environment;
  return LightSample{at.wi, at.radiance / pdf_sr, kInfinity, pdf_sr};
}

// The lamps' weights are added up a second time rather than kept: most scenes have a handful.
std::optional<LightSample> Lights::sample_lamp(const Receiver& receiver, const LightChances& chances, float u,
                                               const glm::vec2& place) const {
  const GpuLight* chosen = nullptr;
  float sum = 0.0f, chosen_weight = 0.0f;
  for (const GpuLight& lamp : lamps_) {
    const float weight = weight_of(lamp, receiver);
    if (weight == 0.0f) continue;
    chosen = &lamp;
    chosen_weight = weight;
    sum += weight;
    if (u * chances.lamp_total < sum) break;
  }
  if (chosen == nullptr) return std::nullopt;
  const float chance = chances.lamps * chosen_weight / chances.lamp_total;
  const shading::LightSample at = shading::sample_light(*chosen, receiver.position_ws);
  const float distance =
      shading::is_directional(*chosen) ? kInfinity : glm::length(vec3(chosen->position_range) - receiver.position_ws);
  const float sine = sine_of(*chosen, receiver.position_ws);
  if (sine == 0.0f) return LightSample{at.wi, at.irradiance / chance, distance, 0.0f};
  if (sine >= 1.0f) return std::nullopt;  // inside the bulb
  const float drop = place.x * one_minus_cosine(sine), cosine = 1.0f - drop;
  const float across = std::sqrt(drop * (2.0f - drop)), turn = 2.0f * kPi * place.y;
  const vec3 wi =
      glm::normalize(shading::from_tangent_space({across * std::cos(turn), across * std::sin(turn), cosine}, at.wi));
  const float pdf_sr = sphere_pdf_sr(sine) * chance;
  // To the near side of the sphere, so that what touches its far side does not hide it.
  const float near = distance * (cosine - std::sqrt(std::max(sine * sine - across * across, 0.0f)));
  return LightSample{wi, sphere_radiance(at.irradiance, sine) / pdf_sr, near, pdf_sr};
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

std::optional<Lights::SphereHit> Lights::meet_sphere(const GpuLight& lamp, const Receiver& receiver,
                                                     const LightChances& chances, const vec3& wi,
                                                     float distance) const {
  const float sine = sine_of(lamp, receiver.position_ws);
  if (sine >= 1.0f) return std::nullopt;
  const vec3 to_center = vec3(lamp.position_range) - receiver.position_ws;
  const float along = glm::dot(to_center, wi);
  const vec3 off = to_center - along * wi;
  const float radius = radius_of(lamp), gap = radius * radius - glm::dot(off, off);
  if (along <= 0.0f || gap <= 0.0f || along - std::sqrt(gap) > distance) return std::nullopt;
  const float weight = weight_of(lamp, receiver);
  if (weight == 0.0f) return std::nullopt;
  const shading::LightSample at = shading::sample_light(lamp, receiver.position_ws);
  const float chance = chances.lamps * weight / chances.lamp_total;
  return SphereHit{sphere_radiance(at.irradiance, sine), sphere_pdf_sr(sine) * chance};
}

}  // namespace velarium::reference
