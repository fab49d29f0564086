#pragma once

// What tests of the sun's shadows share.

#include "support/pictures.hpp"

#include <string>
#include <vector>

namespace velarium::test {

// How bright each pixel of a picture is beside one without the sun's shadows: 1 where the sun arrives, 0 in shadow.
// What is black in both is 1.
[[nodiscard]] std::vector<float> shadow_of(const Scene& scene, const RenderRequest& wanted);

// A plane of 12 metres under a sun that it turns away from by this angle, degrees.
[[nodiscard]] Scene tilted_plane(float tilt);

// Where that plane is darkest, as shadow_of() says: 1 where it shows no shadow of its own. options: KEY=VALUE, parted
// by spaces.
[[nodiscard]] float darkest_on_plane(const Scene& plane, const std::string& options);

}  // namespace velarium::test
