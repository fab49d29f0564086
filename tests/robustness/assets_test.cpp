// Collected files, where VELARIUM_ASSETS names a folder of them: each becomes a picture or is refused in order.

#include "support/pictures.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

// The folder's files of these endings, in the order of their names.
std::vector<fs::path> files_of(const fs::path& folder, const std::set<fs::path>& endings) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && endings.contains(entry.path().extension())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// A picture of the scene must hold numbers and be opaque everywhere.
void expect_picture(const Picture& picture) {
  ASSERT_EQ(picture.linear.size(), std::size_t{4} * 64 * 64);
  for (std::size_t i = 0; i < picture.linear.size(); ++i) {
    ASSERT_TRUE(std::isfinite(picture.linear[i]) && picture.linear[i] >= 0.0f) << "value " << i;
    ASSERT_TRUE(i % 4 != 3 || picture.linear[i] == 1.0f) << "value " << i;
  }
}

const std::set<fs::path> kScenes{".gltf", ".glb"}, kEnvironments{".hdr", ".exr"};

// Draws the file, or says why it was refused. Anything else fails, the messages of validation layers among it.
std::optional<ErrorCode> refusal_of(const fs::path& file) {
  try {
    RenderRequest request = linear_request(64, 64);
    request.environment = "white";
    request.want_display = true;
    expect_picture(picture_of(Scene::load(file), request));
  } catch (const Error& error) {
    const auto orderly = {ErrorCode::input_missing, ErrorCode::input_invalid, ErrorCode::unsupported};
    EXPECT_EQ(std::count(orderly.begin(), orderly.end(), error.code()), 1)
        << "exit code " << static_cast<int>(error.code()) << ": " << error.what();
    return error.code();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "an exception that is no velarium::Error: " << error.what();
  }
  return std::nullopt;
}

// However it is damaged, no file keeps a user waiting longer.
constexpr std::chrono::seconds kPatience(5);

// The folder of collected files of this kind; empty where there is none.
fs::path collected(const char* kind) {
  const char* assets = std::getenv("VELARIUM_ASSETS");
  const fs::path folder = assets == nullptr ? fs::path() : fs::path(assets) / kind;
  return fs::is_directory(folder) ? folder : fs::path();
}

class Assets : public testing::TestWithParam<const char*> {};

TEST_P(Assets, AreDrawnOrNeedWhatIsNotSupported) {
  const fs::path folder = collected(GetParam());
  if (folder.empty()) GTEST_SKIP() << "VELARIUM_ASSETS names no folder with '" << GetParam() << "' in it";
  const auto files = files_of(folder, kScenes);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    // Some need, on purpose, a version or an extension that does not exist.
    EXPECT_EQ(refusal_of(file).value_or(ErrorCode::unsupported), ErrorCode::unsupported);
  }
}

INSTANTIATE_TEST_SUITE_P(Collected, Assets,
                         testing::Values("conformance", "objects", "animated", "architecture", "humans", "foliage"),
                         [](const auto& row) { return std::string(row.param); });

TEST(MalformedAssets, EndInTime) {
  const fs::path folder = collected("malformed");
  if (folder.empty()) GTEST_SKIP() << "VELARIUM_ASSETS names no folder with 'malformed' in it";
  bool any_refused = false;
  for (const fs::path& file : files_of(folder, kScenes)) {
    SCOPED_TRACE(file.string());
    const auto start = std::chrono::steady_clock::now();
    if (refusal_of(file)) any_refused = true;
    EXPECT_LT(std::chrono::steady_clock::now() - start, kPatience);
  }
  EXPECT_TRUE(any_refused);
}

TEST(CollectedEnvironments, LightAScene) {
  const fs::path folder = collected("hdri");
  if (folder.empty()) GTEST_SKIP() << "VELARIUM_ASSETS names no folder with 'hdri' in it";
  const auto files = files_of(folder, kEnvironments);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    RenderRequest request = linear_request(64, 64);
    request.environment = file.string();
    expect_picture(picture_of(Scene::load("builtin:spheres"), request));
  }
}

}  // namespace
}  // namespace velarium::test
