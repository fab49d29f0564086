#pragma once

#include <velarium/engine.hpp>
#include <velarium/picture.hpp>

namespace velarium::api {

// Fills picture.display from picture.linear, as the renderer's last passes do on the device: exposure, tone curve,
// background, encoding, dither.
void display(Picture& picture, const RenderRequest& request);

}  // namespace velarium::api
