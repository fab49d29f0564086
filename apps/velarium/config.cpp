#include "config.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace velarium::app {
namespace {

std::string scalar_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "on" : "off";
  return {};
}

std::vector<std::string> texts_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {scalar_text(node)};
  std::vector<std::string> texts;
  for (const toml::node& item : *list) texts.push_back(scalar_text(item));
  if (list->is_homogeneous(toml::node_type::string)) return texts;
  return {fmt::format("{}", fmt::join(texts, ","))};
}

ConfigEntry entry_of(std::string_view table, std::string_view key, const toml::node& value) {
  const toml::source_position place = value.source().begin;
  return {std::string(table), std::string(key), texts_of(value), place.line, place.column};
}

toml::table parse(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw Error(ErrorCode::input_missing, file, "is a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(ErrorCode::input_missing, file, fmt::format("cannot be opened: {}", std::strerror(errno)));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    throw Error(ErrorCode::input_invalid, file,
                fmt::format("line {}, column {}: {}", place.line, place.column, error.description()));
  }
}

}  // namespace

std::vector<ConfigEntry> read_config(const std::filesystem::path& file) {
  std::vector<ConfigEntry> entries;
  const toml::table root = parse(file);
  for (const auto& [name, node] : root) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      const std::string reason = fmt::format("'{}' stands outside a table such as [render] or [lighting]", name.str());
      throw Error(ErrorCode::input_invalid, file, at_place(entry_of("", name.str(), node), reason));
    }
    for (const auto& [key, value] : *table) entries.push_back(entry_of(name.str(), key.str(), value));
  }
  return entries;
}

std::string at_place(const ConfigEntry& entry, const std::string& reason) {
  return fmt::format("line {}, column {}: {}", entry.line, entry.column, reason);
}

}  // namespace velarium::app
