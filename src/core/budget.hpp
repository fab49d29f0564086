#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace velarium {

// How much of something may be used, by one row of the group `load` of the options, and how much is used already.
class Budget {
 public:
  // `option` is the row's key ("load.nodes"), and stays where it is.
  Budget(std::string_view option, std::uint64_t limit) : option_(option), limit_(limit) {}

  [[nodiscard]] std::uint64_t left() const { return limit_ - used_; }
  [[nodiscard]] bool fits(std::uint64_t amount) const { return amount <= left(); }
  // Precondition: it fits.
  void spend(std::uint64_t amount) { used_ += amount; }

  // The end of a sentence about an amount that does not fit: how much it makes in all, what the limit is, and how to
  // raise it: "5 nodes, more than load.nodes=4 allows; -D load.nodes=5 allows it".
  [[nodiscard]] std::string refusal(std::uint64_t amount) const;

 private:
  std::string_view option_;
  std::uint64_t limit_, used_ = 0;
};

}  // namespace velarium
