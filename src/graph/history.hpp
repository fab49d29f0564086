#pragma once

#include "gpu/image.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace velarium::graph {

class Graph;

// Images of the frame before, by name: pairs that take turns, one read while the other is written. An executor owns
// them, and graphs that ask for history are declared against them. Pairs are found by names, images never move.
class HistoryStore {
 public:
  struct Pair {
    gpu::ImageDesc desc;
    std::array<gpu::Image, 2> images;
    std::uint32_t current = 0;      // which image the next graph writes
    bool has_contents = false;      // of the other image, and of `desc`
    std::uint64_t state = 0;        // no other state of any pair has this number
    std::uint64_t declared_in = 0;  // number of the last run that declared it

    // What was written last, and what the next graph writes.
    [[nodiscard]] gpu::Image& newest() { return images[1 - current]; }
    [[nodiscard]] gpu::Image& next() { return images[current]; }
  };

  // Made when it is first asked for.
  [[nodiscard]] Pair& pair(const std::string& name);
  [[nodiscard]] const std::map<std::string, Pair>& pairs() const { return pairs_; }

  // Throws Error(internal) where a history of the graph has changed since it was declared: another graph ran in
  // between, or it was forgotten.
  void refuse_outdated(const Graph& graph) const;
  // Makes the images that the graph declares, and keeps those that fit. Precondition: refuse_outdated() has not thrown.
  void allocate(gpu::Device& device, const Graph& graph, std::uint64_t run);
  // Clears what the graph reads of a frame that was not. Begins a command buffer.
  void clear_missing(const Graph& graph, VkCommandBuffer commands) const;
  // What the graph wrote is what the next one reads. Once it has been submitted.
  void advance(const Graph& graph);
  // From here on there is no frame before. The images stay.
  void forget();
  // Frees pairs that no run after this one declared. Precondition: the device uses nothing of them.
  void free_declared_until(std::uint64_t run);

 private:
  std::map<std::string, Pair> pairs_;
  std::uint64_t states_ = 0;  // how many there have been
};

}  // namespace velarium::graph
