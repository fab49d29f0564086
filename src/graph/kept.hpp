#pragma once

#include "graph/graph.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace velarium::graph {

// How many submissions may run at once.
inline constexpr std::size_t kMaxRunning = 2;

// An image that the executor keeps.
struct KeptImage {
  std::string name;  // full
  std::uint64_t bytes = 0;
  bool declared = false;  // by the last graph
};

// Images and buffers that graphs declared, kept under their full names for the next graph that declares the same.
// Runs are numbered from 1.
class KeptResources {
 public:
  explicit KeptResources(gpu::Device& device) : device_(device) {}

  // What was kept where it fits, else a new one; it stays until a later run or sweep(). Run by run, in order.
  [[nodiscard]] gpu::Image& image(const Graph::ImageResource& resource, std::uint64_t run);
  // Buffers that the host writes or reads: one for each of the submissions that run at once, of which this is `slot`.
  [[nodiscard]] gpu::Buffer& buffer(const Graph::BufferResource& resource, std::size_t slot, std::uint64_t run);

  [[nodiscard]] std::vector<KeptImage> images(std::uint64_t last_run) const;
  // Frees what was declared by no run after this one. Precondition: the device uses nothing of it.
  void free_declared_until(std::uint64_t run);

 private:
  struct Image {
    gpu::Image image;
    std::uint64_t declared_in = 0;
  };
  struct Buffer {
    VkBufferUsageFlags usage = 0;
    gpu::MemoryUse use = gpu::MemoryUse::device;
    gpu::Buffer buffer;
    std::uint64_t declared_in = 0;
  };
  gpu::Device& device_;
  std::map<std::string, Image> images_;
  std::array<std::map<std::string, Buffer>, kMaxRunning> buffers_;  // by slot; those of the device alone in the first
};

}  // namespace velarium::graph
