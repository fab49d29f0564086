#include "bake/table_cache.hpp"

#include "core/files.hpp"
#include "core/log.hpp"

#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>

namespace velarium::bake {

// A file is the table's bytes and then their content_hash.
bool load_table(const std::string& name, std::span<std::byte> table) {
  const std::filesystem::path directory = cache_directory();
  std::error_code error;
  if (directory.empty() || !std::filesystem::exists(directory / name, error)) return false;
  try {
    const std::size_t expected = table.size() + sizeof(std::uint64_t);
    const std::vector<std::byte> file = read_file(directory / name, expected);
    if (file.size() != expected) return false;
    const std::span<const std::byte> content = std::span(file).first(table.size());
    const std::uint64_t hash = content_hash(content);
    if (std::memcmp(&hash, file.data() + table.size(), sizeof hash) != 0) return false;
    std::memcpy(table.data(), content.data(), content.size());
    return true;
  } catch (const std::exception& failure) {
    log_debug("cached table not read: {}", failure.what());
    return false;
  }
}

void store_table(const std::string& name, std::span<const std::byte> table) {
  const std::filesystem::path directory = cache_directory();
  if (directory.empty()) return;
  try {
    std::filesystem::create_directories(directory);
    const std::uint64_t hash = content_hash(table);
    const std::span<const std::byte> hash_bytes = std::as_bytes(std::span(&hash, 1));
    std::vector<std::byte> file(table.begin(), table.end());
    file.insert(file.end(), hash_bytes.begin(), hash_bytes.end());
    write_file(directory / name, file);
  } catch (const std::exception& failure) { log_debug("table not cached: {}", failure.what()); }
}

}  // namespace velarium::bake
