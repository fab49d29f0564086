#pragma once

#include "support/pictures.hpp"

#include <vector>

namespace velarium::test {

// How bright each pixel of a picture is beside one without the sun's shadows: 1 where the sun arrives, 0 in shadow.
// What is black in both is 1.
[[nodiscard]] inline std::vector<float> shadow_of(const Scene& scene, const RenderRequest& wanted) {
  RenderRequest bare = wanted;
  bare.settings.sun_shadows.enabled = false;
  const Picture lit = picture_of(scene, bare), shadowed = picture_of(scene, wanted);
  std::vector<float> share;
  for (std::size_t i = 0; i < lit.linear.size(); i += 4)
    share.push_back(lit.linear[i] > 0.0f ? shadowed.linear[i] / lit.linear[i] : 1.0f);
  return share;
}

}  // namespace velarium::test
