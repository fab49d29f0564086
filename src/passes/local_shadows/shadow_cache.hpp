#pragma once

// Maps that stay from picture to picture, for loops that must be quick: only so many are drawn for each.

#include "passes/local_shadows/plan.hpp"

#include <cstdint>
#include <vector>

namespace velarium::local_shadows {

// What a map shows, in a number: bounds and meshes of the casters it sees. Vertices that move within equal bounds are
// not noticed. translucent: do such casters count?
[[nodiscard]] std::uint64_t fingerprint(const View& view, const glm::dvec3& origin, const upload::CasterTable& casters,
                                        bool translucent);

class ShadowCache {
 public:
  // Places of the views in the atlas. At most `updates` of them are drawn: first those that must make room, then those
  // that have no map yet, from the most important light on, then the oldest of those whose casters moved or whose size
  // is no longer right. A view without a map has no place: its light shines through until its turn comes.
  // fingerprints: one a view. The maps of before are what earlier calls said; forget() where that is no longer so.
  [[nodiscard]] std::vector<PlacedView> place(const std::vector<View>& views,
                                              const std::vector<std::uint64_t>& fingerprints, const glm::dvec3& origin,
                                              const Settings& settings, std::uint32_t updates);
  void forget() { *this = ShadowCache(); }

 private:
  struct Kept {
    View view;  // as it was drawn, but for its place: that is relative to another origin
    glm::dvec3 position_ws{0.0};
    Tile tile;
    std::uint64_t fingerprint = 0, drawn = 0;  // drawn: the picture
  };
  struct Update {
    std::size_t view;
    std::size_t kept;  // kNone: there is no map
    int rank;          // less is sooner
    double urgency;    // among equals more is sooner
  };
  static constexpr std::size_t kNone = ~std::size_t{0};

  void drop_unwanted(const std::vector<View>& views, const glm::dvec3& origin);
  [[nodiscard]] std::size_t find(const View& view, const glm::dvec3& origin) const;
  [[nodiscard]] std::vector<std::uint32_t> sizes(const std::vector<View>& views, const glm::dvec3& origin,
                                                 const Settings& settings) const;
  [[nodiscard]] std::vector<Update> updates_of(const std::vector<View>& views,
                                               const std::vector<std::uint64_t>& fingerprints,
                                               const std::vector<std::uint32_t>& sizes, const glm::dvec3& origin) const;
  // False where there is no room.
  bool move(Kept& kept, std::uint32_t size);

  AtlasAllocator allocator_{1};
  std::uint32_t side_ = 0;
  std::vector<Kept> kept_;
  std::uint64_t picture_ = 0;
};

}  // namespace velarium::local_shadows
