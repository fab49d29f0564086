#include "helpers.hpp"

#include <zlib.h>

#include <array>

namespace velarium::image {
namespace {

using Png = InFolder;

std::string big_endian(std::uint32_t value) {
  std::string text;
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(value >> shift & 0xff);
  return text;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(crc));
}

std::string deflated(const std::string& raw) {
  uLongf size = compressBound(raw.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size());
  return out.substr(0, size);
}

struct Kind {
  int depth, color, interlace = 0;
};

// `rows` with their filter bytes; `before` holds chunks that stand before the pixels.
std::string png(std::uint32_t width, std::uint32_t height, Kind kind, const std::string& rows,
                const std::string& before = "") {
  std::string header = big_endian(width) + big_endian(height);
  for (const int value : {kind.depth, kind.color, 0, 0, kind.interlace}) header += static_cast<char>(value);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + before + chunk("IDAT", deflated(rows)) + chunk("IEND", "");
}

std::vector<std::uint8_t> decoded(const std::string& file) {
  return decode(bytes(file), "test").rgba;
}

using Pixels = std::vector<std::uint8_t>;

TEST(PngDecode, GreyOfOneBit) {
  EXPECT_EQ(decoded(png(2, 1, {1, 0}, std::string("\0\x40", 2))), (Pixels{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(PngDecode, GreyWithAlpha) {
  EXPECT_EQ(decoded(png(1, 1, {8, 4}, std::string("\0\x50\x60", 3))), (Pixels{0x50, 0x50, 0x50, 0x60}));
}

TEST(PngDecode, PaletteWithTransparency) {
  const std::string palette = chunk("PLTE", std::string("\1\2\3\4\5\6", 6)) + chunk("tRNS", "\x80");
  EXPECT_EQ(decoded(png(2, 1, {8, 3}, std::string("\0\0\1", 3), palette)), (Pixels{1, 2, 3, 128, 4, 5, 6, 255}));
}

TEST(PngDecode, SixteenBitsAreRounded) {
  // 0x00ff is 0.99 steps of 257, so it rounds to 1; cutting the low byte would say 0.
  EXPECT_EQ(decoded(png(1, 1, {16, 0}, std::string("\0\0\xff", 3))), (Pixels{1, 1, 1, 255}));
}

TEST(PngDecode, Interlaced) {
  // Adam7 of 2 x 1 pixels: pass 1 has the first, pass 6 the second.
  EXPECT_EQ(decoded(png(2, 1, {8, 0, 1}, std::string("\0\x11\0\x22", 4))), (Pixels{17, 17, 17, 255, 34, 34, 34, 255}));
}

TEST(PngDecode, GammaIsNotApplied) {
  const std::string gamma = chunk("gAMA", big_endian(100000));
  EXPECT_EQ(decoded(png(1, 1, {8, 0}, std::string("\0\x80", 2), gamma)), (Pixels{128, 128, 128, 255}));
}

TEST(PngDecode, ABrokenProfileHarmsNothing) {
  const std::string profile = chunk("iCCP", "rubbish");
  EXPECT_EQ(decoded(png(1, 1, {8, 0}, std::string("\0\x80", 2), profile)), (Pixels{128, 128, 128, 255}));
}

TEST(PngDecode, HugeHeadersAreRefusedBeforeAllocation) {
  const std::string huge = png(0x7fffffff, 0x7fffffff, {8, 6}, "");
  expect_refused(ErrorCode::input_invalid, [&] { (void)decode(bytes(huge), "test"); });
  EXPECT_EQ(peek_size(bytes(huge), "test").width, 0x7fffffffu);
  const std::string many = png(16384, 16384, {8, 6}, "");
  expect_refused(ErrorCode::input_invalid, [&] { (void)decode(bytes(many), "test", {.pixels = 1 << 20}); });
  expect_refused(ErrorCode::input_invalid, [&] { (void)decode(bytes(png(0, 1, {8, 6}, "")), "test"); });
}

TEST(PngDecode, ABadChecksumIsRefused) {
  std::string file = png(1, 1, {8, 0}, std::string("\0\x80", 2));
  file[file.size() - 16] = static_cast<char>(file[file.size() - 16] + 1);  // of IDAT
  expect_refused(ErrorCode::input_invalid, [&] { (void)decode(bytes(file), "test"); });
}

// Seen by the message alone: libpng itself refuses the file too, after it has asked for the memory.
TEST(PngDecode, AChunkEndsWithinItsFile) {
  std::string file = png(1, 1, {8, 0}, std::string("\0\x80", 2));
  file.insert(33, "\x7f\xff\xff\xffprVt");  // after the header: a private chunk of 2 GiB
  const Thrown thrown = thrown_by([&] { (void)decode(bytes(file), "test"); });
  EXPECT_EQ(thrown.code, ErrorCode::input_invalid);
  EXPECT_NE(thrown.message.find("the chunk at byte 33, which claims 2147483647 bytes"), std::string::npos)
      << thrown.message;
}

TEST_F(Png, EightBitsComeBack) {
  for (const bool opaque : {false, true}) {
    const ByteImage image = test_bytes(37, 23, opaque);
    save_png(folder_ / "a.png", image);
    const std::string file = text_of(folder_ / "a.png");
    EXPECT_EQ(decode(bytes(file), "test").rgba, image.rgba);
    EXPECT_EQ(peek_size(bytes(file), "test").height, 23u);
    EXPECT_EQ(file[25], opaque ? 2 : 6) << "the colour type: alpha is stored where there is any";
  }
}

TEST_F(Png, SixteenBitsComeBackAsLinearLight) {
  WordImage image{2, 1, {0, 65535, 32768, 65535, 65535, 1, 2, 16384}};
  save_png(folder_ / "a.png", image);
  const FloatImage linear = load_linear(folder_ / "a.png");
  EXPECT_EQ(linear.rgba[1], 1.0f);
  // IEC 61966-2-1 at 32768 / 65535: ((0.5000076 + 0.055) / 1.055)^2.4
  EXPECT_NEAR(linear.rgba[2], 0.2140485f, 1e-6f);
  // In its straight part, 1 / 65535 / 12.92: eight bits would have lost it.
  EXPECT_NEAR(linear.rgba[5], 1.1810323e-6f, 1e-11f);
  EXPECT_NEAR(linear.rgba[7], 16384.0f / 65535.0f, 1e-7f);
}

TEST_F(Png, EqualPicturesAreEqualBytes) {
  save_png(folder_ / "a.png", test_bytes(64, 64, false));
  save_png(folder_ / "b.png", test_bytes(64, 64, false));
  EXPECT_EQ(text_of(folder_ / "a.png"), text_of(folder_ / "b.png"));
}

TEST_F(Png, DamageIsRefused) {
  save_png(folder_ / "a.png", test_bytes(37, 23, false));
  const std::string file = text_of(folder_ / "a.png");
  const auto read = [](std::string_view data) { (void)decode(bytes(data), "test"); };
  expect_every_truncation_refused(file, read);
  expect_no_crash_on_damage(file, read);
  expect_refused(ErrorCode::input_invalid, [] { (void)decode(bytes("rubbish"), "test"); });
  expect_refused(ErrorCode::input_invalid, [] { (void)decode({}, "test"); });
}

TEST_F(Png, AMissingFolderIsReported) {
  expect_refused(ErrorCode::output_not_written, [&] { save_png(folder_ / "none" / "a.png", test_bytes(2, 2, true)); });
}

TEST(Formats, Ktx2IsNotSupported) {
  const std::string file = std::string("\xabKTX 20\xbb\r\n\x1a\n") + std::string(68, '\0');
  expect_refused(ErrorCode::unsupported, [&] { (void)decode(bytes(file), "test"); });
  expect_refused(ErrorCode::unsupported, [&] { (void)peek_size(bytes(file), "test"); });
}

}  // namespace
}  // namespace velarium::image
