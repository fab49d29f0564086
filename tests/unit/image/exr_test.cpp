#include "helpers.hpp"

#include <velarium/log.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
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
  for (const auto& names : std::vector<std::vector<std::string>>{{"R", "G"}, {"V"}, {"view.R", "view.G", "view.B"}}) {
    write_channels(folder_ / "a.exr", names, {3}, Imf::Header(1, 1));
    expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(folder_ / "a.exr"); });
  }
}

TEST_F(Exr, LayersAreChannelsWithTheirNameInFront) {
  write_channels(folder_ / "a.exr", {"light.R", "light.G", "light.B", "depth.Y", "normal.X"}, {3}, Imf::Header(1, 1));
  for (const char* layer : {"light", "depth"})
    EXPECT_EQ(std::get<FloatImage>(load_picture(folder_ / "a.exr", layer)).rgba, (std::vector<float>{3, 3, 3, 1}));
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_picture(folder_ / "a.exr", "normal"); });
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_picture(folder_ / "a.exr"); });
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

TEST_F(Exr, RadianceMustBeFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    FloatImage image = test_floats(4, 3);
    image.rgba[4 * (4 * 2 + 1)] = bad;
    save_exr(folder_ / "a.exr", image, false);
    const Thrown thrown = thrown_by([&] { (void)load_radiance(folder_ / "a.exr"); });
    EXPECT_EQ(thrown.code, ErrorCode::input_invalid);
    EXPECT_NE(thrown.message.find("pixel (1, 2)"), std::string::npos) << thrown.message;
    EXPECT_EQ(load_linear(folder_ / "a.exr").rgba.size(), image.rgba.size());
  }
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
  save_png(folder_ / "a.png", test_bytes(2, 2, true));
  expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(folder_ / "a.png"); });
}

}  // namespace
}  // namespace velarium::image
