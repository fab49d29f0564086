#include "scene/choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace velarium::scene {

std::optional<std::size_t> find_choice(std::span<const std::string> names, const std::string& choice) {
  const auto named = std::find(names.begin(), names.end(), choice);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  std::size_t index = 0;
  const char* const end = choice.data() + choice.size();
  const auto [stop, error] = std::from_chars(choice.data(), end, index);
  if (error != std::errc{} || stop != end || index >= names.size()) return std::nullopt;
  return index;
}

std::string unknown_choice(const std::string& kind, std::span<const std::string> names, const std::string& choice,
                           const std::string& always) {
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) known += fmt::format("{} \"{}\", ", i, names[i]);
  return fmt::format("no {} \"{}\"; there are: {}{}", kind, choice, known, always);
}

}  // namespace velarium::scene
