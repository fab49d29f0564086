#include "reference/sequence.hpp"

#include "shading/host.hpp"

namespace velarium::reference {

Sequence::Sequence(glm::uvec2 pixel, std::uint32_t sample, std::uint32_t seed)
    : sample_(sample), path_seed_(shading::hash_u32(pixel.x + shading::hash_u32(pixel.y + shading::hash_u32(seed)))) {}

std::uint32_t Sequence::next_seed() {
  // Hashed on both sides: neither neighbouring draws nor neighbouring pixels share a seed.
  return shading::hash_u32(path_seed_ ^ shading::hash_u32(draw_++));
}

float Sequence::next_1d() {
  return shading::scrambled_sobol_1d(sample_, next_seed());
}

glm::vec2 Sequence::next_2d() {
  return shading::scrambled_sobol_2d(sample_, next_seed());
}

}  // namespace velarium::reference
