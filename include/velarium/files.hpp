#pragma once

namespace velarium {

// Removes the temporary files of writes under way in this process. For a program that is about to leave on a signal
// without unwinding: such a write then fails or has already been renamed into place. Call from a normal thread, never
// from a signal handler.
void remove_unfinished_files() noexcept;

}  // namespace velarium
