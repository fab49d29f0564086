#include "gpu/pipeline_library.hpp"

namespace velarium::gpu {
namespace {

// FNV-1a, by words.
class Hash {
 public:
  Hash& add(std::uint64_t value) {
    hash_ = (hash_ ^ value) * 0x100000001b3u;
    return *this;
  }
  Hash& add(const void* address) { return add(reinterpret_cast<std::uintptr_t>(address)); }
  Hash& add(const Specialization& constants) {
    for (const auto& entry : constants.entries()) add(std::uint64_t{entry.id} << 32u | entry.bits);
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

// Of what tells pipelines of one pass apart most often; equal states have equal hashes.
std::uint64_t hash_of(Spirv vertex, Spirv fragment, const RasterState& state) {
  Hash hash;
  hash.add(vertex.data()).add(fragment.data()).add(state.fragment_constants);
  hash.add(state.topology).add(state.depth_format).add(state.vertex_attributes.size());
  for (const auto format : state.color_formats) hash.add(format);
  return hash.value();
}

}  // namespace

const Pipeline& PipelineLibrary::compute(Spirv shader, const Specialization& constants) {
  const std::uint64_t hash = Hash().add(shader.data()).add(constants).value();
  const auto [first, end] = compute_by_hash_.equal_range(hash);
  for (auto known = first; known != end; ++known)
    if (known->second->shader == shader.data() && known->second->constants == constants) return known->second->pipeline;
  const auto& made = compute_.emplace_back(
      Compute{shader.data(), constants, Pipeline::compute(device_, samplers_, shader, constants)});
  compute_by_hash_.emplace(hash, &made);
  return made.pipeline;
}

const Pipeline& PipelineLibrary::raster(Spirv vertex, Spirv fragment, const RasterState& state) {
  const std::uint64_t hash = hash_of(vertex, fragment, state);
  const auto [first, end] = raster_by_hash_.equal_range(hash);
  for (auto known = first; known != end; ++known) {
    const Raster& raster = *known->second;
    if (raster.vertex == vertex.data() && raster.fragment == fragment.data() && raster.state == state)
      return raster.pipeline;
  }
  const auto& made = raster_.emplace_back(
      Raster{vertex.data(), fragment.data(), state, Pipeline::raster(device_, samplers_, vertex, fragment, state)});
  raster_by_hash_.emplace(hash, &made);
  return made.pipeline;
}

}  // namespace velarium::gpu
