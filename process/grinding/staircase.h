// The infeed law of a control: a few constant feeds, switched at places of X.
//
// A feed that is switched down too late lets the removal cross the boundary; the best feed of a
// step is therefore the one whose removal touches the boundary at the step's end. Where the steps
// end is chosen by dynamic programming over the quasi-steady law, so that their time is least; then
// the feeds are tuned by simulating the whole cycle, delay and deflection included, until each step
// touches the boundary and none crosses it; and the places are moved as long as the whole cycle,
// tuned each time, becomes shorter. Places and feeds are rounded to the decimals of the control
// file within the tuning, so that what is verified is what is written.
#pragma once

#include <optional>
#include <vector>

#include "process/grinding/optimiser.h"

namespace stanok::process {

// Constant feed from a place on, until the next one.
struct Step {
  double begin_mm = 0.0;
  double feed_mm_per_s = 0.0;
};

// Rows of the control file: two for each step, the first one from the allowance, the last one to
// `end_mm`.
[[nodiscard]] InfeedLaw law_of_steps(const std::vector<Step>& steps, double end_mm);

// quick: at the places that dynamic programming finds. thorough: also with fewer points, and the
// best of them moved while the whole cycle becomes shorter.
enum class StaircaseEffort : std::uint8_t { quick, thorough };

struct StaircaseOptions {
  std::optional<int> points{};  // number of switch points; none: as many as are worth it
  std::vector<double> at_mm{};  // their places, falling, taken as they are; empty: chosen
  // Of chosen places in mm and feeds in mm/s; none: 4, and more where the feed of the end would
  // have less than two digits.
  std::optional<int> decimals{};
  StaircaseEffort effort = StaircaseEffort::thorough;
};

struct Staircase {
  InfeedLaw law;
  bool is_reachable = true;  // false: no end of the law brings the part to size in the time allowed
};

// The decimals of a table for this process.
[[nodiscard]] int usual_decimals(const GrindingProcess& process);

constexpr int switch_points_max = 40;

[[nodiscard]] Staircase design_staircase(const GrindingProcess& process, double allowance_mm,
                                         const FeedRange& feeds, const StaircaseOptions& options,
                                         const PlungeOptions& simulation);

// Where `points` steps of the quasi-steady law should end, mm, falling.
struct QuasiSteadyLaw {
  std::vector<double> x_mm;           // falling
  std::vector<double> feed_mm_per_s;  // greatest feed permitted at that place
  double last_step_min_mm = 0.0;      // the surface is finished by a step of its own
};
[[nodiscard]] QuasiSteadyLaw quasi_steady_law(const GrindingProcess& process, double allowance_mm,
                                              const FeedRange& feeds);
[[nodiscard]] std::vector<double> best_places(const QuasiSteadyLaw& law, int points);
// Time of the steps that end at these places and at the end of the law, s.
[[nodiscard]] double steps_time_s(const QuasiSteadyLaw& law, const std::vector<double>& places_mm);

}  // namespace stanok::process
