#include "scene/gltf_uri.hpp"

#include "core/files.hpp"
#include "scene/gltf_file_names.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

namespace velarium::scene::gltf {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDataScheme = "data:";

constexpr std::array<std::int8_t, 256> make_base64_values() {
  std::array<std::int8_t, 256> values{};
  for (auto& value : values) value = -1;
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}

// RFC 4648, 4; padding may be missing.
std::vector<std::byte> base64_decoded(const Value& uri, std::string_view text) {
  static constexpr std::array<std::int8_t, 256> kValues = make_base64_values();
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) uri.fail("its base64 data is cut short");
  std::vector<std::byte> decoded(text.size() / 4 * 3 + text.size() % 4 * 3 / 4);
  std::uint32_t bits = 0;
  int bit_count = 0;
  std::size_t written = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::int8_t value = kValues[static_cast<unsigned char>(text[i])];
    if (value < 0) uri.fail(fmt::format("its base64 data has a character that is not base64, number {}", i));
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    decoded[written++] = static_cast<std::byte>(bits >> bit_count & 0xffu);
  }
  return decoded;
}

// RFC 2397: data:[type][;parameter=value]*[;base64],data
std::vector<std::byte> data_uri_bytes(const Value& uri, std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) uri.fail("is a data URI without a comma before its data");
  std::string_view header = text.substr(0, comma);
  const std::string_view data = text.substr(comma + 1);
  constexpr std::string_view kBase64 = ";base64";
  const bool base64 = lower_case(header).ends_with(kBase64);
  if (base64) header.remove_suffix(kBase64.size());
  for (std::size_t at = header.find(';'); at != std::string_view::npos;) {
    const std::size_t next = header.find(';', at + 1);
    if (header.substr(at, next - at).find('=') == std::string_view::npos) {
      uri.fail("is a data URI with a parameter that has no '='");
    }
    at = next;
  }
  if (!base64) {
    const std::string decoded = percent_decoded(uri, data);
    const auto bytes = std::as_bytes(std::span(decoded));
    return {bytes.begin(), bytes.end()};
  }
  // Some writers percent-encode the '+', '/' and '=' of base64.
  if (data.find('%') == std::string_view::npos) return base64_decoded(uri, data);
  return base64_decoded(uri, percent_decoded(uri, data));
}

UriData find_file(const Value& uri, std::string_view text, const GltfOptions& options, Budget& budget) {
  const std::string_view first_segment = text.substr(0, text.find_first_of("/?#"));
  if (first_segment.find(':') != std::string_view::npos) {
    uri.fail("has a scheme; only data URIs and relative file names are read");
  }
  if (text.empty() || text.starts_with("//")) uri.fail("names no file");
  const auto [name, file] = find_beside(uri, text, options);
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::is_regular_file(status)) {  // devices and pipes could block for ever
    throw Error(ErrorCode::input_missing, uri.file(),
                fmt::format("{}: '{}' {}", uri.pointer(), name,
                            fs::exists(status) ? "is not a regular file" : "does not exist; put it beside the scene"));
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) {
    throw Error(ErrorCode::input_missing, uri.file(),
                fmt::format("{}: '{}' cannot be read: {}", uri.pointer(), name, error.message()));
  }
  if (!budget.fits(size)) uri.fail(fmt::format("with '{}' there are {}", name, budget.refusal(size)));
  budget.spend(size);
  return {uri, file, size};
}

}  // namespace

// RFC 3986, 3.1: schemes ignore case.
bool is_data_uri(std::string_view text) {
  return lower_case(text.substr(0, kDataScheme.size())) == kDataScheme;
}

UriData find_uri(const Value& uri, const GltfOptions& options, Budget& budget) {
  const std::string_view text = uri.text();
  if (!is_data_uri(text)) return find_file(uri, text, options, budget);
  if (!budget.fits(text.size())) uri.fail("with its data there are " + budget.refusal(text.size()));
  budget.spend(text.size());
  return {uri, {}, text.size()};
}

std::vector<std::byte> read_uri(const UriData& found) {
  if (!found.file.empty()) return read_file(found.file, found.bytes);
  return data_uri_bytes(found.uri, found.uri.text().substr(kDataScheme.size()));
}

}  // namespace velarium::scene::gltf
