#pragma once

#include "core/budget.hpp"

#include <velarium/files.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace velarium {

// The whole file. Throws Error(input_missing) where it cannot be opened or is a directory,
// Error(input_invalid) where it is larger than `max_bytes`.
[[nodiscard]] std::vector<std::byte> read_file(const std::filesystem::path& file, std::uint64_t max_bytes);
// The same where the largest size is a budget of the user's; the error says how to raise it. Spends nothing.
[[nodiscard]] std::vector<std::byte> read_file(const std::filesystem::path& file, const Budget& budget);

// Writes under a temporary name in the same folder, then renames; leaves nothing behind on failure. A signal that ends
// the program without unwinding: see remove_unfinished_files(). A symbolic link is followed; a device or a pipe is
// written in place. Throws Error(output_not_written) with the system's reason.
void write_file(const std::filesystem::path& file, std::span<const std::byte> data);

// $XDG_CACHE_HOME/velarium, else ~/.cache/velarium; empty where neither variable is set.
// The directory need not exist. Cache users treat every failure as a miss.
[[nodiscard]] std::filesystem::path cache_directory();

// 64-bit FNV-1a, to name cached things by content.
[[nodiscard]] std::uint64_t content_hash(std::span<const std::byte> data, std::uint64_t seed = 0xcbf29ce484222325ull);

}  // namespace velarium
