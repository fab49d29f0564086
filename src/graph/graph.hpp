#pragma once

#include "gpu/barrier.hpp"
#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "graph/access.hpp"
#include "graph/history.hpp"

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

// One version of an image, or of one mip of it: each write makes a new one, and a read of what was overwritten since is
// refused when it is declared.
struct GraphImage {
  std::uint32_t index = 0, version = 0;  // version 0: null, or not written yet
  std::uint32_t mip = gpu::kAllMips;     // the one that is meant, or all
  // The same version of the same image, one mip of it or the whole.
  [[nodiscard]] GraphImage at(std::uint32_t one_mip) const { return {index, version, one_mip}; }
  [[nodiscard]] GraphImage whole() const { return {index, version, gpu::kAllMips}; }
  // The mip to store to or to draw to: the one that is meant, of a whole image its first.
  [[nodiscard]] std::uint32_t target_mip() const { return mip == gpu::kAllMips ? 0 : mip; }
  bool operator==(const GraphImage&) const = default;
};

struct GraphBuffer {
  std::uint32_t index = 0, version = 0;
  bool operator==(const GraphBuffer&) const = default;
};

// What history() gives.
struct History {
  GraphImage previous;        // what the frame before wrote, to be sampled or copied; zero where there was none
  GraphImage current;         // what this frame must write, whole
  bool has_contents = false;  // of `previous`
};

// Passes and what they use, in the order in which they run. The graph reorders nothing: barriers (plan.hpp),
// allocation, labels and times (executor.hpp) follow from what is declared. A graph describes one frame.
//
//   auto& pass = graph.pass("ssdo");
//   pass.read(depth, Access::compute_sample);
//   const auto bent = pass.write(graph.image("bent_normal", desc), Access::compute_storage);
//   pass.run([=](Context& c) { ... });
//
// A chain of mips is written mip by mip, and each names what it means:
//
//   mips = pass.write(mips.at(i), Access::compute_storage);     // while .read(mips.at(i - 1), Access::compute_sample)
//   later.read(mips.whole(), Access::compute_sample);
class Graph {
 public:
  // `history`: of the executor that is to run the graph (Executor::history()). Without it, history() is refused.
  explicit Graph(HistoryStore* history = nullptr) : history_(history) {}
  Graph(const Graph&) = delete;  // passes refer to their graph
  Graph& operator=(const Graph&) = delete;

  // An image that lives for the frame. Its full name, for labels and --dump, is "pass.name" of the first writer.
  [[nodiscard]] GraphImage image(std::string_view name, const gpu::ImageDesc& desc);
  // An image that outlives the frame, with contents from before if `initialized` (in any layout the graph left).
  [[nodiscard]] GraphImage import(std::string_view name, gpu::Image& image, bool initialized);
  [[nodiscard]] GraphBuffer buffer(std::string_view name, VkDeviceSize bytes,
                                   gpu::MemoryUse use = gpu::MemoryUse::device);
  // A buffer that outlives the frame, with contents from before if `initialized`.
  // Precondition: it was made for every use that passes declare.
  [[nodiscard]] GraphBuffer import(std::string_view name, gpu::Buffer& buffer, bool initialized);
  // A table that the host writes: a storage buffer with these bytes, there before the first pass. Shaders may read it
  // in any pass without a declaration, as no pass writes it. `name` is its full name ("environment.table"). Throws
  // Error(internal) for a second buffer of that name.
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
  // An image that the next frame reads. `name` is its full name ("taa.color"); what this frame reads is
  // "name.previous". There is no frame before for a new name, for another `desc` than before and after
  // Executor::forget_history(). A graph that declares a history must write it, or its plan is refused; one that does
  // not leaves it as it is. Throws Error(internal) without the executor's history, and for a second history of the same
  // name.
  [[nodiscard]] History history(std::string_view name, const gpu::ImageDesc& desc);

  // Declares the next pass. Its name is the label, the row in --timings, and the first half of --dump names.
  Pass& pass(std::string_view name);

  // While it lives, full names of what is declared begin with its own and a slash: "face+x/gbuffer.depth".
  class [[nodiscard]] Scope {
   public:
    Scope(Graph& graph, std::string_view name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Graph& graph_;
    std::size_t outer_length_;
  };
  // So that the same frame can be declared several times, once in a scope. Scopes nest; an empty name changes nothing.
  Scope scope(std::string_view name) { return {*this, name}; }

  struct ImageResource {
    std::string name;
    bool has_full_name = false;  // else the first writer gives it
    gpu::ImageDesc desc;
    VkImageUsageFlags usage = 0;
    gpu::Image* imported = nullptr;  // or of a history
    bool is_previous = false;        // of a history
    std::uint32_t version = 0;
    std::vector<std::uint32_t> mip_versions;  // which version wrote each mip last, 0 none
  };
  struct BufferResource {
    std::string name;
    bool has_full_name = false;
    VkDeviceSize bytes = 0;
    gpu::MemoryUse use = gpu::MemoryUse::device;
    VkBufferUsageFlags usage = 0;
    gpu::Buffer* imported = nullptr;
    std::uint32_t version = 0;
    std::vector<std::byte> contents;  // of an upload
  };
  struct HistoryResource {
    std::string name;
    std::uint32_t previous = 0, current = 0;  // images
    bool has_contents = false;
    std::uint64_t state = 0;  // of the pair, when it was declared
  };
  [[nodiscard]] const std::deque<Pass>& passes() const { return passes_; }
  [[nodiscard]] const std::vector<ImageResource>& images() const { return images_; }
  [[nodiscard]] const std::vector<BufferResource>& buffers() const { return buffers_; }
  [[nodiscard]] const std::vector<HistoryResource>& histories() const { return histories_; }
  // Of the whole image. By value, as the next image may move all others.
  [[nodiscard]] gpu::ImageDesc desc(GraphImage image) const { return images_[image.index].desc; }

 private:
  friend class Pass;
  GraphImage add(ImageResource resource);

  HistoryStore* history_;
  std::string prefix_;  // of the scopes
  std::deque<Pass> passes_;
  std::vector<ImageResource> images_;
  std::vector<BufferResource> buffers_;
  std::vector<HistoryResource> histories_;
};

class Pass {
 public:
  Pass(Graph& graph, std::string name) : graph_(graph), name_(std::move(name)) {}

  // Throws Error(internal) where what the handle names was overwritten since or never written, and where the access
  // does not fit it: a mip that is not there, all mips at once or a 3-D image as a target, the frame before otherwise
  // than sampled or copied.
  Pass& read(GraphImage image, Access access);
  Pass& read(GraphBuffer buffer, Access access);
  // The contents from before are kept unless this is the first write. Returns the handle for later passes.
  // Throws Error(internal) as read() does (but a first write needs no contents), for an access that only reads, for the
  // frame before, and for a second resource of the same full name.
  [[nodiscard]] GraphImage write(GraphImage image, Access access);
  [[nodiscard]] GraphBuffer write(GraphBuffer buffer, Access access);
  // What the pass records. Called once, when the graph is executed.
  void run(std::function<void(Context&)> record) { record_ = std::move(record); }

  struct Use {
    std::uint32_t index;
    Access access;
    bool write;
    std::uint32_t mip = gpu::kAllMips;
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

// The mips that `mip` means in an image of so many: from `first`, `count` of them.
[[nodiscard]] constexpr gpu::MipRange mips_of(std::uint32_t mip, std::uint32_t mips) {
  return mip == gpu::kAllMips ? gpu::MipRange{0, mips} : gpu::MipRange{mip, 1};
}

}  // namespace velarium::graph
