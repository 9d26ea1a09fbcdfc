// ProcessDesk: what can be calculated of the cutting process: stability lobes, figures of a cut
// from its log, forces along a program and the feeds that hold them.
//
// The computation is that of `stanok process lobes`, `identify` and `optimise`; answers have what
// its pictures need, in at most `rows_max` rows. It is done behind everything else that the
// computer does, one piece after the other, with bounds of its processor time and memory. Belongs
// to the operator server's thread; `tick` wants to be called often.
#pragma once

#include "daemon/desk/background_work.h"
#include "daemon/desk/program_folder.h"

namespace stanok::daemon {

class ProcessDesk {
 public:
  static constexpr std::size_t rows_max = 1200;

  // The machine outlives the desk.
  explicit ProcessDesk(RunningMachine& machine) : machine_(machine) {}

  // Parameters are as checked_parameters returned them; each answers once, now or later. Who asks
  // anew gives up what it has asked before.
  void stability(int session, const nlohmann::json& parameters, Answer answer);
  void figures(int session, const nlohmann::json& parameters, int channel, Answer answer);
  void forces(int session, const nlohmann::json& parameters, int channel, Answer answer);
  void cancel(int session) { work_.cancel(session); }

  void tick() { work_.tick(); }
  // The session has ended.
  void forget(int session) { work_.cancel(session); }

 private:
  [[nodiscard]] ProgramFolder folder() const;

  RunningMachine& machine_;
  BackgroundWork work_{BackgroundWork::Urgency::batch};
};

}  // namespace stanok::daemon
