#pragma once

#include <cstdint>

namespace velarium::passes {

// Maps of one technique that share a side, before they are made: what shadows.memory bounds.
struct MapDemand {
  const char* option = "";        // that names the side
  int side = 0;                   // texels, as the option asks for
  std::uint64_t texel_bytes = 0;  // of all of them together; 0: a picture has none
};

}  // namespace velarium::passes
