// Traces the references of the convergence test again, and writes their noise beside them.
//
// usage: trace_references [--paths N] [NAME...]
//
// NAME: references that budgets.csv names; none: all whose files are at hand. N: paths a pixel, 256 where not given,
// half of them in each of two tracings with seeds of their own. The reference is the mean of the two, and what is
// between them tells its noise.

#include "rows.hpp"

#include <velarium/error.hpp>
#include <velarium/files.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace velarium::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSeeds[] = {1, 2};
// OpenEXR's lossy DWA at a ninth of its usual strength: FLIP moves by at most 0.005, relative MSE by 2e-6.
constexpr float kCompression = 5.0f;

// Colours in halves, a few tens of kilobytes. Picture::save() loses nothing, and is five times larger.
void save_small(const fs::path& file, const Picture& picture) {
  Imf::Header header(static_cast<int>(picture.width), static_cast<int>(picture.height));
  header.compression() = Imf::DWAB_COMPRESSION;
  header.dwaCompressionLevel() = kCompression;
  std::vector<half> halves(picture.linear.begin(), picture.linear.end());
  Imf::FrameBuffer source;
  int channel = 0;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::HALF));
    auto* base = reinterpret_cast<char*>(halves.data() + channel++);
    source.insert(name, Imf::Slice(Imf::HALF, base, 4 * sizeof(half), 4 * sizeof(half) * picture.width));
  }
  Imf::OutputFile out(file.c_str(), header);
  out.setFrameBuffer(source);
  out.writePixels(static_cast<int>(picture.height));
}

struct Traced {
  Picture mean;
  Noise noise;
};

Traced trace(const Row& row, int paths) {
  const Scene scene = load_scene(row);
  ReferenceRequest request = reference_request(row);
  request.view.settings.reference.spp = paths / 2;
  Traced traced{.noise = {.name = row.reference}};
  std::vector<Picture> pictures;
  for (const int seed : kSeeds) {
    request.view.settings.frame.seed = seed;
    ReferenceResult result = render_reference(scene, request);
    traced.noise.samples += result.report.samples;
    pictures.push_back(std::move(result.picture));
  }
  // Differences of two are twice (in FLIP, which grows with them) and four times (squared) those of their mean.
  const Errors apart = errors_of(pictures[0], pictures[1]);
  traced.noise.errors = {apart.flip / 2.0, apart.relmse / 4.0};
  traced.mean = {.width = row.width, .height = row.height, .linear = pictures[0].linear};
  std::transform(pictures[0].linear.begin(), pictures[0].linear.end(), pictures[1].linear.begin(),
                 traced.mean.linear.begin(), [](float a, float b) { return 0.5f * (a + b); });
  return traced;
}

// Rows that were not traced keep what the table says of them.
void write_noise(const fs::path& file, const std::vector<Row>& rows, const std::vector<Noise>& traced) {
  std::map<std::string, Noise> table;
  if (fs::exists(file))
    for (const Noise& noise : read_noise(file)) table[noise.name] = noise;
  for (const Noise& noise : traced) table[noise.name] = noise;
  std::string text = "name,paths,flip,relmse\n";
  for (const Row& row : rows)
    if (const auto found = table.find(row.name); found != table.end())
      text += fmt::format("{},{},{:.2g},{:.2g}\n", row.name, found->second.samples, found->second.errors.flip,
                          found->second.errors.relmse);
  write_text(file, text);
}

struct Arguments {
  int paths = 256;
  std::vector<std::string> names;
};

Arguments arguments_of(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--paths" && i + 1 < words.size()) {
      arguments.paths = std::stoi(words[++i]);
    } else {
      arguments.names.push_back(words[i]);
    }
  }
  return arguments;
}

void run(const Arguments& arguments) {
  const fs::path folder(VELARIUM_CONVERGENCE);
  const std::vector<Row> rows = read_rows(folder / "budgets.csv");
  for (const Row& row : rows) {
    const auto& names = arguments.names;
    const bool named = std::find(names.begin(), names.end(), row.reference) != names.end();
    if (row.reference != row.name) continue;  // the row that bears its name says how it is traced
    if (!named && (!names.empty() || (needs_assets(row) && !has_assets()))) continue;
    const Traced traced = trace(row, arguments.paths);
    save_small(reference_file(row.reference), traced.mean);
    const Errors loss = errors_of(load_picture(reference_file(row.reference)), traced.mean);
    fmt::print("{}: {} paths a pixel; noise: FLIP {:.2g}, relative MSE {:.2g}; compression: {:.2g}, {:.2g}\n", row.name,
               traced.noise.samples, traced.noise.errors.flip, traced.noise.errors.relmse, loss.flip, loss.relmse);
    std::fflush(stdout);
    write_noise(folder / "references.csv", rows, {traced.noise});
  }
}

}  // namespace
}  // namespace velarium::test

int main(int argc, char** argv) {
  try {
    velarium::test::run(velarium::test::arguments_of({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    fmt::print(stderr, "trace_references: {}\n", error.what());
    return 1;
  }
  return 0;
}
