// ProgramTimes: when programs were checked and run last, as far as the daemon has seen it.
//
// Checks are noted here, those of saved texts; runs come from the reports of the machine. Belongs
// to the operator server's thread.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

class ProgramTimes {
 public:
  static constexpr std::size_t checks_max = 2000;

  enum class Verdict : std::uint8_t { faulty, faultless };
  // `time_s`: of Unix, as all times here.
  void note_check(const std::string& program, Verdict verdict, double time_s);

  // Adds what is known to the rows of program.list; null: nothing is known.
  void add_to(nlohmann::json& programs, const std::vector<channels::RunReport>& runs) const;

 private:
  struct Check {
    double time_s = 0.0;
    Verdict verdict = Verdict::faulty;
  };
  std::map<std::string, Check> checks_;  // by program
};

}  // namespace stanok::daemon
