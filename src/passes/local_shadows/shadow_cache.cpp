#include "passes/local_shadows/shadow_cache.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace velarium::local_shadows {
namespace {

// A size stays until the wanted one differs by this many octaves: maps that change their size show it.
constexpr double kHysteresis = 0.6;

// Places are relative to an origin that moves, and rounded there.
constexpr double kSame = 1e-4;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  return (hash ^ value) * 0x100000001b3u;  // FNV-1a, by words
}

bool same_view(const View& a, const glm::dvec3& a_position, const View& b, const glm::dvec3& b_position) {
  return a.light == b.light && a.face == b.face && a.kernel == b.kernel &&
         glm::length(a_position - b_position) <= kSame * a.reach && glm::length(a.axes[2] - b.axes[2]) <= kSame &&
         std::abs(a.half_tangent - b.half_tangent) <= kSame * a.half_tangent;
}

}  // namespace

std::uint64_t fingerprint(const View& view, const glm::dvec3& origin, const upload::CasterTable& casters,
                          bool translucent) {
  std::vector<glm::dvec4> planes;
  const double tangent = view.half_tangent + static_cast<double>(view.kernel);
  for (const auto& side : pyramid_solid(view.position + origin, view.axes, tangent, view.reach))
    planes.push_back(side.plane);
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const auto& caster : casters.casters) {
    if (caster.kind == upload::CasterKind::translucent && !translucent) continue;
    if (!upload::overlaps(planes, caster.bounds)) continue;
    hash = mixed(mixed(hash, caster.draw.primitive), caster.draw.material);
    for (int axis = 0; axis < 3; ++axis)
      hash = mixed(mixed(hash, std::bit_cast<std::uint64_t>(caster.bounds.min[axis])),
                   std::bit_cast<std::uint64_t>(caster.bounds.max[axis]));
  }
  return hash;
}

std::size_t ShadowCache::find(const View& view, const glm::dvec3& origin) const {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return same_view(view, view.position + origin, kept.view, kept.position_ws);
  });
  return found == kept_.end() ? kNone : static_cast<std::size_t>(found - kept_.begin());
}

void ShadowCache::drop_unwanted(const std::vector<View>& views, const glm::dvec3& origin) {
  std::vector<bool> wanted(kept_.size());
  for (const auto& view : views)
    if (const std::size_t at = find(view, origin); at != kNone) wanted[at] = true;
  std::vector<Kept> left;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (wanted[i])
      left.push_back(kept_[i]);
    else
      allocator_.free(kept_[i].tile);
  }
  kept_ = std::move(left);
}

std::vector<std::uint32_t> ShadowCache::sizes(const std::vector<View>& views, const glm::dvec3& origin,
                                              const Settings& settings) const {
  std::vector<WantedTile> wanted;
  for (const auto& view : views) {
    std::uint32_t size = wanted_size(view, settings);
    const std::size_t at = find(view, origin);
    const auto octave = static_cast<double>(
        shading::wanted_tile_octave(static_cast<float>(view.pixels), static_cast<float>(settings.density)));
    if (at != kNone && std::abs(octave - std::log2(kept_[at].tile.size)) < kHysteresis) size = kept_[at].tile.size;
    wanted.push_back({view.light, size, view.importance});
  }
  return fitting_sizes(wanted, side_, kSmallestTile);
}

std::vector<ShadowCache::Update> ShadowCache::updates_of(const std::vector<View>& views,
                                                         const std::vector<std::uint64_t>& fingerprints,
                                                         const std::vector<std::uint32_t>& sizes,
                                                         const glm::dvec3& origin) const {
  std::vector<Update> updates;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t at = find(views[i], origin);
    if (at == kNone) {
      if (sizes[i] > 0) updates.push_back({i, kNone, 1, views[i].importance});
      continue;
    }
    const Kept& kept = kept_[at];
    const double age = static_cast<double>(picture_ - kept.drawn);
    if (sizes[i] < kept.tile.size)
      updates.push_back({i, at, 0, age});
    else if (sizes[i] != kept.tile.size || fingerprints[i] != kept.fingerprint)
      updates.push_back({i, at, 2, age});
  }
  std::stable_sort(updates.begin(), updates.end(), [](const Update& a, const Update& b) {
    return a.rank < b.rank || (a.rank == b.rank && a.urgency > b.urgency);
  });
  return updates;
}

bool ShadowCache::move(Kept& kept, std::uint32_t size) {
  const std::uint32_t old = kept.tile.size;
  if (old != 0) allocator_.free(kept.tile);
  auto tile = allocator_.allocate(size);
  if (!tile && old != 0) tile = allocator_.allocate(old);
  if (tile) kept.tile = *tile;
  return tile.has_value();
}

std::vector<PlacedView> ShadowCache::place(const std::vector<View>& views,
                                           const std::vector<std::uint64_t>& fingerprints, const glm::dvec3& origin,
                                           const Settings& settings, std::uint32_t updates) {
  if (side_ != atlas_side(settings)) {
    forget();
    side_ = atlas_side(settings);
    allocator_ = AtlasAllocator(side_);
  }
  ++picture_;
  drop_unwanted(views, origin);
  const auto sizes = this->sizes(views, origin, settings);
  std::vector<bool> redraw(views.size());
  for (const auto& [view, at, rank, urgency] : updates_of(views, fingerprints, sizes, origin)) {
    if (updates == 0) break;
    // What lost its place to more important lights keeps its map until it is in their way.
    if (sizes[view] == 0) {
      allocator_.free(kept_[at].tile);
      kept_[at].tile.size = 0;
      continue;
    }
    Kept fresh;
    Kept& kept = at == kNone ? fresh : kept_[at];
    if (!move(kept, sizes[view])) continue;
    kept = {views[view], views[view].position + origin, kept.tile, fingerprints[view], picture_};
    if (at == kNone) kept_.push_back(fresh);
    redraw[view] = true;
    --updates;
  }
  std::erase_if(kept_, [](const Kept& kept) { return kept.tile.size == 0; });
  std::vector<PlacedView> placed(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    placed[i].view = views[i];
    const std::size_t at = find(views[i], origin);
    if (at == kNone) continue;
    placed[i] = {kept_[at].view, kept_[at].tile, redraw[i]};
    placed[i].view.position = views[i].position;
  }
  return placed;
}

}  // namespace velarium::local_shadows
