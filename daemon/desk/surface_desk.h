// SurfaceDesk: the surfaces of the workpieces that are being cut, a page at a time, for clients.
//
// Pages are made in a thread of their own, which waits for the one that cuts; nothing here waits.
// Belongs to the operator server's thread; `tick` wants to be called often.
#pragma once

#include "daemon/desk/background_work.h"

namespace stanok::daemon {

class SurfaceDesk {
 public:
  // The machine outlives the desk.
  explicit SurfaceDesk(RunningMachine& machine) : machine_(machine) {}

  // Parameters are as checked_parameters returned them; answers once, now or later.
  void surface(int session, const nlohmann::json& parameters, int channel, Answer answer);

  void tick() { work_.tick(); }
  // The session has ended.
  void forget(int session) { work_.cancel(session); }

 private:
  RunningMachine& machine_;
  BackgroundWork work_{BackgroundWork::Urgency::idle};
};

}  // namespace stanok::daemon
