#pragma once

// KHR_draco_mesh_compression: primitives whose indices and attributes lie compressed in one buffer view.

#include "scene/gltf_accessors.hpp"
#include "scene/gltf_extensions.hpp"

namespace velarium::scene::gltf {

// What a primitive holds compressed. For as long as this lives, the primitive's accessors read it instead of their own
// views; accessors that the extension does not name are left as they are.
class DracoGeometry {
 public:
  // Decodes, where the primitive has the extension. Throws at the pointer at fault where the data is damaged, or is not
  // what the accessors say.
  DracoGeometry(Context& context, Accessors& accessors, const Value& primitive);
  ~DracoGeometry() { accessors_.restore(); }
  DracoGeometry(const DracoGeometry&) = delete;
  DracoGeometry& operator=(const DracoGeometry&) = delete;

  // Whether there is any; its indices then are a list of triangles.
  [[nodiscard]] explicit operator bool() const { return present_; }

 private:
  Accessors& accessors_;
  bool present_ = false;
};

}  // namespace velarium::scene::gltf
