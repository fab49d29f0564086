#pragma once

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "graph/access.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace velarium::graph {

class Context;
class Pass;

// One version of an image: each write makes a new one, and a read of an old one is refused when it is declared.
struct GraphImage {
  std::uint32_t index = 0, version = 0;  // version 0: null, or not written yet
  bool operator==(const GraphImage&) const = default;
};

struct GraphBuffer {
  std::uint32_t index = 0, version = 0;
  bool operator==(const GraphBuffer&) const = default;
};

// Passes and what they use, in the order in which they run. The graph reorders nothing: barriers (plan.hpp),
// allocation, labels and times (executor.hpp) follow from what is declared. A graph describes one frame.
//
//   auto& pass = graph.pass("ssdo");
//   pass.read(depth, Access::compute_sample);
//   const auto bent = pass.write(graph.image("bent_normal", desc), Access::compute_storage);
//   pass.run([=](Context& c) { ... });
class Graph {
 public:
  // An image that lives for the frame. Its full name, for labels and --dump, is "pass.name" of the first writer.
  [[nodiscard]] GraphImage image(std::string_view name, const gpu::ImageDesc& desc);
  // An image that outlives the frame, with contents from before if `initialized` (in any layout the graph left).
  [[nodiscard]] GraphImage import(std::string_view name, gpu::Image& image, bool initialized);
  [[nodiscard]] GraphBuffer buffer(std::string_view name, VkDeviceSize bytes,
                                   gpu::MemoryUse use = gpu::MemoryUse::device);
  // A table that the host writes: a storage buffer with these bytes, there before the first pass. Shaders may read it
  // in any pass without a declaration, as no pass writes it. `name`: full, "technique.table".
  [[nodiscard]] GraphBuffer upload(std::string_view name, std::span<const std::byte> bytes);
  template <class T>
  [[nodiscard]] GraphBuffer upload(std::string_view name, const T& table) {
    static_assert(std::is_trivially_copyable_v<T>);
    return upload(name, std::as_bytes(std::span(&table, 1)));
  }
  template <class T>
  [[nodiscard]] GraphBuffer upload(std::string_view name, const std::vector<T>& table) {
    return upload(name, std::as_bytes(std::span(table)));
  }

  // Declares the next pass. Its name is the label, the row in --timings, and the first half of --dump names.
  Pass& pass(std::string_view name);

  struct ImageResource {
    std::string name;
    gpu::ImageDesc desc;
    VkImageUsageFlags usage = 0;
    gpu::Image* imported = nullptr;
    std::uint32_t version = 0;
  };
  struct BufferResource {
    std::string name;
    VkDeviceSize bytes = 0;
    gpu::MemoryUse use = gpu::MemoryUse::device;
    VkBufferUsageFlags usage = 0;
    std::uint32_t version = 0;
    std::vector<std::byte> contents;  // of an upload
  };
  [[nodiscard]] const std::deque<Pass>& passes() const { return passes_; }
  [[nodiscard]] const std::vector<ImageResource>& images() const { return images_; }
  [[nodiscard]] const std::vector<BufferResource>& buffers() const { return buffers_; }
  // By value, as the next image may move all others.
  [[nodiscard]] gpu::ImageDesc desc(GraphImage image) const { return images_[image.index].desc; }

 private:
  friend class Pass;
  std::deque<Pass> passes_;
  std::vector<ImageResource> images_;
  std::vector<BufferResource> buffers_;
};

class Pass {
 public:
  Pass(Graph& graph, std::string_view name) : graph_(graph), name_(name) {}

  // Throws Error(internal) where the handle is not the newest version or was never written.
  Pass& read(GraphImage image, Access access);
  Pass& read(GraphBuffer buffer, Access access);
  // The contents from before are kept unless this is the first write. Returns the handle for later passes.
  // Throws Error(internal) for a stale handle, an access that only reads, and a second resource of the same full name.
  [[nodiscard]] GraphImage write(GraphImage image, Access access);
  [[nodiscard]] GraphBuffer write(GraphBuffer buffer, Access access);
  // What the pass records. Called once, when the graph is executed.
  void run(std::function<void(Context&)> record) { record_ = std::move(record); }

  struct Use {
    std::uint32_t index;
    Access access;
    bool write;
  };
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<Use>& image_uses() const { return image_uses_; }
  [[nodiscard]] const std::vector<Use>& buffer_uses() const { return buffer_uses_; }
  [[nodiscard]] const std::function<void(Context&)>& record() const { return record_; }

 private:
  Graph& graph_;
  std::string name_;
  std::vector<Use> image_uses_, buffer_uses_;
  std::function<void(Context&)> record_;
};

}  // namespace velarium::graph
