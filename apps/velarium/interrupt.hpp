#pragma once

// SIGINT and SIGTERM. The first asks the main thread to unwind at its next check_interrupt(); a second, or no check
// within two seconds, removes half-written files and ends the program at once.

namespace velarium::app {

struct Interrupted {
  int signal;
  const char* outcome = "nothing was written";
};

// Call before any other thread is started: threads inherit that these signals are blocked.
void watch_signals();

// Throws Interrupted once a signal has come.
void check_interrupt();

// The signal that has come, or 0. Whoever asks and is told takes the end into his own hands: the program then waits for
// a second signal, and no longer for two seconds.
[[nodiscard]] int take_interrupt();

// What a shell expects of a program that a signal ended.
[[nodiscard]] constexpr int exit_code_of_signal(int signal) {
  return 128 + signal;
}

}  // namespace velarium::app
