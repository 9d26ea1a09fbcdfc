#include "daemon/host/signals.h"

#include <csignal>
#include <cstring>

namespace stanok::daemon {
namespace {

bool is_ignored(int number) {
  struct sigaction now{};
  return ::sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void ignore_harmless_signals() {
  for (const int number : {SIGPIPE, SIGXFSZ, SIGTSTP, SIGTTIN, SIGTTOU}) {
    struct sigaction ignored{};
    ignored.sa_handler = SIG_IGN;
    ::sigaction(number, &ignored, nullptr);
  }
}

std::vector<int> ending_signals() {
  std::vector<int> numbers = {SIGINT,    SIGTERM, SIGQUIT, SIGUSR1, SIGUSR2,   SIGALRM,
                              SIGVTALRM, SIGPROF, SIGIO,   SIGXCPU, SIGSTKFLT, SIGPWR};
  if (!is_ignored(SIGHUP)) numbers.push_back(SIGHUP);
  for (int number = SIGRTMIN; number <= SIGRTMAX; ++number) numbers.push_back(number);
  return numbers;
}

std::string signal_name(int number) {
  const char* const name = ::sigabbrev_np(number);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(number);
}

}  // namespace stanok::daemon
