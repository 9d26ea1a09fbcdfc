// A thread that runs when nothing else of the computer wants to (sched(7), SCHED_IDLE), and its
// end, which somebody waits for.
#pragma once

#include <stop_token>
#include <thread>

namespace stanok {

// The thread that calls it, from now on until its stop is requested; where the system does not let
// it, it stays what it is.
void run_when_idle(const std::stop_token& stop);

// The same for a piece of work. Its thread has the usual class before and behind it, when it holds
// what others wait for.
class IdleWork {
 public:
  explicit IdleWork(const std::stop_token& stop) { run_when_idle(stop); }
  ~IdleWork();
  IdleWork(const IdleWork&) = delete;
  IdleWork& operator=(const IdleWork&) = delete;
};

// Requests its stop and waits for its end. It has the usual class meanwhile: who waits for it
// cannot wait until a busy computer is idle. Where the system does not allow that (without
// CAP_SYS_NICE, by RLIMIT_NICE), it ends when it can.
void end_idle_thread(std::jthread& thread);

}  // namespace stanok
