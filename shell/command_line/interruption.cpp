// SPDX-License-Identifier: MIT
#include "shell/command_line/interruption.h"

#include <signal.h>

#include <atomic>

namespace gaitsmith::shell {

namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // required in a signal handler

void Note(int) { interrupted = true; }

}  // namespace

void CatchInterruption() {
  struct sigaction action{};
  action.sa_handler = Note;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

bool Interrupted() { return interrupted; }

}  // namespace gaitsmith::shell
