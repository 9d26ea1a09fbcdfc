// LogDesk: the log files of the machine as clients see them: which there are, whether one repeats
// to the bit, and where it led the tip.
//
// Logs are large: all is done in a thread of its own, behind everything else of the computer.
// Nothing here waits. Belongs to the operator server's thread; `tick` wants to be called often.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "daemon/desk/background_work.h"
#include "jobs/foresight/part_place.h"

namespace stanok::daemon {

// The way of a tip in a log, thinned out.
struct LoggedPath {
  struct Point {
    std::array<float, 3> place_mm{};
    std::uint32_t time_ms = 0;  // since the first setpoint of the log
    std::uint32_t line = 0;     // of the program; 0: none ran
  };
  std::filesystem::path file;
  int channel = 0;
  bool is_on_part = false;  // in the part system; else in the workpiece system that was active
  std::int64_t first_cycle = 0;
  std::int64_t last_cycle = 0;
  std::int64_t cycles_left_out = 0;  // whose places are not known
  std::vector<Point> points;
};

class LogDesk {
 public:
  static constexpr std::size_t page_points = 8192;
  static constexpr std::size_t points_max = 400'000;  // further ones: every second one is left out

  // The machine outlives the desk.
  explicit LogDesk(RunningMachine& machine) : machine_(machine) {}

  // Parameters are as checked_parameters returned them; each answers once, later.
  void list(int session, Answer answer);
  void verify(int session, const nlohmann::json& parameters, Answer answer);
  void path(int session, const nlohmann::json& parameters, int channel, Answer answer);

  void tick() { work_.tick(); }
  // The session has ended.
  void forget(int session) { work_.cancel(session); }

 private:
  // The path that was asked for last; of the thread that works.
  struct Newest {
    LoggedPath path;
  };
  [[nodiscard]] std::optional<jobs::PartSystem> part_system(int channel);

  RunningMachine& machine_;
  std::shared_ptr<Newest> newest_ = std::make_shared<Newest>();
  BackgroundWork work_{BackgroundWork::Urgency::batch};
};

}  // namespace stanok::daemon
