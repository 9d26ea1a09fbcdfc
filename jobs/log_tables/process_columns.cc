#include "jobs/log_tables/process_columns.h"

#include <limits>

#include "base/units.h"

namespace stanok::jobs {
namespace {

constexpr double not_told = std::numeric_limits<double>::quiet_NaN();

template <auto Member>
double of_process(const ProcessRow& row) {
  return row.process ? static_cast<double>((*row.process).*Member) : not_told;
}

template <auto Member>
double of_force(const ProcessRow& row) {
  return row.force ? static_cast<double>((*row.force).*Member) : not_told;
}

// A feed in mm/s of the message, in mm/min.
template <auto Member>
double feed_of_force(const ProcessRow& row) {
  return seconds_per_minute * of_force<Member>(row);
}

}  // namespace

const Columns<ProcessRow>& process_columns() {
  using R = ProcessRow;
  using P = process_status_t;
  using F = force_status_t;
  constexpr Together first = Together::first;
  constexpr Together peak = Together::peak;
  static const Columns<R> columns{
      {"time_s", 3, first, [](const R& r) { return r.time_s; }, "s",
       "time from the beginning of the log"},
      {"cycle", 0, first, [](const R& r) { return static_cast<double>(r.cycle); }, "",
       "number of the cycle, as in setpoints"},
      {"law", 0, first, &of_process<&P::law>, "",
       "feed law: 0 none, 1 linear, 2 modulated, 3 interrupted, 4 curve"},
      {"increments", 0, peak, &of_process<&P::increments>, "",
       "number of increments that the law has made"},
      {"stands", 0, peak, &of_process<&P::stands>, "",
       "1: on the equivalent dwell path of an interrupted feed"},
      {"feed_mm_min", 1, peak, &of_process<&P::feed>, "mm/min",
       "programmed feed S; 0 in rapid traverse"},
      {"feed_mm_rev", 4, peak, &of_process<&P::feed_per_rev>, "mm/rev",
       "feed per revolution S_0 = S / n; 0: the spindle is stopped"},
      {"spindle_rev_min", 1, peak, &of_process<&P::spindle_speed>, "rev/min",
       "speed n of the master spindle, clockwise > 0"},
      {"cutting_speed_m_min", 2, peak, &of_process<&P::cutting_speed>, "m/min",
       "cutting speed v at the diameter of the tool tip"},
      {"force_state", 0, first, &of_force<&F::control>, "",
       "force control: 1 waits for the idle power, 2 holds the feed, 3 regulates, 4 sensor fault"},
      {"force_set_n", 1, peak, &of_force<&F::force_set_now>, "N",
       "set force P_z with its oscillation"},
      {"force_set_mean_n", 1, peak, &of_force<&F::force_set>, "N",
       "set force P_z without its oscillation"},
      {"force_n", 1, peak, &of_force<&F::force>, "N",
       "force estimated from the power; 0: not in the cut"},
      {"power_w", 1, peak, &of_force<&F::power>, "W",
       "power N_d of the spindle; not a number: the sensor reports none"},
      {"power_idle_w", 1, peak, &of_force<&F::power_idle>, "W", "idle power N_x at this speed"},
      {"radius_mm", 4, peak, &of_force<&F::radius>, "mm", "value of the radius counter"},
      {"feed_requested_mm_min", 1, peak, &feed_of_force<&F::feed>, "mm/min",
       "feed S that force control asks for; 0: the programmed feed"},
      {"feed_min_mm_min", 1, peak, &feed_of_force<&F::feed_min>, "mm/min",
       "smallest feed S_min of force control"},
      {"feed_max_mm_min", 1, peak, &feed_of_force<&F::feed_max>, "mm/min",
       "largest feed S_max of force control"},
      {"vibration_um", 2, peak, &of_force<&F::vibration>, "um",
       "amplitude a_0 of the vibration; 0: within the permitted level"},
      {"vibration_hz", 1, peak, &of_force<&F::vibration_rate>, "Hz", "frequency of the vibration"},
      {"oscillation_n", 1, peak, &of_force<&F::oscillation>, "N",
       "amplitude P_osc of the force oscillation"},
      {"oscillation_hz", 2, peak, &of_force<&F::oscillation_rate>, "Hz",
       "frequency of the force oscillation"},
  };
  return columns;
}

bool is_cycle(const Column<ProcessRow>& column) {
  return column.name == "cycle";
}

}  // namespace stanok::jobs
