#include "bake/table_cache.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bake/environment_brdf.hpp"
#include "bake/normal_lengths.hpp"
#include "core/files.hpp"
#include "support/temporary_folder.hpp"

namespace velarium::bake {
namespace {

// A cache of its own for each test, and the user's setting put back afterwards.
class TableCache : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* before = std::getenv("XDG_CACHE_HOME")) before_ = before;
    setenv("XDG_CACHE_HOME", root_.c_str(), 1);
  }
  void TearDown() override {
    if (before_.empty()) {
      unsetenv("XDG_CACHE_HOME");
    } else {
      setenv("XDG_CACHE_HOME", before_.c_str(), 1);
    }
  }

  // Runs cached_table() and says whether it had to compute.
  bool computes(std::size_t count = 4) {
    bool computed = false;
    const auto table = cached_table<std::uint32_t>("numbers.bin", count, [&] {
      computed = true;
      return std::vector<std::uint32_t>(count, 7u);
    });
    EXPECT_EQ(table, std::vector<std::uint32_t>(count, 7u));
    return computed;
  }
  static std::filesystem::path stored() { return cache_directory() / "numbers.bin"; }

 private:
  test::TemporaryFolder temporary_;
  const std::filesystem::path root_ = temporary_.path();
  std::string before_;
};

TEST_F(TableCache, ComputesOnce) {
  EXPECT_TRUE(computes());
  EXPECT_FALSE(computes());
  EXPECT_EQ(std::filesystem::file_size(stored()), 4 * sizeof(std::uint32_t) + sizeof(std::uint64_t));
}

TEST_F(TableCache, AnotherLengthIsAMiss) {
  EXPECT_TRUE(computes(4));
  EXPECT_TRUE(computes(3));
  EXPECT_TRUE(computes(5));
  EXPECT_FALSE(computes(5));
}

TEST_F(TableCache, AChangedByteIsAMiss) {
  EXPECT_TRUE(computes());
  for (const int offset : {0, 15, 16, 23}) {
    std::fstream file(stored(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(offset);
    file.put('\x55');
    file.close();
    EXPECT_TRUE(computes()) << offset;
  }
  std::filesystem::resize_file(stored(), 0);
  EXPECT_TRUE(computes());
  EXPECT_FALSE(computes());
}

TEST_F(TableCache, DoesWithoutADirectory) {
  setenv("XDG_CACHE_HOME", "/dev/null/nowhere", 1);
  EXPECT_TRUE(computes());
  EXPECT_TRUE(computes());
}

TEST_F(TableCache, ADirectoryInTheFilesPlaceIsAMiss) {
  std::filesystem::create_directories(stored());
  EXPECT_TRUE(computes());
  EXPECT_TRUE(computes());
}

TEST_F(TableCache, CachedTablesAreTheComputedOnes) {
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(cached_best_fit_normal_lengths(64), best_fit_normal_lengths(64));
    EXPECT_EQ(cached_environment_brdf(8, 0), environment_brdf(8, 0));
    EXPECT_EQ(cached_environment_brdf(8, 1), environment_brdf(8, 1));
  }
}

}  // namespace
}  // namespace velarium::bake
