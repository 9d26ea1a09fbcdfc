// MachineWatch: what of a running machine belongs into its journal, each once.
//
// Looks at the runs and alarms that the machine remembers, and once a second at where its runs are.
// Belongs to one thread.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "channels/contract/reports.h"
#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

class MachineWatch {
 public:
  // The machine outlives the watch.
  explicit MachineWatch(RunningMachine& machine) : machine_(machine) {}

  // This is in the journal already.
  void pass_over(const channels::Past& past);
  // Records of what is new, `now` being the Unix time.
  [[nodiscard]] std::vector<nlohmann::json> look(double now);

 private:
  struct Known {
    std::uint64_t begun = 0;  // numbers
    std::uint64_t named = 0;
    std::uint64_t ended = 0;
    std::uint64_t seen_ended = 0;
    std::uint64_t alarms = 0;
    std::pair<std::string, std::uint32_t> place{};  // of the newest run
  };
  using Records = std::vector<nlohmann::json>;

  void look_at_runs(const std::vector<channels::RunReport>& runs, Records& records);
  void look_at_alarms(Records& records);
  void look_at_places(const std::vector<channels::RunReport>& runs, double now, Records& records);
  [[nodiscard]] bool has_news(double now);

  RunningMachine& machine_;
  std::map<int, Known> known_;           // by channel
  std::vector<std::uint64_t> standing_;  // of the outputs looked at last
  double looked_at_ = 0.0;
  bool looks_again_ = false;  // at once
};

}  // namespace stanok::daemon
