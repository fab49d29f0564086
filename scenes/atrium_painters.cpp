#include "scenes/atrium_painters.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::scene::atrium {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

struct Marble {
  vec3 ground, vein;
  float vein_width;
};

constexpr Marble kWhiteMarble{{0.87f, 0.84f, 0.79f}, {0.69f, 0.67f, 0.65f}, 0.035f};
constexpr Marble kYellowMarble{{0.83f, 0.65f, 0.37f}, {0.60f, 0.36f, 0.20f}, 0.06f};  // giallo antico
constexpr Marble kPurpleMarble{{0.85f, 0.80f, 0.78f}, {0.42f, 0.27f, 0.33f}, 0.11f};  // pavonazzetto
constexpr Marble kGreenMarble{{0.15f, 0.29f, 0.22f}, {0.42f, 0.56f, 0.43f}, 0.05f};   // serpentine
constexpr Marble kPorphyry{{0.38f, 0.12f, 0.14f}, {0.62f, 0.40f, 0.38f}, 0.03f};

// Veins lie where one noise, warped by others, crosses its mean.
vec3 marble_color(const Marble& marble, vec2 uv, int scale, std::uint32_t seed) {
  const ivec2 period(scale);
  const vec2 p = uv * static_cast<float>(scale);
  const float warp = fractal_noise(p, period, seed);
  const float field = noise(p + vec2(2.4f * warp, 1.7f * warp), period, seed + 7);
  const float fine = noise(2.0f * p + vec2(1.9f * warp), 2 * period, seed + 11);
  const float vein = smooth_step(marble.vein_width, 0.0f, std::abs(field - 0.5f)) +
                     0.5f * smooth_step(0.6f * marble.vein_width, 0.0f, std::abs(fine - 0.5f));
  const vec3 clouded = marble.ground * (0.90f + 0.20f * warp);
  return glm::mix(clouded, marble.vein, std::min(0.7f * vein, 0.75f));
}

// Where in a regular grid of rectangles a point lies.
struct Cell {
  ivec2 index;
  vec2 inside;  // 0 to 1
};

Cell cell_of(vec2 p) {
  const vec2 floor = glm::floor(p);
  return {ivec2(floor), p - floor};
}

// 1 inside a rectangle of the unit cell, 0 in the joint around it.
float inside_joint(vec2 inside, vec2 joint) {
  const vec2 edge = glm::min(inside, 1.0f - inside);
  return smooth_step(0.5f * joint.x, 1.5f * joint.x, edge.x) * smooth_step(0.5f * joint.y, 1.5f * joint.y, edge.y);
}

Texel tessera(vec2 uv, int count, const vec3& color, std::uint32_t seed) {
  const Cell cell = cell_of(uv * static_cast<float>(count));
  const float stone = inside_joint(cell.inside, vec2(0.07f));
  const float shade = 0.88f + 0.2f * cell_noise(cell.index.x, cell.index.y, seed);
  return {.color = glm::mix(vec3(0.45f, 0.41f, 0.36f), color * shade, stone),
          .height = 0.0012f * stone + 0.0008f * cell_noise(cell.index.x, cell.index.y, seed + 1),
          .roughness = glm::mix(0.8f, 0.28f, stone)};
}

// One square of the pavement: a field, in it a square on its corner, in that a disc; between thin bands of white.
Texel sectile_square(vec2 uv, vec2 inside, bool dark) {
  const vec2 q = glm::abs(inside - 0.5f);
  const float square = std::max(q.x, q.y), diamond = q.x + q.y, disc = glm::length(q);
  const auto white = [&] { return marble_color(kWhiteMarble, uv, 6, 3); };
  const auto pick = [&](const Marble& when_dark, const Marble& when_light, std::uint32_t seed) {
    return dark ? marble_color(when_dark, uv, 12, seed) : marble_color(when_light, uv, 12, seed);
  };
  float edge = 1.0f;
  for (const float d : {square - 0.455f, square - 0.425f, diamond - 0.41f, disc - 0.2f, disc - 0.175f})
    edge = std::min(edge, std::abs(d));
  const float joint = smooth_step(0.0045f, 0.0015f, edge);
  vec3 color;
  if (square > 0.455f)
    color = marble_color(kPurpleMarble, uv, 10, 40);
  else if (square > 0.425f)
    color = marble_color(kPorphyry, uv, 24, 50);
  else if (disc < 0.175f)
    color = pick(kGreenMarble, kPorphyry, 60);
  else if (disc < 0.2f)
    color = white();
  else if (diamond < 0.41f)
    color = pick(kWhiteMarble, kYellowMarble, 70);
  else
    color = pick(kYellowMarble, kGreenMarble, 80);
  const float wear = fractal_noise(8.0f * uv, ivec2(8), 90);
  return {.color = glm::mix(color, vec3(0.30f, 0.27f, 0.24f), 0.7f * joint) * (0.94f + 0.1f * wear),
          .height = -0.0006f * joint,
          .roughness = 0.13f + 0.22f * wear * wear + 0.3f * joint};
}

// Thin painted frames, lines around the middle of a panel. `half`: of the panel; `at`: from its middle, metres.
float frame_line(vec2 at, vec2 half, float width) {
  const vec2 q = glm::abs(at) - half;
  return smooth_step(width, 0.4f * width, std::abs(std::max(q.x, q.y)));
}

constexpr vec3 kPompeianRed{0.53f, 0.13f, 0.09f}, kCream{0.85f, 0.77f, 0.62f}, kOchre{0.76f, 0.53f, 0.22f},
    kSoot{0.13f, 0.11f, 0.11f}, kSage{0.36f, 0.43f, 0.33f};

// Paint by height above the floor and place in a panel 3 m wide, metres.
vec3 fresco_paint(float x, float y) {
  const float from_middle = x - 1.5f, upright = std::abs(from_middle);
  if (y < 0.14f) return kSoot;
  if (y < 1.42f) {
    const vec3 field = upright > 1.38f ? kSoot : kPompeianRed;
    const float line = frame_line({from_middle, y - 0.78f}, {1.22f, 0.50f}, 0.012f) +
                       frame_line({from_middle, y - 0.78f}, {1.16f, 0.44f}, 0.006f);
    return glm::mix(field, kOchre, std::min(line, 1.0f));
  }
  if (y < 1.47f) return kCream;
  if (y < 1.58f) return kSage;
  if (y < 1.61f) return kOchre;
  if (y > 3.62f) return kCream;
  if (y > 3.58f || (y > 3.26f && y < 3.30f)) return kPompeianRed;
  if (y > 3.30f) {
    // A running wave: half discs that swing up and down.
    const float wave = x * 4.0f - std::floor(x * 4.0f), up = (y - 3.30f) / 0.28f;
    const bool upper = wave < 0.5f;
    const vec2 q((upper ? wave - 0.25f : wave - 0.75f) * 0.9f, (upper ? up - 0.56f : up - 0.44f) * 1.0f);
    const float ring = std::abs(glm::length(q) - 0.22f);
    const bool half = upper ? up > 0.5f : up < 0.5f;
    return glm::mix(kOchre, kPompeianRed, half ? smooth_step(0.09f, 0.06f, ring) : 0.0f);
  }
  const float line = frame_line({from_middle, y - 2.43f}, {1.20f, 0.66f}, 0.014f);
  const float inner = frame_line({from_middle, y - 2.43f}, {1.10f, 0.56f}, 0.006f);
  const vec3 field = glm::mix(kCream, kPompeianRed, line);
  return glm::mix(upright > 1.40f ? kSage : field, kOchre, inner);
}

}  // namespace

Texel white_marble(vec2 uv) {
  const float cloud = fractal_noise(4.0f * uv, ivec2(4), 5);
  return {.color = marble_color(kWhiteMarble, uv, 3, 1) * (0.95f + 0.08f * cloud),
          .height = 0.0008f * cloud,
          .roughness = 0.34f + 0.2f * cloud};
}

Texel travertine(vec2 uv) {
  const float bands = fractal_noise({2.0f * uv.x, 10.0f * uv.y}, {2, 10}, 21);
  const float pits = smooth_step(0.66f, 0.78f, fractal_noise({10.0f * uv.x, 28.0f * uv.y}, {10, 28}, 22));
  return {.color = glm::mix(vec3(0.70f, 0.62f, 0.50f), vec3(0.84f, 0.78f, 0.67f), bands) * (1.0f - 0.35f * pits),
          .height = -0.004f * pits + 0.001f * bands,
          .roughness = 0.6f + 0.25f * pits};
}

Texel opus_sectile(vec2 uv) {
  const Cell cell = cell_of(2.0f * uv);
  return sectile_square(uv, cell.inside, ((cell.index.x + cell.index.y) & 1) != 0);
}

Texel mosaic(vec2 uv) {
  constexpr int kCount = 48, kCross = 12;
  const ivec2 index = cell_of(uv * static_cast<float>(kCount)).index;
  const ivec2 place = glm::abs(index % kCross - kCross / 2);
  const bool black = place.x + place.y == 1 || place.x + place.y == 2 ? std::min(place.x, place.y) == 0 : false;
  Texel texel = tessera(uv, kCount, black ? vec3(0.16f, 0.15f, 0.16f) : vec3(0.80f, 0.76f, 0.68f), 31);
  texel.color *= 0.86f + 0.22f * fractal_noise(3.0f * uv, ivec2(3), 33);
  return texel;
}

Texel pool_mosaic(vec2 uv) {
  constexpr int kCount = 48;
  const ivec2 index = cell_of(uv * static_cast<float>(kCount)).index;
  const float pick = cell_noise(index.x, index.y, 35);
  const vec3 color = pick < 0.45f   ? vec3(0.10f, 0.35f, 0.40f)
                     : pick < 0.75f ? vec3(0.16f, 0.46f, 0.46f)
                     : pick < 0.94f ? vec3(0.07f, 0.22f, 0.36f)
                                    : vec3(0.70f, 0.62f, 0.38f);
  return tessera(uv, kCount, color, 36);
}

Texel fresco(vec2 uv) {
  const float x = 3.0f * uv.x, y = 4.2f * (1.0f - uv.y);
  const float stain = fractal_noise(6.0f * uv, ivec2(6), 41);
  const float streak = fractal_noise({20.0f * uv.x, 2.0f * uv.y}, {20, 2}, 46);
  const float grain = noise(160.0f * uv, ivec2(160), 52);
  // Damp climbs from the floor and takes the paint with it.
  const float worn =
      smooth_step(0.66f, 0.74f, fractal_noise(9.0f * uv, ivec2(9), 55) + 0.16f * smooth_step(0.7f, 0.0f, y));
  const vec3 paint = fresco_paint(x, y) * (0.86f + 0.18f * stain + 0.12f * (streak - 0.5f));
  const vec3 plaster = vec3(0.72f, 0.65f, 0.54f) * (0.9f + 0.2f * grain);
  return {.color = glm::mix(paint, plaster, 0.8f * worn),
          .height = 0.003f * stain + 0.0005f * grain - 0.0015f * worn,
          .roughness = 0.52f + 0.15f * stain + 0.25f * worn};
}

Texel brick(vec2 uv) {
  vec2 p(4.0f * uv.x, 20.0f * uv.y);
  const int course = static_cast<int>(p.y);
  p.x += 0.5f * static_cast<float>(course & 1);
  const Cell cell = cell_of(p);
  const int column = cell.index.x & 3;
  const float rough_edge = 0.25f * (noise(60.0f * uv, ivec2(60), 61) - 0.5f);
  const float fired = inside_joint(cell.inside, vec2(0.022f, 0.12f) * (1.0f + rough_edge));
  const float shade = cell_noise(column, course, 62), grain = fractal_noise(32.0f * uv, ivec2(32), 63);
  const vec3 clay = glm::mix(vec3(0.56f, 0.29f, 0.19f), vec3(0.74f, 0.46f, 0.30f), shade) * (0.82f + 0.34f * grain);
  const vec3 mortar = vec3(0.70f, 0.65f, 0.57f) * (0.8f + 0.3f * grain);
  return {.color = glm::mix(mortar, clay, fired),
          .height = 0.006f * fired + 0.002f * grain + 0.002f * shade,
          .roughness = 0.82f + 0.12f * grain};
}

Texel roof_tile(vec2 uv) {
  const Cell cell = cell_of(4.0f * uv);
  const float shade = cell_noise(cell.index.x, cell.index.y, 71), grain = fractal_noise(12.0f * uv, ivec2(12), 72);
  const float lichen = smooth_step(0.62f, 0.72f, fractal_noise(5.0f * uv, ivec2(5), 73));
  const vec3 clay = glm::mix(vec3(0.60f, 0.32f, 0.21f), vec3(0.76f, 0.48f, 0.33f), shade) * (0.8f + 0.35f * grain);
  return {
      .color = glm::mix(clay, vec3(0.50f, 0.48f, 0.36f), 0.5f * lichen), .height = 0.004f * grain, .roughness = 0.8f};
}

Texel terracotta(vec2 uv) {
  const float rings = noise({4.0f * uv.x, 60.0f * uv.y}, {4, 60}, 81), grain = fractal_noise(16.0f * uv, ivec2(16), 82);
  return {.color = vec3(0.72f, 0.41f, 0.27f) * (0.78f + 0.3f * grain + 0.12f * rings),
          .height = 0.0015f * rings + 0.001f * grain,
          .roughness = 0.68f + 0.15f * grain};
}

Texel bronze(vec2 uv) {
  const float field = fractal_noise(6.0f * uv, ivec2(6), 91), grain = fractal_noise(24.0f * uv, ivec2(24), 95);
  const float patina = smooth_step(0.52f, 0.68f, field + 0.2f * (grain - 0.5f));
  const vec3 metal = vec3(0.74f, 0.56f, 0.36f) * (0.85f + 0.25f * grain);
  return {.color = glm::mix(metal, vec3(0.36f, 0.52f, 0.45f) * (0.75f + 0.5f * grain), 0.8f * patina),
          .height = 0.0008f * patina + 0.0006f * grain,
          .roughness = glm::mix(0.28f + 0.15f * grain, 0.75f, patina),
          .metallic = 1.0f - patina};
}

Texel linen(vec2 uv) {
  constexpr float kThreads = 64.0f;
  const vec2 p = kThreads * uv;
  const Cell cell = cell_of(p);
  const vec2 arch = 1.0f - 4.0f * (cell.inside - 0.5f) * (cell.inside - 0.5f);
  const bool over = ((cell.index.x + cell.index.y) & 1) != 0;
  const float thread = over ? arch.x : arch.y;
  const float slub = noise(over ? vec2(p.x, 0.2f * p.y) : vec2(0.2f * p.x, p.y), ivec2(64), 101);
  const float shade = 0.82f + 0.14f * thread + 0.1f * (slub - 0.5f) + 0.1f * fractal_noise(4.0f * uv, ivec2(4), 102);
  return {.color = vec3(0.95f) * shade, .height = 0.0006f * thread, .roughness = 0.9f};
}

Texel wood(vec2 uv) {
  const float warp = fractal_noise({4.0f * uv.x, 1.0f * uv.y}, {4, 1}, 111);
  const float grain = fractal_noise({32.0f * uv.x + 6.0f * warp, 2.0f * uv.y}, {32, 2}, 112);
  const float pore = smooth_step(0.62f, 0.75f, noise({128.0f * uv.x, 6.0f * uv.y}, {128, 6}, 117));
  return {.color = glm::mix(vec3(0.26f, 0.15f, 0.09f), vec3(0.50f, 0.32f, 0.19f), grain) * (1.0f - 0.3f * pore),
          .height = 0.0008f * grain - 0.0008f * pore,
          .roughness = 0.55f + 0.2f * pore};
}

Texel ripples(vec2 uv) {
  return {.color = vec3(1.0f), .height = 0.010f * fractal_noise(6.0f * uv, ivec2(6), 121), .roughness = 1.0f};
}

}  // namespace velarium::scene::atrium
