// SurfaceDesk: the surfaces of the workpieces that are being cut, a page at a time, for clients.
//
// Pages are made in a thread of their own, which waits for the one that cuts; nothing here waits.
// Belongs to the operator server's thread; `tick` wants to be called often.
#pragma once

#include <memory>

#include "daemon/desk/background_work.h"
#include "simulation/reference/reference_surface.h"

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
  // The surface that a part is to have, of the file that was named last. Of the thread that makes
  // pages alone.
  struct Reference {
    std::string program;
    std::optional<simulation::ReferenceSurface> surface;
  };

  RunningMachine& machine_;
  std::shared_ptr<Reference> reference_ = std::make_shared<Reference>();
  BackgroundWork work_{BackgroundWork::Urgency::batch};
};

}  // namespace stanok::daemon
