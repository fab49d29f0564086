#pragma once

#include <glm/vec4.hpp>

#include <vector>

namespace velarium::bake {

// One cell of a lobe's hemisphere.
struct LobeSample {
  float x, y;        // direction about +z, the mirror direction; z = sqrt(1 - x^2 - y^2)
  float source_lod;  // level of the box-filtered source cube whose texels are as large as the cell
  float weight;      // integral of D n.l over the cell; all cells sum to 1
};

// How finely a lobe is cut.
struct LobeGrid {
  float core;    // size of the cells about the axis, in half widths of the lobe at half its maximum
  float growth;  // size of the cells further out, as a part of their angle from the axis
};

// The GGX lobe seen head-on, n = v = r, cut into cells that cover its hemisphere: rings about the axis, and each ring
// into nearly square cells. Sampling by the lobe's density instead [Colbert & Krivanek 2007] spends next to nothing on
// the tails, where a light can be a thousand times brighter than what lies on the axis: it left speckles around lights.
// alpha > 0; face_size: pixels a side of the source's level 0.
[[nodiscard]] std::vector<LobeSample> cut_lobe(float alpha, const LobeGrid& grid, float face_size);

}  // namespace velarium::bake
