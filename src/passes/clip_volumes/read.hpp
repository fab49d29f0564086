#pragma once

#include "passes/io.hpp"
#include "upload/tables.hpp"

namespace velarium::clip_volumes {

namespace io {
using namespace shading;
#include "passes/clip_volumes/clip_volumes_io.glsl"
}  // namespace io

// Volumes that lights end at, as lit points read them.
struct Reading {
  const gpu::Buffer& records;  // upload::ClipVolumeTable; null where no light ends at one; outlives the frame
};

[[nodiscard]] inline Reading reading(const upload::Tables& tables) {
  return {tables.clip_volume_buffer};
}

inline void declare(graph::Pass&, const Reading&, graph::Access) {}
inline void bind(graph::SetWriter& set, const Reading& in) {
  set.buffer(io::ClipVolumeBuffer, in.records);
}
inline void specialize(gpu::Specialization& constants, const Reading& in) {
  constants.set(io::kClipVolumes, static_cast<bool>(in.records));
}

}  // namespace velarium::clip_volumes
