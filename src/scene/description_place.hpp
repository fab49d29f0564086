#pragma once

// Where a value is in a SceneDescription, and the checks that name that place.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace velarium::scene::description {

// One element of a table, as in "meshes[2]". Members are named as the program writes them: "material", "indices[7]".
class Place {
 public:
  Place(std::string_view table, std::size_t index) : table_(table), index_(index) {}

  // Throws Error(usage): "scene description: TABLE[INDEX].MEMBER REASON".
  [[noreturn]] void fail(std::string_view member, std::string_view reason) const;

  void finite(std::string_view member, float value) const;
  void between(std::string_view member, float value, float least, float most) const;  // both allowed
  void not_negative(std::string_view member, float value) const;
  // More than `above` and less than `below`.
  void within(std::string_view member, float value, float above, float below) const;

  template <std::size_t N>
  void finite(std::string_view member, const std::array<float, N>& values) const {
    for (const float value : values) finite(member, value);
  }
  template <std::size_t N>
  void between(std::string_view member, const std::array<float, N>& values, float least, float most) const {
    for (const float value : values) between(member, value, least, most);
  }
  template <std::size_t N>
  void not_negative(std::string_view member, const std::array<float, N>& values) const {
    for (const float value : values) not_negative(member, value);
  }

  // The same of long lists, whose elements are named only where one is at fault.
  template <std::size_t N>
  void all_finite(std::string_view member, const std::vector<std::array<float, N>>& list) const {
    for (std::size_t i = 0; i < list.size(); ++i)
      for (const float value : list[i])
        if (!std::isfinite(value)) finite(element(member, i), value);
  }

  // As the scene's tables hold it. `count` is the size of `table`, which it has to lead into.
  [[nodiscard]] std::int32_t reference(std::string_view member, std::optional<std::uint32_t> index, std::size_t count,
                                       std::string_view table) const;

  [[nodiscard]] static std::string element(std::string_view list, std::size_t index);

 private:
  std::string_view table_;
  std::size_t index_;
};

}  // namespace velarium::scene::description
