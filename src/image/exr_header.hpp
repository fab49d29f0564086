#pragma once

#include "image/codecs.hpp"

namespace velarium::image {

// Reads every header of an OpenEXR file and compares what it claims with the limits, so that OpenEXR, which believes
// headers, never allocates more than they allow. Throws Error(input_invalid), and Error(unsupported) for deep data.
void check_exr_headers(Bytes data, const std::string& what, const Limits& limits);

}  // namespace velarium::image
