#pragma once

// Vertex attributes and morph targets of one primitive.

#include "scene/gltf_accessors.hpp"
#include "scene/gltf_extensions.hpp"

namespace velarium::scene::gltf {

// Fills vertices, uv, colors, joints and weights of `primitive` from the glTF object `value`, which has a POSITION.
// Directions come out of unit length, colours within 0 and 1, weights with sum 1.
void read_attributes(Context& context, Accessors& accessors, const Value& value, Primitive& primitive);

// Fills morph_targets. `primitive` has its attributes.
void read_morph_targets(Context& context, Accessors& accessors, const Value& value, Primitive& primitive);

}  // namespace velarium::scene::gltf
