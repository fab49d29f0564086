#include "core/budget.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace velarium {
namespace {

TEST(Budget, TellsWhatIsNeededInAllAndHowToAllowIt) {
  Budget budget("load.nodes", 5);
  budget.spend(3);
  EXPECT_EQ(budget.left(), 2u);
  EXPECT_TRUE(budget.fits(2));
  EXPECT_FALSE(budget.fits(3));
  EXPECT_EQ(budget.refusal(3), "6 nodes, more than load.nodes=5 allows; -D load.nodes=6 allows it");
}

TEST(Budget, AdvisesNothingThatTheOptionsRefuse) {
  const Budget budget("load.depth", 256);
  EXPECT_EQ(budget.refusal(4096), "4096 levels, more than load.depth=256 allows; -D load.depth=4096 allows it");
  EXPECT_EQ(budget.refusal(4097), "4097 levels, more than load.depth=256 allows; load.depth cannot be more than 4096");
}

TEST(Budget, SumsDoNotWrapAround) {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  Budget budget("load.bytes", 100);
  budget.spend(100);
  EXPECT_FALSE(budget.fits(kLargest));
  EXPECT_TRUE(budget.refusal(kLargest).starts_with("18446744073709551615 bytes"));
}

}  // namespace
}  // namespace velarium
