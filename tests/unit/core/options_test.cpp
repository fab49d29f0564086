#include <velarium/error.hpp>
#include <velarium/log.hpp>
#include <velarium/options.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace velarium {
namespace {

std::string refusal(std::string_view key, std::string_view value) {
  Settings settings;
  try {
    set_option(settings, key, value);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::usage);
    return error.what();
  }
  return "accepted";
}

// Until 0.2. Each of them sets what the new key gives back, and says so.
TEST(Options, OldKeysStillWorkWithAWarning) {
  struct Row {
    const char *before, *now, *value;
  };
  for (const auto& [before, now, value] :
       {Row{"lighting.sphere_highlights", "lighting.area_lights", "off"},
        Row{"reference.glow", "reference.emissive_lighting", "off"}, Row{"sun_shadows.far", "far_shadows.kind", "off"},
        Row{"sun_shadows.far_size", "far_shadows.size", "512"},
        Row{"sun_shadows.reach", "sun_shadows.max_blocker_distance", "25"},
        Row{"sun_shadows.static_size", "far_shadows.static_size", "1024"}}) {
    std::string warning;
    set_log_sink([&](LogLevel level, std::string_view text) {
      if (level == LogLevel::warning) warning = text;
    });
    Settings settings;
    set_option(settings, before, value);
    set_log_sink({});
    EXPECT_EQ(get_option(settings, now), value);
    EXPECT_NE(warning.find(before), std::string::npos) << warning;
    EXPECT_NE(warning.find(now), std::string::npos) << warning;
    const auto is_old = [&](const OptionInfo& option) { return option.key == std::string_view(before); };
    EXPECT_TRUE(std::ranges::none_of(option_table(), is_old)) << before;
  }
}

TEST(Options, EveryDefaultReadsBackAsItself) {
  ASSERT_FALSE(option_table().empty());
  for (const OptionInfo& option : option_table()) {
    Settings settings;
    set_option(settings, option.key, option.default_text);
    EXPECT_EQ(get_option(settings, option.key), option.default_text) << option.key;
    EXPECT_EQ(get_option(Settings{}, option.key), option.default_text) << option.key;
  }
}

TEST(Options, EveryRowHasUniqueKeyGroupAndHelp) {
  std::set<std::string_view> keys;
  for (const OptionInfo& option : option_table()) {
    EXPECT_TRUE(keys.insert(option.key).second) << option.key;
    EXPECT_FALSE(option.help.empty()) << option.key;
    EXPECT_FALSE(option_group_help(option.key.substr(0, option.key.find('.'))).empty()) << option.key;
  }
  EXPECT_TRUE(option_group_help("no such group").empty());
}

TEST(Options, ChoicesAreTheEnumerators) {
  const auto table = option_table();
  const auto row = std::find_if(table.begin(), table.end(), [](const auto& o) { return o.key == "display.tonemap"; });
  ASSERT_NE(row, table.end());
  EXPECT_EQ(row->type, OptionType::choice);
  EXPECT_EQ(row->choices, (std::vector<std::string_view>{"neutral", "agx", "aces", "linear"}));
  Settings settings;
  set_option(settings, "display.tonemap", "aces");
  EXPECT_EQ(settings.display.tonemap, Tonemap::aces);
}

TEST(Options, RangesAreInclusiveAndChecked) {
  Settings settings;
  set_option(settings, "frame.spp", "1");
  set_option(settings, "frame.spp", "65536");
  EXPECT_EQ(settings.frame.spp, 65536);
  for (const char* bad : {"0", "65537", "-1", "99999999999", "4.5", "4x", "", " 4", "nan"}) {
    EXPECT_NE(refusal("frame.spp", bad), "accepted") << bad;
  }
  EXPECT_EQ(refusal("frame.spp", "0"), "frame.spp: '0' is not a whole number from 1 to 65536 frames");
}

TEST(Options, CountsHave64Bits) {
  Settings settings;
  set_option(settings, "load.bytes", "17592186044416");
  EXPECT_EQ(settings.load.bytes, 1ull << 44);
  EXPECT_EQ(get_option(settings, "load.bytes"), "17592186044416");
  for (const char* bad : {"0", "-1", "17592186044417", "1e6", "4G", "99999999999999999999"}) {
    EXPECT_NE(refusal("load.bytes", bad), "accepted") << bad;
  }
}

TEST(Options, RealsTakeSignsAndExponentsButNoNan) {
  Settings settings;
  set_option(settings, "display.exposure", "-2.5");
  EXPECT_EQ(settings.display.exposure, -2.5f);
  set_option(settings, "display.exposure", "+1e1");
  EXPECT_EQ(settings.display.exposure, 10.0f);
  for (const char* bad : {"nan", "inf", "-inf", "33", "1e99", "1,5", "--1", "++1"}) {
    EXPECT_NE(refusal("display.exposure", bad), "accepted") << bad;
  }
}

TEST(Options, BooleansTakeSixWords) {
  Settings settings;
  for (const char* word : {"off", "false", "0"}) {
    set_option(settings, "lighting.occlusion", word);
    EXPECT_FALSE(settings.lighting.occlusion);
    set_option(settings, "lighting.occlusion", "on");
    EXPECT_TRUE(settings.lighting.occlusion);
  }
  EXPECT_NE(refusal("lighting.occlusion", "yes"), "accepted");
}

TEST(Options, RefusalsNameTheChoicesAndTheNearestKey) {
  EXPECT_EQ(refusal("lighting.model", "rise"), "lighting.model: 'rise' is not one of gltf, ryse, blinn_phong");
  EXPECT_EQ(refusal("lighting.modle", "ryse"), "'lighting.modle' is not an option; did you mean lighting.model?");
  EXPECT_EQ(refusal("tonemap", "agx"), "'tonemap' is not an option; did you mean display.tonemap?");
  EXPECT_EQ(refusal("zzzzzzzz", "1"), "'zzzzzzzz' is not an option");
}

TEST(Options, ARefusedValueChangesNothing) {
  Settings settings;
  EXPECT_THROW(set_option(settings, "frame.spp", "70000"), Error);
  EXPECT_EQ(settings.frame.spp, Settings{}.frame.spp);
}

TEST(NearestName, FindsSwapsAndSlipsOnly) {
  const std::vector<std::string> known{"--exposure", "--env", "--size"};
  EXPECT_EQ(nearest_name("--exposrue", known), "--exposure");
  EXPECT_EQ(nearest_name("--EXPOSURE", known), "--exposure");
  EXPECT_EQ(nearest_name("--sizes", known), "--size");
  EXPECT_EQ(nearest_name("--completely-other", known), "");
  EXPECT_EQ(nearest_name("", known), "");
}

}  // namespace
}  // namespace velarium
