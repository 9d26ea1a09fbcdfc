// ProcessReport: how well force control held the cutting force in a simulation.
//
// The force is that of the simulated cut, or, where recorded sensors stand for it, the one that the
// control estimates. A disturbance is a step of depth or hardness within the cut that stays for a
// revolution or more; it has settled when the force is within 2 % of its setpoint for good.
#pragma once

#include <vector>

#include "channels/contract/output.h"
#include "plant/cutting/stock.h"

namespace stanok::runtime {

class ProcessReport {
 public:
  explicit ProcessReport(double cycle_s) : cycle_s_(cycle_s) {}

  // One cycle of the channel that cuts. `force_n`, `cut`: of the plant. Where the path slows down
  // to its end or a corner the force is not that of the control.
  void add(const channels::ChannelOutput& channel, double force_n, const plant::Stock::Cut& cut);
  void finish();

  [[nodiscard]] bool has_any() const { return has_any_; }
  // Greatest error of the mean force in a section after it has settled.
  [[nodiscard]] double force_error_steady_max() const { return steady_error_max_; }
  // Farthest that the force went beyond its setpoint on the way back to it.
  [[nodiscard]] double overshoot_return_max() const { return overshoot_max_; }
  [[nodiscard]] const std::vector<double>& settling_s() const { return settling_s_; }

 private:
  // From one disturbance, or the begin of the cut, to the next, or its end.
  struct Section {
    bool is_open = false;
    bool is_entry = false;
    plant::Stock::Cut cut{};
    double turns = 0.0;
    double time_s = 0.0;
    double unsettled_s = 0.0;  // when the force was last outside
    double first_error = 0.0;  // its sign is that of the disturbance
    double overshoot = 0.0;
    double error_sum = 0.0;  // since it is within
    std::int64_t error_count = 0;
  };
  void open(bool is_entry, const plant::Stock::Cut& cut);
  void close();

  double cycle_s_;
  bool has_any_ = false;
  Section section_;
  double steady_error_max_ = 0.0;
  double overshoot_max_ = 0.0;
  std::vector<double> settling_s_;
};

}  // namespace stanok::runtime
