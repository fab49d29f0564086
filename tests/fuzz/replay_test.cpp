// Every input that once was a finding, and every seed, through its target in the ordinary build.

#include "targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace velarium::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Replay : public testing::TestWithParam<Target> {
 protected:
  static void run_all(const fs::path& folder) {
    // A sanitizer's build is some ten times slower than the one that users wait for.
    constexpr std::chrono::seconds kPatience(5);
    for (const fs::path& file : files_of(folder)) {
      SCOPED_TRACE(file.string());
      std::ifstream in(file, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      const auto start = std::chrono::steady_clock::now();
      EXPECT_NO_THROW(GetParam().run(std::as_bytes(std::span(text))));
      EXPECT_LT(std::chrono::steady_clock::now() - start, kPatience);
    }
  }
};

TEST_P(Replay, RegressionsEndInOrder) {
  run_all(fs::path(VELARIUM_FUZZ_DATA) / "regressions" / GetParam().name);
}

TEST_P(Replay, SeedsEndInOrder) {
  const fs::path folder = fs::path(VELARIUM_FUZZ_SEEDS) / GetParam().name;
  ASSERT_FALSE(files_of(folder).empty()) << "no seeds in " << folder;
  run_all(folder);
}

TEST_P(Replay, NothingAtAllIsRead) {
  EXPECT_NO_THROW(GetParam().run({}));
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(kTargets),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace velarium::fuzz
