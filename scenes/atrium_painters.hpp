#pragma once

// What the surfaces of the atrium look like. Colours are chosen by eye; sizes are those of Roman work.

#include "scenes/atrium_paint.hpp"

namespace velarium::scene::atrium {

[[nodiscard]] Texel white_marble(glm::vec2 uv);  // 1.5 m
[[nodiscard]] Texel travertine(glm::vec2 uv);    // 1.2 m
[[nodiscard]] Texel opus_sectile(glm::vec2 uv);  // 3.2 m: two by two squares of coloured marbles
[[nodiscard]] Texel mosaic(glm::vec2 uv);        // 0.96 m: white tesserae with black crosslets
[[nodiscard]] Texel pool_mosaic(glm::vec2 uv);   // 0.96 m
[[nodiscard]] Texel fresco(glm::vec2 uv);        // 3 m wide, 4.2 m high, standing on the floor
[[nodiscard]] Texel brick(glm::vec2 uv);         // 1.2 m
[[nodiscard]] Texel roof_tile(glm::vec2 uv);     // 1.12 m wide, 1.6 m high: four by four tiles
[[nodiscard]] Texel terracotta(glm::vec2 uv);    // 0.8 m
[[nodiscard]] Texel bronze(glm::vec2 uv);        // 0.6 m
[[nodiscard]] Texel linen(glm::vec2 uv);         // 0.5 m, uncoloured
[[nodiscard]] Texel wood(glm::vec2 uv);          // 0.8 m, grain along v
[[nodiscard]] Texel ripples(glm::vec2 uv);       // 4 m of water

}  // namespace velarium::scene::atrium
