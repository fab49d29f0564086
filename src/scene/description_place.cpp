#include "scene/description_place.hpp"

#include "scene/scene.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::scene::description {

void Place::fail(std::string_view member, std::string_view reason) const {
  throw Error(ErrorCode::usage, fmt::format("scene description: {}[{}].{} {}", table_, index_, member, reason));
}

void Place::finite(std::string_view member, float value) const {
  if (!std::isfinite(value)) fail(member, fmt::format("is {}, must be finite", value));
}

void Place::between(std::string_view member, float value, float least, float most) const {
  if (!(value >= least && value <= most)) fail(member, fmt::format("is {}, must be from {} to {}", value, least, most));
}

void Place::not_negative(std::string_view member, float value) const {
  finite(member, value);
  if (value < 0.0f) fail(member, fmt::format("is {}, must not be negative", value));
}

void Place::within(std::string_view member, float value, float above, float below) const {
  if (!(value > above && value < below))
    fail(member, fmt::format("is {}, must be more than {} and less than {}", value, above, below));
}

std::int32_t Place::reference(std::string_view member, std::optional<std::uint32_t> index, std::size_t count,
                              std::string_view table) const {
  if (!index) return kNone;
  if (*index >= count)
    fail(member, fmt::format("is {}, but there {} {} in {}", *index, count == 1 ? "is" : "are", count, table));
  return static_cast<std::int32_t>(*index);
}

std::string Place::element(std::string_view list, std::size_t index) {
  return fmt::format("{}[{}]", list, index);
}

}  // namespace velarium::scene::description
