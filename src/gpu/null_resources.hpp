#pragma once

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "gpu/slot.hpp"

#include <vector>

namespace velarium::gpu {

// What stands where a technique that is off would be read: every binding that a shader names must be bound, though
// specialisation keeps it from being read. Images of one texel, 0 in each channel, and a buffer of zeros.
class NullResources {
 public:
  explicit NullResources(Device& device);

  // Ready to be sampled. Precondition: the type is that of an image.
  [[nodiscard]] const Image& image(SlotType type) const;
  [[nodiscard]] const Buffer& buffer() const { return buffer_; }

 private:
  struct Null {
    SlotType type;
    Image image;
  };
  std::vector<Null> images_;
  Buffer buffer_;
};

}  // namespace velarium::gpu
