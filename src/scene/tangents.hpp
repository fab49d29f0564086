#pragma once

#include "scene/scene.hpp"

namespace velarium::scene {

// Gives each triangle its own vertices and face normal (glTF 2.0, 3.7.2.1: absent normals are flat).
// Also splits every other attribute and morph target. Precondition: triangles without normals.
void make_flat_normals(Primitive& primitive);

// Gives normals of no length the mean direction of the triangles at their vertex, weighted by area; any where there are
// none.
void fill_zero_normals(Primitive& primitive);

// Tangent frames after Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008), as the glTF specification asks:
// the reference algorithm (MikkTSpace) on triangles with the texture coordinates of `uv_set`.
// Vertices whose corners disagree are split. Precondition: triangles with normals and that uv set.
void make_tangents(Primitive& primitive, std::uint32_t uv_set);

}  // namespace velarium::scene
