#include "helpers.hpp"

#include <velarium/log.hpp>

#include <ImfChannelList.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>

#include <cmath>
#include <limits>

namespace velarium::image {
namespace {

using Exr = InFolder;

// A file with the named float channels, all reading the same values.
void write_channels(const fs::path& file, const std::vector<std::string>& names, std::vector<float> values,
                    Imf::Header header) {
  const int width = header.dataWindow().max.x - header.dataWindow().min.x + 1;
  const int height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
  Imf::FrameBuffer source;
  for (const std::string& name : names) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    source.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow(), sizeof(float),
                                         sizeof(float) * static_cast<std::size_t>(width)));
  }
  Imf::OutputFile out(file.c_str(), header);
  out.setFrameBuffer(source);
  out.writePixels(height);
}

TEST_F(Exr, FloatsComeBackExactly) {
  FloatImage image = test_floats(19, 11);
  image.rgba[3] = 0.5f;  // so that alpha is stored
  save_exr(folder_ / "a.exr", image, false);
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, image.rgba);
  EXPECT_EQ(load_linear(folder_ / "a.exr").rgba, image.rgba);
}

TEST_F(Exr, HalvesComeBackWithinTheirPrecision) {
  const FloatImage image = test_floats(19, 11);
  save_exr(folder_ / "a.exr", image, true);
  const FloatImage back = load_radiance(folder_ / "a.exr");
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    EXPECT_NEAR(back.rgba[i], image.rgba[i], image.rgba[i] / 2048.0f);  // 11 bits of mantissa
  }
}

TEST_F(Exr, HalvesDoNotOverflowToInfinity) {
  save_exr(folder_ / "a.exr", {1, 1, {1e9f, 1.0f, 0.0f, 1.0f}}, true);
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba[0], 65504.0f);  // the largest half
}

TEST_F(Exr, LuminanceIsGrey) {
  write_channels(folder_ / "a.exr", {"Y"}, {1, 2}, Imf::Header(2, 1));
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 1}));
}

TEST_F(Exr, OtherChannelsAreIgnoredOrUnsupported) {
  write_channels(folder_ / "a.exr", {"R", "G", "B", "Z"}, {3}, Imf::Header(1, 1));
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{3, 3, 3, 1}));
  write_channels(folder_ / "a.exr", {"Y", "RY", "BY"}, {3}, Imf::Header(1, 1));
  expect_refused(ErrorCode::unsupported, [&] { (void)load_radiance(folder_ / "a.exr"); });
  for (const auto& names : std::vector<std::vector<std::string>>{{"R", "G"}, {"V"}, {"view.R", "view.G"}}) {
    write_channels(folder_ / "a.exr", names, {3}, Imf::Header(1, 1));
    expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(folder_ / "a.exr"); });
  }
}

// As Blender writes them: nothing but layers, of which Combined is the picture.
TEST_F(Exr, WithoutPlainChannelsALayerIsThePicture) {
  write_channels(folder_ / "a.exr", {"view.R", "view.G", "view.B"}, {3}, Imf::Header(1, 1));
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{3, 3, 3, 1}));
  Imf::Header header(1, 1);
  for (const char* name : {"A.DiffDir.R", "A.DiffDir.G", "A.DiffDir.B"})
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  write_channels(folder_ / "a.exr", {"V.Combined.R", "V.Combined.G", "V.Combined.B"}, {4}, header);
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{4, 4, 4, 1}));
}

TEST_F(Exr, ThePictureIsTheFirstPartWithColours) {
  const std::vector<ExrPart> parts{
      {"depth", {"Z"}, {9}}, {"beauty", {"R", "G", "B"}, {1, 2, 3}}, {"other", {"R", "G", "B"}, {4, 5, 6}}};
  save_exr_parts(folder_ / "a.exr", {1, 1}, parts);
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{1, 2, 3, 1}));
  EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr", "depth")).rgba, (std::vector<float>{9, 9, 9, 1}));
}

TEST_F(Exr, LuminanceAndSubsampledChromaAreColours) {
  constexpr int kSize = 8;
  const std::vector<Imf::Rgba> pixels(kSize * kSize, Imf::Rgba(0.5f, 1.0f, 0.25f, 1.0f));
  {
    Imf::RgbaOutputFile file((folder_ / "a.exr").c_str(), kSize, kSize, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, kSize);
    file.writePixels(kSize);
  }
  const FloatImage image = load_radiance(folder_ / "a.exr");
  ASSERT_EQ(image.rgba.size(), std::size_t{4 * kSize * kSize});
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    EXPECT_NEAR(image.rgba[i], 0.5f, 0.005f);
    EXPECT_NEAR(image.rgba[i + 1], 1.0f, 0.005f);
    EXPECT_NEAR(image.rgba[i + 2], 0.25f, 0.005f);
    EXPECT_EQ(image.rgba[i + 3], 1.0f);
  }
}

// Display values are light after their transfer function: 188 is a half.
TEST_F(Exr, PanoramasOfEightBitsAreSrgb) {
  std::string warning;
  set_log_sink([&](LogLevel, std::string_view text) { warning = text; });
  save_png(folder_ / "a.png", ByteImage{1, 1, {188, 255, 0, 255}});
  const FloatImage image = load_radiance(folder_ / "a.png");
  set_log_sink({});
  EXPECT_NEAR(image.rgba[0], 0.5f, 0.005f);
  EXPECT_EQ(image.rgba[1], 1.0f);
  EXPECT_NE(warning.find("sRGB"), std::string::npos) << warning;
}

TEST_F(Exr, LayersAreChannelsWithTheirNameInFront) {
  write_channels(folder_ / "a.exr", {"light.R", "light.G", "light.B", "depth.Y", "normal.X"}, {3}, Imf::Header(1, 1));
  for (const char* layer : {"light", "depth"})
    EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr", layer)).rgba, (std::vector<float>{3, 3, 3, 1}));
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_picture(folder_ / "a.exr", "normal"); });
  EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr")).rgba, (std::vector<float>{3, 3, 3, 1})) << "light";
  const Thrown thrown = thrown_by([&] { (void)load_picture(folder_ / "a.exr", "lihgt"); });
  EXPECT_EQ(thrown.code, ErrorCode::usage);
  EXPECT_NE(thrown.message.find("there are depth, light, normal"), std::string::npos) << thrown.message;
}

TEST_F(Exr, OtherFilesHaveNoLayers) {
  save_exr(folder_ / "a.exr", test_floats(2, 2), false);
  save_png(folder_ / "a.png", test_bytes(2, 2, true));
  for (const char* name : {"a.exr", "a.png"})
    expect_refused(ErrorCode::usage, [&] { (void)load_picture(folder_ / name, "light"); });
}

TEST_F(Exr, UnsignedIntegersAreRead) {
  Imf::Header header(1, 1);
  Imf::FrameBuffer source;
  std::uint32_t value = 70000;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::UINT));
    source.insert(name, Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&value), 4, 4));
  }
  {
    Imf::OutputFile out((folder_ / "a.exr").c_str(), header);
    out.setFrameBuffer(source);
    out.writePixels(1);
  }
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba[0], 70000.0f);
}

TEST_F(Exr, TilesAreRead) {
  Imf::Header header(5, 3);
  header.setTileDescription(Imf::TileDescription(2, 2, Imf::ONE_LEVEL));
  std::vector<float> values;
  for (int i = 0; i < 15; ++i) values.push_back(static_cast<float>(i));
  Imf::FrameBuffer source;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    source.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 20));
  }
  {
    Imf::TiledOutputFile out((folder_ / "a.exr").c_str(), header);
    out.setFrameBuffer(source);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  }
  const FloatImage image = load_radiance(folder_ / "a.exr");
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(image.rgba[4 * i], values[i]);
}

TEST_F(Exr, OfSeveralPartsTheFirstIsReadUnlessOneIsNamed) {
  std::vector<Imf::Header> headers(2, Imf::Header(1, 1));
  for (std::size_t i = 0; i < 2; ++i) {
    headers[i].setName(i == 0 ? "first" : "second");
    headers[i].setType(Imf::SCANLINEIMAGE);
    for (const char* name : {"R", "G", "B"}) headers[i].channels().insert(name, Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile out((folder_ / "a.exr").c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      auto value = static_cast<float>(i + 1);
      Imf::FrameBuffer source;
      for (const char* name : {"R", "G", "B"})
        source.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&value), 4, 4));
      Imf::OutputPart part(out, i);
      part.setFrameBuffer(source);
      part.writePixels(1);
    }
  }
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba[0], 1.0f);
  EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr", "first")).rgba[0], 1.0f);
  EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr", "second")).rgba[0], 2.0f);
  // What the header of the second part claims is checked as well.
  std::string damaged = text_of(folder_ / "a.exr");
  const std::size_t box = damaged.rfind("dataWindow") + 10 + 1 + 6 + 4;  // name, "box2i", size
  damaged.replace(box + 8, 4, "\xff\xff\xff\x3f");                       // the largest x
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_picture(put("b.exr", damaged), "second"); });
}

TEST_F(Exr, DamageToLayersIsRefused) {
  write_channels(folder_ / "a.exr", {"light.R", "light.G", "light.B"}, std::vector<float>(64 * 40, 3.0f),
                 Imf::Header(64, 40));
  const std::string file = text_of(folder_ / "a.exr");
  const auto read = [&](std::string_view data) { (void)load_picture(put("b.exr", data), "light"); };
  expect_every_truncation_refused(file, read);
  expect_no_crash_on_damage(file, read);
}

TEST_F(Exr, ThePictureIsTheDisplayWindow) {
  using Imath::Box2i;
  using Imath::V2i;
  // Pixels of x from 1 to 3, shown from 0 to 2: the first is empty, the last is left out.
  const Imf::Header header(Box2i(V2i(0, 0), V2i(2, 0)), Box2i(V2i(1, 0), V2i(3, 0)));
  write_channels(folder_ / "a.exr", {"R", "G", "B"}, {7, 8, 9}, header);
  const FloatImage image = load_radiance(folder_ / "a.exr");
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.rgba, (std::vector<float>{0, 0, 0, 0, 7, 7, 7, 1, 8, 8, 8, 1}));
}

TEST_F(Exr, RadianceIsMadeFiniteAndSaid) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const auto& [bad, read] :
       {std::pair{std::numeric_limits<float>::quiet_NaN(), 0.0f}, {kInfinity, 65504.0f}, {-kInfinity, 0.0f}}) {
    std::string warning;
    set_log_sink([&](LogLevel, std::string_view text) { warning = text; });
    FloatImage image = test_floats(4, 3);
    const std::size_t at = 4 * (4 * 2 + 1);
    image.rgba[at] = bad;
    save_exr(folder_ / "a.exr", image, false);
    EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba[at], read);
    set_log_sink({});
    EXPECT_NE(warning.find("pixel (1, 2)"), std::string::npos) << warning;
  }
}

// Six faces of one texel-wide colour each, from the top +X, -X, +Y, -Y, +Z, -Z; the middle of the panorama is +X, a
// quarter to its right +Z (docs/conventions.md).
TEST_F(Exr, CubesBecomePanoramas) {
  constexpr int kFace = 4;
  Imf::Header header(kFace, 6 * kFace);
  Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
  std::vector<float> faces;
  for (int face = 1; face <= 6; ++face) faces.insert(faces.end(), kFace * kFace, static_cast<float>(face));
  write_channels(folder_ / "a.exr", {"R", "G", "B"}, faces, header);
  const FloatImage image = load_radiance(folder_ / "a.exr");
  ASSERT_EQ(image.width, 16u);
  ASSERT_EQ(image.height, 8u);
  const auto at = [&](std::size_t x, std::size_t y) { return image.rgba[4 * (y * 16 + x)]; };
  EXPECT_EQ(at(8, 4), 1.0f);
  EXPECT_EQ(at(0, 4), 2.0f);
  EXPECT_EQ(at(8, 0), 3.0f);
  EXPECT_EQ(at(8, 7), 4.0f);
  EXPECT_EQ(at(12, 4), 5.0f);
  EXPECT_EQ(at(4, 4), 6.0f);
  EXPECT_EQ(load_linear(folder_ / "a.exr").height, 24u) << "only a panorama is unfolded";
  Imf::Header five(kFace, 5 * kFace);
  Imf::addEnvmap(five, Imf::ENVMAP_CUBE);
  faces.resize(5 * kFace * kFace);
  write_channels(folder_ / "b.exr", {"R", "G", "B"}, faces, five);
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(folder_ / "b.exr"); });
}

// ITU-R BT.2087: white stays white, and BT.2020's green is (-0.5876, 1.1329, -0.1006) in BT.709.
TEST_F(Exr, OtherPrimariesBecomeBt709) {
  const auto read = [&](float r, float g, float b) {
    Imf::Header header(1, 1);
    Imf::addChromaticities(header, {{0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}});
    header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    header.channels().insert("G", Imf::Channel(Imf::FLOAT));
    header.channels().insert("B", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer source;
    for (const auto& [name, value] : {std::pair{"R", &r}, {"G", &g}, {"B", &b}})
      source.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(value), 4, 4));
    {
      Imf::OutputFile file((folder_ / "a.exr").c_str(), header);
      file.setFrameBuffer(source);
      file.writePixels(1);
    }
    return load_radiance(folder_ / "a.exr").rgba;
  };
  for (const float value : read(0.5f, 0.5f, 0.5f)) EXPECT_NEAR(value, value == 1.0f ? 1.0f : 0.5f, 1e-4f);
  const std::vector<float> mixed = read(0.5f, 1.0f, 0.25f);
  EXPECT_NEAR(mixed[0], 1.6605f * 0.5f - 0.5876f - 0.0728f * 0.25f, 1e-3f);
  EXPECT_NEAR(mixed[1], -0.1246f * 0.5f + 1.1329f - 0.0083f * 0.25f, 1e-3f);
  EXPECT_NEAR(mixed[2], -0.0182f * 0.5f - 0.1006f + 1.1187f * 0.25f, 1e-3f);
}

TEST_F(Exr, NegativeRadianceIsZeroAndSaid) {
  std::string warning;
  set_log_sink([&](LogLevel, std::string_view text) { warning = text; });
  save_exr(folder_ / "a.exr", {2, 1, {1, 1, 1, 1, 1, -0.5f, -2, 1}}, false);
  EXPECT_EQ(load_radiance(folder_ / "a.exr").rgba, (std::vector<float>{1, 1, 1, 1, 1, 0, 0, 1}));
  set_log_sink({});
  EXPECT_NE(warning.find("pixel (1, 0) has the value -0.5"), std::string::npos) << warning;
  EXPECT_NE(warning.find("(2 in all)"), std::string::npos) << warning;
  EXPECT_EQ(load_linear(folder_ / "a.exr").rgba[6], -2.0f);
}

TEST_F(Exr, HugeWindowsAreRefusedBeforeAllocation) {
  save_exr(folder_ / "a.exr", test_floats(4, 3), false);
  const std::string file = text_of(folder_ / "a.exr");
  for (const char* name : {"dataWindow", "displayWindow"}) {
    std::string damaged = file;
    const std::size_t box = damaged.find(name) + std::string(name).size() + 1 + 6 + 4;  // name, "box2i", size
    damaged.replace(box + 8, 4, "\xff\xff\xff\x3f");                                    // the largest x
    expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(put("b.exr", damaged)); });
  }
}

TEST_F(Exr, HugeChunksAreRefusedBeforeAllocation) {
  // One column of 44 channels; then the header claims the widest window there may be: 16384 * 256 * 44 * 4 bytes.
  Imf::Header header(1, 256);
  header.compression() = Imf::DWAB_COMPRESSION;
  std::vector<std::string> names;
  for (int i = 0; i < 44; ++i) names.push_back("light" + std::to_string(i) + ".R");
  write_channels(folder_ / "a.exr", names, std::vector<float>(256, 1.0f), header);
  std::string file = text_of(folder_ / "a.exr");
  for (const char* name : {"dataWindow", "displayWindow"}) {
    const std::size_t box = file.find(name) + std::string(name).size() + 1 + 6 + 4;  // name, "box2i", size
    file.replace(box + 8, 4, std::string_view("\xff\x3f\0\0", 4));                   // the largest x
  }
  const Thrown thrown = thrown_by([&] { (void)load_radiance(put("b.exr", file)); });
  EXPECT_EQ(thrown.code, ErrorCode::input_invalid);
  EXPECT_NE(thrown.message.find("chunks of 738197504 bytes"), std::string::npos) << thrown.message;
}

TEST_F(Exr, DamageIsRefused) {
  FloatImage image = test_floats(64, 40);
  save_exr(folder_ / "a.exr", image, true);
  const std::string file = text_of(folder_ / "a.exr");
  const auto read = [&](std::string_view data) { (void)load_radiance(put("b.exr", data)); };
  expect_every_truncation_refused(file, read);
  expect_no_crash_on_damage(file, read);
}

TEST_F(Exr, OtherFilesAreRefused) {
  expect_refused(ErrorCode::input_missing, [&] { (void)load_radiance(folder_ / "none.exr"); });
  expect_refused(ErrorCode::input_missing, [&] { (void)load_radiance(folder_); });
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(put("a.exr", "")); });
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(put("a.exr", "rubbish")); });
  const Thrown thrown =
      thrown_by([&] { (void)load_radiance(put("a.exr", "version https://git-lfs.github.com/spec/v1\n")); });
  EXPECT_NE(thrown.message.find("git lfs pull"), std::string::npos) << thrown.message;
}

}  // namespace
}  // namespace velarium::image
