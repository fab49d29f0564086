#include "interrupt.hpp"

#include <velarium/files.hpp>

#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <thread>

namespace velarium::app {
namespace {

// Long enough for a frame of an ordinary picture, short enough for whoever waits at the keyboard.
constexpr timespec kGrace{2, 0};

std::atomic<int> caught{0};
std::atomic<bool> taken{false};

void wait_for_signals(sigset_t signals) {
  int signal = 0;
  if (sigwait(&signals, &signal) != 0) return;
  caught = signal;
  int second = sigtimedwait(&signals, nullptr, &kGrace);
  if (second < 0 && taken) sigwait(&signals, &second);
  remove_unfinished_files();
  ::_exit(exit_code_of_signal(second > 0 ? second : signal));
}

// Signals that the parent wants ignored (nohup, a shell's background job) stay ignored.
void add_unless_ignored(sigset_t& signals, int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
}

}  // namespace

void watch_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  add_unless_ignored(signals, SIGINT);
  add_unless_ignored(signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(wait_for_signals, signals).detach();
}

void check_interrupt() {
  if (const int signal = caught; signal != 0) throw Interrupted{signal};
}

int take_interrupt() {
  if (caught != 0) taken = true;
  return caught;
}

}  // namespace velarium::app
