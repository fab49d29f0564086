#include <velarium/options.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace velarium {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other
// (optimal string alignment: Damerau, "A technique for computer detection and correction of spelling errors", 1964).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row.back();
}

// To the whole name, or to what follows its last dot where the word has no dot: "exposure" means "display.exposure".
std::size_t distance_to_name(const std::string& word, const std::string& name) {
  const std::size_t whole = edit_distance(word, name);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || word.find('.') != std::string::npos) return whole;
  return std::min(whole, edit_distance(word, name.substr(dot + 1)));
}

}  // namespace

std::string nearest_name(std::string_view word, std::span<const std::string> known) {
  const std::string wanted = lower_case(word);
  // One slip in three letters is a typing error; more is another word.
  std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::string nearest;
  for (const std::string& name : known) {
    const std::size_t distance = distance_to_name(wanted, lower_case(name));
    if (distance >= best) continue;
    best = distance;
    nearest = name;
  }
  return nearest;
}

}  // namespace velarium
