#include "scene/gltf_file_names.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace velarium::scene::gltf {

namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

fs::path folder_of(const Value& uri) {
  return uri.file().has_parent_path() ? uri.file().parent_path() : fs::path(".");
}

bool is_inside(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

// The folder's and the file's places with every `..` and link resolved.
fs::path resolved_file(const Value& uri, const fs::path& relative, const GltfOptions& options) {
  std::error_code folder_error, file_error;
  const fs::path base = folder_of(uri);
  const fs::path folder = fs::canonical(base, folder_error);
  fs::path file = fs::weakly_canonical(base / relative, file_error);
  if (folder_error || file_error) {
    throw Error(ErrorCode::input_missing, uri.file(),
                fmt::format("{}: cannot find '{}': {}", uri.pointer(), relative.string(),
                            (file_error ? file_error : folder_error).message()));
  }
  if (!options.allow_outside_files && !is_inside(folder, file)) {
    uri.fail(fmt::format("names '{}', outside the folder of the scene; move the file there, or allow outside files",
                         relative.string()));
  }
  return file;
}

// Whether a file of this name is there, or a folder or anything else that is none.
bool is_there(const Value& uri, const fs::path& relative, const GltfOptions& options) {
  std::error_code error;
  return fs::exists(resolved_file(uri, relative, options), error);
}

// The entry of `folder` that is called `name` but for the case of letters; the first by name where there are several.
std::optional<fs::path> entry_in_any_case(const fs::path& folder, const std::string& name) {
  std::optional<fs::path> found;
  const std::string wanted = lower_case(name);
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path candidate = entry->path().filename();
    if (lower_case(candidate.string()) == wanted && (!found || candidate < *found)) found = candidate;
  }
  return found;
}

// `relative` as the folders below `base` spell it, whatever the case of letters.
std::optional<fs::path> in_any_case(const fs::path& base, const fs::path& relative) {
  fs::path found;
  for (const fs::path& part : relative) {
    std::error_code error;
    if (fs::exists(base / found / part, error)) {
      found /= part;
      continue;
    }
    const auto entry = entry_in_any_case(base / found, part.string());
    if (!entry) return std::nullopt;
    found /= *entry;
  }
  return found;
}

// Other spellings by which writers on other systems mean a file.
std::optional<std::string> another_spelling(const Value& uri, std::string_view text, const GltfOptions& options) {
  std::vector<std::string> spellings;
  const std::string_view bare = text.substr(0, text.find_first_of("?#"));
  for (const std::string_view spelling : {text, bare}) {
    std::string slashes = percent_decoded(uri, spelling);
    spellings.push_back(slashes);
    std::ranges::replace(slashes, '\\', '/');
    spellings.push_back(slashes);
  }
  for (const std::string& spelling : spellings)
    if (!spelling.empty() && is_there(uri, spelling, options)) return spelling;
  for (const std::string& spelling : spellings)
    if (const auto found = in_any_case(folder_of(uri), spelling); found && is_there(uri, *found, options))
      return found->string();
  return std::nullopt;
}

// The file's name as the folder has it; as the URI has it where there is no such file.
std::string spelled_name(const Value& uri, std::string_view text, const GltfOptions& options) {
  std::string name = percent_decoded(uri, text);
  if (name.find('\0') != std::string::npos) uri.fail("holds a zero byte");
  if (is_there(uri, name, options)) return name;
  auto other = another_spelling(uri, text, options);
  if (!other) return name;
  uri.repair(fmt::format("'{}' does not exist; '{}' was read", name, *other));
  return *std::move(other);
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string percent_decoded(const Value& uri, std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) uri.fail("has a '%' without two hexadecimal digits after it; write a plain '%' as %25");
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

NamedFile find_beside(const Value& uri, std::string_view text, const GltfOptions& options) {
  const std::string name = spelled_name(uri, text, options);
  return {name, resolved_file(uri, fs::path(name), options)};
}

}  // namespace velarium::scene::gltf
