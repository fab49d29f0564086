#pragma once

#include "image/image.hpp"
#include "support/temporary_folder.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace velarium::image {

namespace fs = std::filesystem;

inline std::span<const std::byte> bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// What a call throws: the code, and the message for failures to be read.
struct Thrown {
  bool any = false;
  ErrorCode code = ErrorCode::internal;
  std::string message = "nothing was thrown";
};

template <class Call>
Thrown thrown_by(Call call) {
  try {
    call();
  } catch (const Error& error) { return {true, error.code(), error.what()}; }
  return {};
}

template <class Call>
void expect_refused(ErrorCode code, Call call) {
  const Thrown thrown = thrown_by(call);
  EXPECT_TRUE(thrown.any && thrown.code == code) << thrown.message;
}

// A folder that is gone after the test.
class InFolder : public testing::Test {
 protected:
  fs::path put(const std::string& name, std::string_view content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

// Something of everything: gradients, noise, and an alpha that is not 1 where `opaque` is false.
inline ByteImage test_bytes(std::uint32_t width, std::uint32_t height, bool opaque) {
  ByteImage image{width, height, {}};
  std::uint32_t noise = 1;
  for (std::uint32_t i = 0; i < width * height; ++i) {
    noise = noise * 1664525u + 1013904223u;
    image.rgba.push_back(static_cast<std::uint8_t>(i % width * 255 / width));
    image.rgba.push_back(static_cast<std::uint8_t>(i / width * 255 / height));
    image.rgba.push_back(static_cast<std::uint8_t>(noise >> 24));
    image.rgba.push_back(opaque ? 255 : static_cast<std::uint8_t>(noise >> 16));
  }
  return image;
}

inline FloatImage test_floats(std::uint32_t width, std::uint32_t height) {
  FloatImage image{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    image.rgba.insert(image.rgba.end(),
                      {0.25f * static_cast<float>(i % 7), 1000.0f / static_cast<float>(1 + i), 0.0f, 1.0f});
  }
  return image;
}

// Every shorter version of a file must be refused, and none may crash.
template <class Read>
void expect_every_truncation_refused(const std::string& file, Read read) {
  const std::size_t step = std::max<std::size_t>(1, file.size() / 200);
  for (std::size_t size = 0; size < file.size() - 1; size += step) {
    const Thrown thrown = thrown_by([&] { read(std::string_view(file).substr(0, size)); });
    EXPECT_TRUE(thrown.any) << "cut to " << size << " of " << file.size() << " bytes";
  }
}

// Bytes changed at random must give a picture or an Error, nothing else.
template <class Read>
void expect_no_crash_on_damage(const std::string& file, Read read) {
  std::uint32_t noise = 7;
  for (int round = 0; round < 300; ++round) {
    std::string damaged = file;
    for (int change = 0; change < 3; ++change) {
      noise = noise * 1664525u + 1013904223u;
      damaged[noise % damaged.size()] = static_cast<char>(noise >> 24);
    }
    (void)thrown_by([&] { read(std::string_view(damaged)); });
  }
}

}  // namespace velarium::image
