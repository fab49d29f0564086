#pragma once

#include "upload/casters.hpp"

namespace velarium::local_shadows {

// How far from `position` the nearest surface stands that casts shadows, within [nearest, farthest]: metres, places
// relative to the origin. A caster without triangles at hand is taken for its box. translucent: do such casters count?
[[nodiscard]] double nearest_caster(const upload::CasterTable& table, const glm::dvec3& origin,
                                    const glm::dvec3& position, double nearest, double farthest, bool translucent);

}  // namespace velarium::local_shadows
