#include "core/jobs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace velarium {
namespace {

TEST(Jobs, EveryIndexIsVisitedOnce) {
  for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
    std::vector<std::atomic<int>> visits(count);
    parallel_for(count, [&](std::size_t i) { ++visits[i]; });
    for (const auto& visit : visits) EXPECT_EQ(visit, 1);
  }
}

TEST(Jobs, NestedCallsFinish) {
  std::atomic<int> sum{0};
  parallel_for(
      16, [&](std::size_t) { parallel_for(16, [&](std::size_t) { parallel_for(4, [&](std::size_t) { ++sum; }); }); });
  EXPECT_EQ(sum, 16 * 16 * 4);
}

TEST(Jobs, CallsFromSeveralThreadsFinish) {
  std::atomic<int> sum{0};
  std::vector<std::thread> callers;
  for (int caller = 0; caller < 8; ++caller) {
    callers.emplace_back([&] { parallel_for(1000, [&](std::size_t) { ++sum; }); });
  }
  for (auto& caller : callers) caller.join();
  EXPECT_EQ(sum, 8000);
}

TEST(Jobs, AnExceptionArrivesAndSkipsTheRest) {
  std::atomic<int> visits{0};
  const auto throwing = [&](std::size_t i) {
    ++visits;
    if (i == 0) throw std::runtime_error("first");
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  };
  EXPECT_THROW(parallel_for(100'000, throwing), std::runtime_error);
  EXPECT_LT(visits, 100'000);
  EXPECT_THROW(parallel_for(1, throwing), std::runtime_error);
}

}  // namespace
}  // namespace velarium
