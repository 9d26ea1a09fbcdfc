#include "daemon/desk/program_times.h"

#include <algorithm>

namespace stanok::daemon {

using nlohmann::json;

void ProgramTimes::note_check(const std::string& program, Verdict verdict, double time_s) {
  checks_[program] = {.time_s = time_s, .verdict = verdict};
  if (checks_.size() <= checks_max) return;
  checks_.erase(
      std::ranges::min_element(checks_, {}, [](const auto& one) { return one.second.time_s; }));
}

void ProgramTimes::add_to(json& programs, const std::vector<channels::RunReport>& runs) const {
  std::map<std::string, const channels::RunReport*> newest;
  for (const channels::RunReport& run : runs) {
    const channels::RunReport*& known = newest[run.program];
    if (known == nullptr || known->begun_at < run.begun_at) known = &run;
  }
  for (json& row : programs) {
    const auto name = row["name"].get<std::string>();
    row["checked_s"] = row["check_ok"] = row["ran_s"] = row["run_ok"] = nullptr;
    if (const auto check = checks_.find(name); check != checks_.end()) {
      row["checked_s"] = check->second.time_s;
      row["check_ok"] = check->second.verdict == Verdict::faultless;
    }
    if (const auto run = newest.find(name); run != newest.end()) {
      row["ran_s"] = run->second->begun_at;
      if (run->second->ended) row["run_ok"] = run->second->ok;
    }
  }
}

}  // namespace stanok::daemon
