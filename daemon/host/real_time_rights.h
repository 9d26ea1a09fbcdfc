// Real-time rights of a thread: FIFO scheduling, locked memory, a stack that is already there.
//
// What the system does not grant is no failure: the daemon runs without, says so once and shows it
// in its status (docs/integrator/realtime.md, "Rights").
#pragma once

#include <string>
#include <vector>

namespace stanok::daemon {

struct RealTimeRights {
  bool has_fifo_scheduling = false;
  bool has_locked_memory = false;
  std::vector<std::string> notes;  // what was refused, and how to grant it
};

// For the calling thread, before its first cycle. Priority as of sched(7), 1..99.
[[nodiscard]] RealTimeRights take_real_time_rights(int priority);

// FIFO scheduling for the calling thread, where the system grants it.
void prefer_this_thread(int priority);

// The scheduling that threads have without any of this.
void be_ordinary_thread();

// While it lives, threads that the calling thread starts inherit FIFO scheduling (sched(7)), where
// the system grants it; the calling thread is as before afterwards. For threads that must answer
// within milliseconds under load, below the cycle.
class FifoForNewThreads {
 public:
  explicit FifoForNewThreads(int priority);
  ~FifoForNewThreads();
  FifoForNewThreads(const FifoForNewThreads&) = delete;
  FifoForNewThreads& operator=(const FifoForNewThreads&) = delete;

 private:
  int policy_before_ = 0;
  int priority_before_ = 0;
};

}  // namespace stanok::daemon
