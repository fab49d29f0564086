#pragma once

#include <filesystem>
#include <string_view>

namespace velarium {

// Writes a text as Picture::save() writes a picture: whole or not at all. Throws Error(output_not_written).
void write_text(const std::filesystem::path& file, std::string_view text);

// Throws what writing a file would throw for a reason that can be seen beforehand; writes nothing.
void check_writable(const std::filesystem::path& file);

// Removes the temporary files of writes under way in this process. For a program that is about to leave on a signal
// without unwinding: such a write then fails or has already been renamed into place. Call from a normal thread, never
// from a signal handler.
void remove_unfinished_files() noexcept;

}  // namespace velarium
