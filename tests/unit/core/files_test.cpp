#include "core/files.hpp"
#include "support/temporary_folder.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <string>

namespace velarium {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}

std::string text_of(const fs::path& file) {
  const auto data = read_file(file, 1 << 20);
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

class Files : public testing::Test {
 protected:
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  template <class Call>
  static ErrorCode code_of(Call call) {
    try {
      call();
    } catch (const Error& error) { return error.code(); }
    return ErrorCode::internal;
  }

  test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(Files, WhatIsWrittenIsReadAndNothingElseRemains) {
  write_file(folder_ / "a", bytes("first"));
  write_file(folder_ / "a", bytes("second"));
  write_file(folder_ / "empty", bytes(""));
  EXPECT_EQ(text_of(folder_ / "a"), "second");
  EXPECT_EQ(text_of(folder_ / "empty"), "");
  EXPECT_EQ(entries(), 2u);
}

TEST_F(Files, ReadingRefusesWhatIsMissingAFolderOrTooLarge) {
  write_file(folder_ / "a", bytes("12345"));
  EXPECT_EQ(code_of([&] { (void)read_file(folder_ / "none", 10); }), ErrorCode::input_missing);
  EXPECT_EQ(code_of([&] { (void)read_file(folder_, 10); }), ErrorCode::input_missing);
  EXPECT_EQ(code_of([&] { (void)read_file(folder_ / "a", 4); }), ErrorCode::input_invalid);
  EXPECT_EQ(code_of([&] { (void)read_file(folder_ / "a", Budget("load.bytes", 4)); }), ErrorCode::input_invalid);
  EXPECT_EQ(read_file(folder_ / "a", Budget("load.bytes", 5)).size(), 5u);
  EXPECT_EQ(read_file(folder_ / "a", 5).size(), 5u);
}

TEST_F(Files, ReadingTakesPipes) {
  const std::string content(200'000, 'x');  // more than a pipe holds
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const pid_t writer = ::fork();
  if (writer == 0) {
    std::ofstream(pipe) << content;
    ::_exit(0);
  }
  EXPECT_EQ(read_file(pipe, 1 << 20).size(), content.size());
}

TEST_F(Files, WritingRefusesFoldersAndMissingFolders) {
  EXPECT_EQ(code_of([&] { write_file(folder_, bytes("x")); }), ErrorCode::output_not_written);
  EXPECT_EQ(code_of([&] { write_file(folder_ / "none" / "a", bytes("x")); }), ErrorCode::output_not_written);
  EXPECT_EQ(code_of([&] { write_file("", bytes("x")); }), ErrorCode::output_not_written);
  EXPECT_EQ(code_of([&] { check_writable(folder_ / "none" / "a"); }), ErrorCode::output_not_written);
  check_writable(folder_ / "a");
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Files, AWriteThatFailsHalfwayLeavesTheOldFile) {
  write_file(folder_ / "a", bytes("old"));
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{1024, limit.rlim_max};
  const auto old_action = std::signal(SIGXFSZ, SIG_IGN);  // so that the write fails instead
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_EQ(code_of([&] { write_file(folder_ / "a", bytes(std::string(4096, 'x'))); }), ErrorCode::output_not_written);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, old_action);
  EXPECT_EQ(text_of(folder_ / "a"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AFullDeviceIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(code_of([&] { write_file("/dev/full", bytes("x")); }), ErrorCode::output_not_written);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Files, ALinkIsFollowedAndStays) {
  write_file(folder_ / "target", bytes("old"));
  fs::create_symlink("target", folder_ / "link");
  write_file(folder_ / "link", bytes("new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(text_of(folder_ / "target"), "new");
}

TEST_F(Files, TheCacheFollowsTheEnvironment) {
  ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
  EXPECT_EQ(cache_directory(), "/somewhere/velarium");
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  ::setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(cache_directory(), "/home/somebody/.cache/velarium");
  ::unsetenv("XDG_CACHE_HOME");
  ::unsetenv("HOME");
  EXPECT_TRUE(cache_directory().empty());
}

// Values of the authors' test suite: Fowler, Noll, Vo and Eastlake, "The FNV Non-Cryptographic Hash Algorithm".
TEST(ContentHash, IsFnv1a) {
  EXPECT_EQ(content_hash(bytes("")), 0xcbf29ce484222325ull);
  EXPECT_EQ(content_hash(bytes("a")), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(content_hash(bytes("foobar")), 0x85944171f73967e8ull);
  EXPECT_EQ(content_hash(bytes("bar"), content_hash(bytes("foo"))), content_hash(bytes("foobar")));
}

}  // namespace
}  // namespace velarium
