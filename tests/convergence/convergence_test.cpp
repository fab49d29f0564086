// The renderer against the path tracer: how far each technique is from the truth, as budgets that may only fall.
// tools/convergence.py lowers them; docs/accuracy.md shows the pictures.

#include "results.hpp"
#include "rows.hpp"
#include "support/device.hpp"

#include <velarium/options.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <ostream>
#include <set>

namespace velarium::test {

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = VELARIUM_CONVERGENCE;

const std::vector<Row>& rows() {
  static const std::vector<Row> table = read_rows(kFolder / "budgets.csv");
  return table;
}

const std::vector<Noise>& noise() {
  static const std::vector<Noise> table = read_noise(kFolder / "references.csv");
  return table;
}

template <class Entry>
const Entry& named(const std::vector<Entry>& table, const std::string& name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry& entry) { return entry.name == name; });
  if (found == table.end()) throw std::runtime_error("no row of the tables of convergence is named " + name);
  return *found;
}

// The budget, and what another reference of the same quality might say.
bool is_within(const Errors& errors, const Row& row) {
  const Errors& spread = named(noise(), row.reference).errors;
  return errors.flip <= row.budget.flip + spread.flip && errors.relmse <= row.budget.relmse + spread.relmse;
}

Picture rendered(
    const Row& row, const std::function<void(RenderRequest&)>& change = [](RenderRequest&) {}) {
  RenderRequest request = render_request(row);
  change(request);
  return engine().picture(load_scene(row), request);
}

class Convergence : public testing::TestWithParam<Row> {};

TEST_P(Convergence, IsWithinItsBudget) {
  const Row& row = GetParam();
  if (needs_assets(row) && !has_assets()) GTEST_SKIP() << "VELARIUM_ASSETS is not set";
  const Picture picture = rendered(row), reference = load_picture(reference_file(row.reference));
  const Comparison comparison = compare(picture, reference);
  write_results(row, picture, reference, comparison);
  const Errors errors{comparison.flip, comparison.relmse};
  EXPECT_TRUE(is_within(errors, row)) << "FLIP " << errors.flip << ", budget " << row.budget.flip << "; relative MSE "
                                      << errors.relmse << ", budget " << row.budget.relmse
                                      << "\n  render, reference, error: "
                                      << (results_folder() / (row.name + ".jpg")).string();
}

INSTANTIATE_TEST_SUITE_P(Rows, Convergence, testing::ValuesIn(rows()), [](const auto& row) { return row.param.name; });

TEST(ConvergenceTables, HaveAReferenceAndACauseForEachRow) {
  std::set<std::string> names, references;
  for (const Row& row : rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(fs::exists(reference_file(row.reference))) << row.name;
    references.insert(row.reference);
    EXPECT_GT(row.cause.size(), 10u) << row.name;
    EXPECT_GT(named(noise(), row.reference).samples, 0u);
  }
  for (const auto& entry : fs::directory_iterator(kFolder / "references"))
    EXPECT_TRUE(references.contains(entry.path().stem().string())) << entry.path();
}

// A budget that noise could fill would hold nothing.
TEST(ConvergenceTables, HaveLessNoiseThanBudget) {
  constexpr double kMost = 0.75;
  for (const Row& row : rows()) {
    EXPECT_LT(named(noise(), row.reference).errors.flip, kMost * row.budget.flip) << row.name;
    EXPECT_LT(named(noise(), row.reference).errors.relmse, kMost * row.budget.relmse) << row.name;
  }
}

// --- faults that must be seen
// -----------------------------------------------------------------------------------------

struct Fault {
  const char* name;
  const char* row;
  const char* settings;  // KEY=VALUE
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

constexpr Fault kFaults[] = {
    {"energy_lost_by_single_scattering", "furnace_white", "lighting.multi_scatter=off"},
    {"another_model_of_reflectance", "lamps", "lighting.model=ryse"},
    {"environment_turned_by_ten_degrees", "spheres_studio", "environment.rotation=10"},
    {"environment_turned_the_other_way", "spheres_sky_turned", "environment.rotation=-90"},
    {"environment_brighter_by_a_tenth", "spheres_studio", "environment.intensity=1.1"},
    {"lamps_put_out", "atrium_unshadowed", "lighting.punctual=off"},
};

class ConvergenceSees : public testing::TestWithParam<Fault> {};

TEST_P(ConvergenceSees, AWrongSetting) {
  const Row& row = named(rows(), GetParam().row);
  const std::string setting = GetParam().settings;
  const auto equals = setting.find('=');
  const Picture wrong = rendered(row, [&](RenderRequest& request) {
    set_option(request.settings, setting.substr(0, equals), setting.substr(equals + 1));
  });
  EXPECT_FALSE(is_within(errors_of(wrong, load_picture(reference_file(row.reference))), row));
}

INSTANTIATE_TEST_SUITE_P(Faults, ConvergenceSees, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(ConvergenceSeesThat, LightIsHalfAStopOff) {
  for (const char* name : {"lamps", "spheres_studio", "cornell_full"}) {
    const Row& row = named(rows(), name);
    Picture picture = rendered(row);
    for (float& value : picture.linear) value *= 1.4142136f;
    EXPECT_FALSE(is_within(errors_of(picture, load_picture(reference_file(row.reference))), row)) << name;
  }
}

// Half a pixel to the right: the mean with the left neighbour.
TEST(ConvergenceSeesThat, ThePictureIsHalfAPixelOff) {
  for (const char* name : {"lamps", "textures", "spheres_studio"}) {
    const Row& row = named(rows(), name);
    const Picture picture = rendered(row);
    Picture shifted = picture;
    for (std::size_t i = 4; i < picture.linear.size(); ++i)
      shifted.linear[i] = 0.5f * (picture.linear[i] + picture.linear[i - 4]);
    EXPECT_FALSE(is_within(errors_of(shifted, load_picture(reference_file(row.reference))), row)) << name;
  }
}

}  // namespace
}  // namespace velarium::test
