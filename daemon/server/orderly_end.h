// OrderlyEnd: how the daemon ends: feed hold of all channels, then drives off, then the end.
//
// Begun by a signal or system.shutdown. A machine that does not come to rest in time does
// not keep the daemon alive: the drives' watchdogs stop the axes
// (docs/integrator/drives.md#supervision).
#pragma once

#include <chrono>

#include "daemon/cycle/running_machine.h"
#include "daemon/desk/stop_desk.h"

namespace stanok::daemon {

class OrderlyEnd {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // Both outlive the end.
  OrderlyEnd(RunningMachine& machine, StopDesk& stops) : machine_(machine), stops_(stops) {}

  // Does nothing the second time.
  void begin(Time now);
  [[nodiscard]] bool has_begun() const { return stage_ != Stage::not_begun; }
  // To be called often. True: the daemon may end.
  [[nodiscard]] bool step(Time now);

 private:
  enum class Stage { not_begun, holding, switching_off, done };

  RunningMachine& machine_;
  StopDesk& stops_;
  Stage stage_ = Stage::not_begun;
  Time deadline_{};
};

}  // namespace stanok::daemon
