#pragma once

#include "gpu/image.hpp"

namespace velarium::gpu {

// Makes dispatches see across the edges of a cube's faces, after its texels have changed; on most drivers they do, and
// this does nothing. SwiftShader reads there from a border that it keeps about each face, and copies the neighbours'
// texels into it before a draw or a blit reads the cube, but not before a dispatch: without this, edges show what that
// memory happened to hold (Chromium 156; src/Pipeline/ComputeProgram.cpp calls no PrepareForSampling(), Image::blitTo()
// does).
//
// Precondition: colour that may be copied from, and all work on it is done. Its layout stays.
void fill_cube_edges(Device& device, Image& cube);

}  // namespace velarium::gpu
