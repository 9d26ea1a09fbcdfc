// Real-time rights of a thread: FIFO scheduling, locked memory, a stack that is already there.
//
// What the system does not grant is no failure: the daemon runs without, says so once and shows it
// in its status (docs/realtime.md, "Rights").
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

}  // namespace stanok::daemon
