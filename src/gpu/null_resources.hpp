#pragma once

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "gpu/slot.hpp"

#include <map>

namespace velarium::gpu {

// What stands where a technique that is off would be read: every binding that a shader names must be bound, though
// specialisation keeps it from being read. Images of one texel, 0 in each channel, and a buffer of zeros.
class NullResources {
 public:
  explicit NullResources(Device& device) : device_(device) {}

  // Makes them all, once. Not while commands are recorded: it submits work of its own.
  void make();
  // Ready to be sampled. Precondition: make() was called, and the type is that of an image.
  [[nodiscard]] const Image& image(SlotType type) const;
  [[nodiscard]] const Buffer& buffer() const { return buffer_; }

 private:
  Device& device_;
  std::map<SlotType, Image> images_;
  Buffer buffer_;
};

}  // namespace velarium::gpu
