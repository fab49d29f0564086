#pragma once

// What the header of an OpenEXR picture says about its light: primaries, and the way that directions go to pixels.

#include "image/image.hpp"

#include <ImfHeader.h>

#include <string>

namespace velarium::image {

// The colours in BT.709's primaries, its white where the file's own was (Bradford), for files that name theirs.
void convert_to_bt709(const Imf::Header& header, FloatImage& image);

// A cube (attribute `envmap`) becomes a panorama as wide as four of its faces, with +X in its middle:
// docs/conventions.md. Other pictures stay as they are. Throws Error(input_invalid) where it is no six faces, or the
// panorama is beyond `limits`.
[[nodiscard]] FloatImage panorama_of(const Imf::Header& header, FloatImage image, const std::string& what,
                                     const Limits& limits);

}  // namespace velarium::image
