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

void ProgramTimes::add_to(json& programs, const std::vector<channels::RunReport>& runs,
                          std::int64_t now, double now_s, double cycle_s) {
  std::map<std::int64_t, double> begun_s;
  std::map<std::string, const channels::RunReport*> newest;
  for (const channels::RunReport& run : runs) {
    const channels::RunReport*& known = newest[run.program];
    if (known == nullptr || known->start_cycle < run.start_cycle) known = &run;
    const auto before = begun_s_.find(run.start_cycle);
    begun_s[run.start_cycle] = before != begun_s_.end()
                                   ? before->second
                                   : now_s - static_cast<double>(now - run.start_cycle) * cycle_s;
  }
  begun_s_.swap(begun_s);
  for (json& row : programs) {
    const auto name = row["name"].get<std::string>();
    row["checked_s"] = row["check_ok"] = row["ran_s"] = row["run_ok"] = nullptr;
    if (const auto check = checks_.find(name); check != checks_.end()) {
      row["checked_s"] = check->second.time_s;
      row["check_ok"] = check->second.verdict == Verdict::faultless;
    }
    if (const auto run = newest.find(name); run != newest.end()) {
      row["ran_s"] = begun_s_.at(run->second->start_cycle);
      if (run->second->ended) row["run_ok"] = run->second->ok;
    }
  }
}

}  // namespace stanok::daemon
