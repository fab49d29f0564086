#include <velarium/compare.hpp>

#include "api/compare_page_template.hpp"
#include "api/compared_pictures.hpp"
#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "image/codecs.hpp"
#include "image/error_colors.hpp"

#include <velarium/error.hpp>
#include <velarium/version.hpp>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>

namespace velarium {
namespace {

using Values = std::map<std::string, std::string, std::less<>>;

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

// RFC 4648, with padding.
std::string base64(std::span<const std::byte> data) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((data.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < data.size(); i += 3) {
    const std::size_t bytes = std::min<std::size_t>(3, data.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < bytes; ++k) bits |= std::to_integer<std::uint32_t>(data[i + k]) << (16 - 8 * k);
    for (std::size_t k = 0; k < 4; ++k) text += k <= bytes ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string png_uri(const image::ByteImage& image) {
  return "data:image/png;base64," + base64(image::write_png(image, "a picture of the page"));
}

image::ByteImage error_bytes(const Comparison& comparison) {
  image::ByteImage bytes{comparison.width, comparison.height, {}};
  bytes.rgba.reserve(4 * comparison.flip_map.size());
  for (const float error : comparison.flip_map) {
    for (const std::uint8_t channel : image::error_color(error)) bytes.rgba.push_back(channel);
    bytes.rgba.push_back(255);
  }
  return bytes;
}

void add_pictures(const compared::Pair& pair, const Comparison& comparison, const CompareOptions& options,
                  Values& values) {
  std::array<std::string, 3> uris;
  parallel_for(uris.size(), [&](std::size_t i) {
    const auto shown = [&](const image::FloatImage& image) {
      return compared::shown_bytes(image, pair.linear, options.exposure);
    };
    uris[i] = png_uri(i == 0 ? shown(pair.picture) : i == 1 ? shown(pair.reference) : error_bytes(comparison));
  });
  values["picture_png"] = std::move(uris[0]);
  values["reference_png"] = std::move(uris[1]);
  values["error_png"] = std::move(uris[2]);
}

std::string gradient() {
  constexpr int kStops = 16;  // close enough that what lies between them cannot be told from the map
  std::string stops;
  for (int i = 0; i <= kStops; ++i) {
    const auto color = image::error_color(static_cast<float>(i) / kStops);
    stops += fmt::format("{}#{:02x}{:02x}{:02x}", i == 0 ? "" : ", ", color[0], color[1], color[2]);
  }
  return stops;
}

std::string number_text(double value, std::string_view unit) {
  if (std::isinf(value)) return "&infin;";
  return fmt::format("{:.5g}{}{}", value, unit.empty() ? "" : "&nbsp;", unit);
}

std::string rows(const Comparison& comparison, Metric decides) {
  std::string text;
  for (const MetricInfo& info : metric_table()) {
    text += fmt::format("<tr{}><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"help\">{}</td></tr>\n",
                        info.metric == decides ? " class=\"decides\"" : "", info.title,
                        number_text(comparison.value(info.metric), info.unit), info.help);
  }
  return text;
}

std::string remarks(const Comparison& comparison, const CompareOptions& options) {
  std::string text;
  const auto item = [&text](const std::string& sentence) { text += fmt::format("<li>{}</li>\n", escaped(sentence)); };
  item(fmt::format("{} x {} pixels, {} compared", comparison.width, comparison.height, comparison.pixels));
  item(comparison.linear
           ? fmt::format("linear light, FLIP over {} exposures from {:.2f} to {:.2f} stops; the page shows "
                         "it clamped and sRGB-encoded, without a tone curve",
                         comparison.exposures, comparison.first_exposure, comparison.last_exposure)
           : std::string("display values"));
  item(fmt::format("largest difference of a channel {:.5g} at ({}, {})", comparison.largest, comparison.largest_x,
                   comparison.largest_y));
  item(fmt::format("{:g} pixels per degree; a pixel is off where a channel differs by more than {:.4g}",
                   options.pixels_per_degree, options.tolerance));
  for (const std::string& note : comparison.notes) item(note);
  return text;
}

// Braces of the style and of the script stand alone, so that two of them are always a name.
std::string filled(std::string_view page, const Values& values) {
  std::string text;
  for (std::size_t open; (open = page.find("{{")) != std::string_view::npos;) {
    const std::size_t close = page.find("}}", open);
    text += page.substr(0, open);
    const auto value = values.find(page.substr(open + 2, close - open - 2));
    VEL_ASSERT(value != values.end());
    text += value->second;
    page.remove_prefix(close + 2);
  }
  return text += page;
}

}  // namespace

std::string comparison_page(const Picture& picture, const Picture& reference, const Comparison& comparison,
                            const CompareOptions& options, Metric metric, double threshold) {
  const compared::Pair pair = compared::pair_of(picture, reference, options);
  const MetricInfo& decides = metric_table()[static_cast<std::size_t>(metric)];
  const bool within = comparison.within(metric, threshold);
  Values values{
      {"version", std::string(kVersion)},
      {"name", escaped(options.name)},
      {"reference", escaped(options.reference_name)},
      {"class", within ? "within" : "beyond"},
      {"verdict",
       fmt::format("{} {}, {} the threshold of {}", decides.title, number_text(comparison.value(metric), decides.unit),
                   within ? "within" : "beyond", number_text(threshold, decides.unit))},
      {"gradient", gradient()},
      {"rows", rows(comparison, metric)},
      {"remarks", remarks(comparison, options)},
      {"width", std::to_string(comparison.width)},
      {"height", std::to_string(comparison.height)},
  };
  add_pictures(pair, comparison, options, values);
  return filled(compared::kPageTemplate, values);
}

}  // namespace velarium
