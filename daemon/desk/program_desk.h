// ProgramDesk: texts of programs, their check and their planned path, for clients.
//
// Files and checks are done in threads of their own, a file never behind a check; the path is read
// from what the simulation in the background has made so far. Nothing here waits. Belongs to the
// operator server's thread; `tick` wants to be called often.
#pragma once

#include <map>
#include <string>

#include "daemon/desk/background_work.h"
#include "daemon/desk/process/process_desk.h"
#include "daemon/desk/program_folder.h"
#include "daemon/desk/program_times.h"

namespace stanok::daemon {

class ProgramDesk {
 public:
  static constexpr std::size_t read_bytes_max = 512U << 10;
  static constexpr std::size_t upload_bytes_max = 64U << 20;  // of all that are under way

  // The machine outlives the desk.
  explicit ProgramDesk(RunningMachine& machine);

  // Parameters are as checked_parameters returned them; each answers once, now or later.
  void list(int session, Answer answer);
  void read(int session, const nlohmann::json& parameters, Answer answer);
  void write(int session, const nlohmann::json& parameters, Answer answer);
  void remove(int session, const nlohmann::json& parameters, Answer answer);
  void check(int session, const nlohmann::json& parameters, int channel, Answer answer);
  void estimate(int session, const nlohmann::json& parameters, int channel, Answer answer);
  // The virtual workpiece as the program leaves it, as a picture.
  void picture(int session, const nlohmann::json& parameters, int channel, Answer answer);
  // The cycle that a process file or a control file of plunge grinding gives.
  void grinding(int session, const nlohmann::json& parameters, Answer answer);
  // What else is calculated from files beneath the root, and from logs.
  [[nodiscard]] ProcessDesk& process() { return process_; }
  void cancel_check(int session) { checks_.cancel(session); }
  [[nodiscard]] CommandResult path(const nlohmann::json& parameters, int channel) const;

  void tick();
  // The session has ended.
  void forget(int session);

 private:
  struct Upload {
    std::string program;
    std::string text;
  };
  [[nodiscard]] ProgramFolder folder() const;
  // False: too much is under way.
  [[nodiscard]] bool gather(int session, const std::string& program, const std::string& text);

  RunningMachine& machine_;
  std::map<int, Upload> uploads_;  // by session
  ProgramTimes times_;
  ProcessDesk process_;
  BackgroundWork files_{BackgroundWork::Urgency::usual};
  BackgroundWork checks_{BackgroundWork::Urgency::batch};
};

}  // namespace stanok::daemon
