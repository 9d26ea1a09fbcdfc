// Signals: none that can be handled ends the daemon but by the orderly end, and none stops it in a
// move.
//
// Signals of a process's own faults (SIGSEGV, SIGABRT and the like) keep their meaning; SIGKILL and
// SIGSTOP cannot be handled. Source: signal(7).
#pragma once

#include <string>
#include <vector>

namespace stanok::daemon {

// A reader that has gone, a file that may not grow, and the job control of a terminal become errors
// of the call in question. For the whole process.
void ignore_harmless_signals();

// Those that begin the orderly end: all others whose usual effect is to end the process. SIGHUP is
// none of them for who was started with nohup.
[[nodiscard]] std::vector<int> ending_signals();

// "SIGTERM"
[[nodiscard]] std::string signal_name(int number);

}  // namespace stanok::daemon
