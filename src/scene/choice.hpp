#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace velarium::scene {

// The position that `choice` names: the first equal name, else the number it spells. Nothing where neither fits.
[[nodiscard]] std::optional<std::size_t> find_choice(std::span<const std::string> names, const std::string& choice);

// `no camera "x"; there are: 0 "front", 1 "back", auto`, the sentence of an error. `kind`: "camera".
[[nodiscard]] std::string unknown_choice(const std::string& kind, std::span<const std::string> names,
                                         const std::string& choice, const std::string& always);

}  // namespace velarium::scene
