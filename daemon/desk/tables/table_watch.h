// TableWatch: what of tools and work offsets has changed, when, and by whom; and whether what
// loaded programs lead through is another one now.
//
// Operators change values, programs and lines by hand do (G10, measuring), and a run may leave
// another kinematic scheme behind it. What operators change is noted when it is accepted; else the
// tables are compared when a run has ended. Belongs to the operator server's thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

class TableWatch {
 public:
  static constexpr std::size_t changes_max = 500;

  // The machine outlives it.
  explicit TableWatch(RunningMachine& machine) : machine_(machine) {}

  // Somebody has changed values; `time_s` is that of Unix.
  void note(const std::string& by, double time_s);
  // To be called often. True: since the last time a run has ended with other tables, or a channel
  // has another scheme than before; never while a run is under way.
  [[nodiscard]] bool look(double time_s);
  // The newest first.
  [[nodiscard]] nlohmann::json history() const;

 private:
  using Values = std::map<std::string, double>;  // "T3.1 length", "G54 X"
  struct Change {
    double time_s = 0.0;
    std::string by;
    std::string what;
    double from = 0.0;
    double to = 0.0;
  };
  // What a channel may leave behind: its run, and its scheme.
  using Standing = std::map<int, std::pair<std::uint32_t, std::int32_t>>;

  [[nodiscard]] Values values() const;
  // False: there is none.
  bool compare(const std::string& by, double time_s);
  [[nodiscard]] std::string newest_program() const;

  RunningMachine& machine_;
  bool is_known_ = false;
  Values known_;
  Standing standing_;
  std::deque<Change> changes_;  // the newest first
};

}  // namespace stanok::daemon
