// JPEG and WebP.

#include "helpers.hpp"

#include <turbojpeg.h>

#include <cmath>

namespace velarium::image {
namespace {

using Jpeg = InFolder;
using Webp = InFolder;

double rms(const ByteImage& a, const ByteImage& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(double{a.rgba[i] * 1.0} - b.rgba[i], 2);
  return std::sqrt(sum / static_cast<double>(a.rgba.size()));
}

ByteImage smooth(std::uint32_t size) {
  ByteImage image = test_bytes(size, size, true);
  for (std::size_t i = 2; i < image.rgba.size(); i += 4) image.rgba[i] = 90;
  return image;
}

std::string cmyk_jpeg(std::array<unsigned char, 4> ink) {
  std::vector<unsigned char> pixels;
  for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), ink.begin(), ink.end());
  tjhandle handle = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(handle, pixels.data(), 8, 0, 8, TJPF_CMYK, &data, &size, TJSAMP_444, 100, 0), 0);
  std::string file(reinterpret_cast<char*>(data), size);
  tjFree(data);
  tjDestroy(handle);
  return file;
}

TEST_F(Jpeg, ComesBackNearly) {
  const ByteImage image = smooth(64);
  save_jpeg(folder_ / "a.jpg", image, 100);
  const std::string good = text_of(folder_ / "a.jpg");
  EXPECT_LT(rms(decode(bytes(good), "test"), image), 1.5);
  save_jpeg(folder_ / "a.jpg", image, 20);
  const std::string poor = text_of(folder_ / "a.jpg");
  EXPECT_LT(poor.size(), good.size());
  EXPECT_GT(rms(decode(bytes(poor), "test"), image), rms(decode(bytes(good), "test"), image));
  EXPECT_EQ(peek_size(bytes(poor), "test").width, 64u);
}

TEST_F(Jpeg, FourInksAreRead) {
  // Inverted inks: 255 is none. Half of the cyan ink and a fifth of the black one: red is 128 * 204 / 255 = 102.
  const ByteImage image = decode(bytes(cmyk_jpeg({128, 255, 255, 204})), "test");
  EXPECT_NEAR(image.rgba[0], 102, 2);
  EXPECT_NEAR(image.rgba[1], 204, 2);
  EXPECT_NEAR(image.rgba[2], 204, 2);
  EXPECT_EQ(image.rgba[3], 255);
}

TEST_F(Jpeg, DamageIsRefused) {
  save_jpeg(folder_ / "a.jpg", smooth(64), 80);
  const std::string file = text_of(folder_ / "a.jpg");
  const auto read = [](std::string_view data) { (void)decode(bytes(data), "test"); };
  // The last two bytes only say that the picture has ended.
  expect_every_truncation_refused(file.substr(0, file.size() - 2), read);
  expect_no_crash_on_damage(file, read);
}

TEST_F(Jpeg, HugeHeadersAreRefusedBeforeAllocation) {
  save_jpeg(folder_ / "a.jpg", smooth(64), 80);
  std::string file = text_of(folder_ / "a.jpg");
  const std::size_t frame = file.find("\xff\xc0");  // SOF0: marker, length, depth, height, width
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = 5; i < 9; ++i) file[frame + i] = '\x7f';
  EXPECT_EQ(peek_size(bytes(file), "test").width, 0x7f7fu);
  expect_refused(ErrorCode::input_invalid, [&] { (void)decode(bytes(file), "test"); });
}

TEST_F(Webp, LosslessComesBackExactly) {
  const ByteImage image = test_bytes(37, 23, false);
  save_webp(folder_ / "a.webp", image, 100);
  const std::string file = text_of(folder_ / "a.webp");
  EXPECT_EQ(decode(bytes(file), "test").rgba, image.rgba);
  EXPECT_EQ(peek_size(bytes(file), "test").height, 23u);
}

TEST_F(Webp, LossyComesBackNearly) {
  const ByteImage image = smooth(64);
  save_webp(folder_ / "a.webp", image, 90);
  EXPECT_LT(rms(decode(bytes(text_of(folder_ / "a.webp")), "test"), image), 3.0);
}

TEST_F(Webp, DamageIsRefused) {
  save_webp(folder_ / "a.webp", test_bytes(37, 23, false), 100);
  const std::string file = text_of(folder_ / "a.webp");
  const auto read = [](std::string_view data) { (void)decode(bytes(data), "test"); };
  expect_every_truncation_refused(file, read);
  expect_no_crash_on_damage(file, read);
}

TEST_F(Webp, PicturesTooLargeForTheFormatAreReported) {
  expect_refused(ErrorCode::output_not_written, [&] { save_webp(folder_ / "a.webp", test_bytes(16384, 1, true), 80); });
  EXPECT_FALSE(fs::exists(folder_ / "a.webp"));
}

}  // namespace
}  // namespace velarium::image
