#include "process/grinding/staircase.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/place.h"
#include "process/grinding/place_search.h"

namespace stanok::process {
namespace {

// Rounds of tuning: an error of the feeds falls to a tenth in each, coupling of neighbours aside.
constexpr int tuning_rounds = 10;
constexpr double tuning_exponent = 0.9;
// A step that comes this close to the boundary is tuned.
constexpr double touch = 0.005;
// What a switch point more must save to be worth it, as part of the cycle.
constexpr double worth_of_point = 0.012;
constexpr int points_chosen_max = 12;
// Steps of rounding taken off a feed that crosses the boundary.
constexpr int lowering_rounds = 6;
// A feed that had to be lowered to less than this part of its quasi-steady one suffers from the
// spring that the step before has bent.
constexpr double suffering_part = 0.7;

constexpr int decimals_min = 4;  // of the paper's file
constexpr int decimals_max = 7;

double rounded_down(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::floor(value * scale + 1e-6) / scale;
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

// Places as the file will have them, each once.
std::vector<double> written_places(std::vector<double> places_mm, int decimals) {
  for (double& place : places_mm) place = rounded(place, decimals);
  places_mm.erase(std::unique(places_mm.begin(), places_mm.end()), places_mm.end());
  return places_mm;
}

class StaircaseTuning {
 public:
  StaircaseTuning(const GrindingProcess& process, double allowance_mm, const FeedRange& feeds,
                  int decimals, PlungeOptions simulation)
      : process_(process),
        boundary_(process),
        allowance_mm_(allowance_mm),
        feeds_(feeds),
        decimals_(decimals),
        quantum_(std::pow(10.0, -decimals)),
        simulation_(std::move(simulation)) {
    simulation_.at_end = InfeedTravel::AtEnd::goes_on;
  }

  // The feeds that suit the places, rounded; its run tells where the last one ends, and its time.
  struct Tuned {
    std::vector<Step> steps;
    PlungeRun run;
    [[nodiscard]] double time_s() const { return run.time_s; }
  };

  // Begins with the feeds of `like`, where it has as many steps.
  [[nodiscard]] Tuned tuned(std::vector<Step> steps, const std::vector<Step>& like = {}) const {
    const std::vector<Step> quasi_steady = steps;
    if (like.size() == steps.size()) {
      for (std::size_t k = 0; k < steps.size(); ++k) steps[k].feed_mm_per_s = like[k].feed_mm_per_s;
    }
    for (int round = 0; round < tuning_rounds; ++round) {
      const PlungeRun run = run_of(steps);
      const std::vector<double> peaks = peaks_of(steps, run);
      if (!run.size_reached_s || std::ranges::all_of(peaks, touches)) break;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const double factor = peaks[k] > 0.0 ? std::pow(peaks[k], -tuning_exponent) : 1.0;
        set_feed(steps[k], factor);
        const double part = steps[k].feed_mm_per_s / quasi_steady[k].feed_mm_per_s;
        if (k > 0 && factor < 1.0 && part < suffering_part) set_feed(steps[k - 1], factor);
      }
    }
    for (Step& step : steps) step.feed_mm_per_s = floor_feed(step.feed_mm_per_s);
    return lowered(std::move(steps));
  }

  [[nodiscard]] double end_mm(const Tuned& tuned) const {
    return rounded_down(tuned.run.samples.back().x_mm, decimals_);
  }

  // Feeds to begin with: those of the quasi-steady law at the ends of the steps.
  [[nodiscard]] std::vector<Step> steps_at(const std::vector<double>& places_mm,
                                           const QuasiSteadyLaw& law) const {
    std::vector<Step> steps;
    double begin_mm = allowance_mm_;
    for (std::size_t k = 0; k <= places_mm.size(); ++k) {
      const double end = k < places_mm.size() ? places_mm[k] : law.x_mm.back();
      const auto place = std::lower_bound(law.x_mm.begin(), law.x_mm.end(), end, std::greater<>());
      const auto index = std::min(checked_size(place - law.x_mm.begin()), law.x_mm.size() - 1);
      steps.push_back({begin_mm, law.feed_mm_per_s[index]});
      begin_mm = end;
    }
    return steps;
  }

  // X at which the removal of the greatest feed, from the touch on, comes to Q_max.
  [[nodiscard]] double plunge_in_place_mm() const {
    const InfeedLaw law = constant_law(allowance_mm_, 0.0, feeds_.max_mm_per_s);
    const PlungeRun run = simulate_plunge(process_, law, simulation_);
    for (const PlungeSample& sample : run.samples) {
      if (sample.removal_mm2_per_rad >= boundary_.removal_max()) return sample.x_mm;
    }
    return allowance_mm_;
  }

 private:
  static bool touches(double peak) { return peak == 0.0 || std::abs(1.0 - peak) < touch; }

  void set_feed(Step& step, double factor) const {
    step.feed_mm_per_s =
        std::clamp(step.feed_mm_per_s * factor, feeds_.min_mm_per_s, feeds_.max_mm_per_s);
  }
  [[nodiscard]] double floor_feed(double feed) const {
    return std::max(rounded_down(feed, decimals_), quantum_);
  }

  [[nodiscard]] PlungeRun run_of(const std::vector<Step>& steps) const {
    const double end_mm = std::min(steps.back().begin_mm, 0.0) - overrun_max_mm(process_);
    return simulate_plunge(process_, law_of_steps(steps, end_mm), simulation_);
  }

  // Greatest Q/D of each step. A sample answers for the feed of half a revolution ago: the middle
  // of the way that its layer was made of. 0: the step was over before.
  [[nodiscard]] std::vector<double> peaks_of(const std::vector<Step>& steps,
                                             const PlungeRun& run) const {
    std::vector<double> peaks(steps.size(), 0.0);
    std::size_t step = 0;
    std::size_t earlier = 0;  // the sample of half a revolution ago
    for (const PlungeSample& sample : run.samples) {
      while (run.samples[earlier].time_s < sample.time_s - 0.5 * revolution_s(process_)) ++earlier;
      const double x_mm = run.samples[earlier].x_mm;
      while (step + 1 < steps.size() && x_mm < steps[step + 1].begin_mm) ++step;
      const double ratio = sample.removal_mm2_per_rad / boundary_.at(sample.allowance_mm);
      peaks[step] = std::max(peaks[step], ratio);
    }
    return peaks;
  }

  [[nodiscard]] Tuned lowered(std::vector<Step> steps) const {
    PlungeRun run = run_of(steps);
    for (int round = 0; round < lowering_rounds; ++round) {
      const std::vector<double> peaks = peaks_of(steps, run);
      bool is_lowered = false;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if (peaks[k] <= 1.0 || steps[k].feed_mm_per_s <= quantum_) continue;
        steps[k].feed_mm_per_s = floor_feed(
            std::min(steps[k].feed_mm_per_s / peaks[k], steps[k].feed_mm_per_s - quantum_));
        is_lowered = true;
      }
      if (!is_lowered) break;
      run = run_of(steps);
    }
    return {std::move(steps), std::move(run)};
  }

  const GrindingProcess& process_;
  Boundary boundary_;
  double allowance_mm_;
  FeedRange feeds_;
  int decimals_;
  double quantum_;
  PlungeOptions simulation_;
};

// Without the steps that the cycle came to its size before.
std::vector<Step> begun_steps(std::vector<Step> steps, double end_mm) {
  while (steps.size() > 1 && steps.back().begin_mm <= end_mm) steps.pop_back();
  return steps;
}

// The end for a wheel that stands there: what the spring gives back in the spark-out is not fed. At
// the end the removal is steady, so that the size moves with the last X.
double end_for_spark_out(const GrindingProcess& process, const std::vector<Step>& steps,
                         double end_mm, double quantum_mm, PlungeOptions simulation) {
  constexpr int rounds = 4;
  simulation.at_end = InfeedTravel::AtEnd::stands;
  for (int round = 0; round < rounds; ++round) {
    const InfeedLaw law = law_of_steps(begun_steps(steps, end_mm), end_mm);
    const double left_mm = simulate_plunge(process, law, simulation).residual_mm;
    const double quanta = std::ceil(left_mm / quantum_mm);
    if (quanta == 0.0) break;
    end_mm -= quanta * quantum_mm;
  }
  return end_mm;
}

int points_worth_it(const QuasiSteadyLaw& law) {
  double time_s = steps_time_s(law, {});
  for (int points = 1; points <= points_chosen_max; ++points) {
    const double next_s = steps_time_s(law, best_places(law, points));
    if (time_s - next_s < worth_of_point * time_s) return points - 1;
    time_s = next_s;
  }
  return points_chosen_max;
}

// Staircases of one process, by the places of their switch points.
class StaircaseChoice {
 public:
  using Tuned = StaircaseTuning::Tuned;

  StaircaseChoice(const StaircaseTuning& tuning, const QuasiSteadyLaw& law, const FeedRange& feeds,
                  double allowance_mm, int decimals)
      : tuning_(tuning),
        law_(law),
        feeds_(feeds),
        allowance_mm_(allowance_mm),
        decimals_(decimals) {}

  // The places that dynamic programming finds, or one of them spent on the plunge-in: the greatest
  // feed until the removal has built up.
  [[nodiscard]] Tuned quick(int points) {
    Tuned best = at(best_places(law_, points));
    if (points == 0) return best;
    const double place_mm = tuning_.plunge_in_place_mm();
    std::vector<double> places = best_places(law_, points - 1);
    if (!places.empty() && places.front() >= place_mm) return best;
    places.insert(places.begin(), place_mm);
    Tuned other = tuned_at(places, Begin::plunge_in);
    return other.time_s() < best.time_s() ? other : best;
  }

  [[nodiscard]] Tuned at(const std::vector<double>& places_mm) {
    return tuned_at(places_mm, Begin::tuned);
  }

  // The best with at most so many points, its places moved: steps shorter than a revolution may be
  // slower than fewer of them.
  [[nodiscard]] Tuned thorough(int points) {
    Tuned best = quick(points);
    for (const int fewer : {8, 9, 10, 11, 12, 14, 16, 20, 24, 32}) {
      if (fewer >= points) break;
      Tuned other = quick(fewer);
      if (other.time_s() < best.time_s()) best = std::move(other);
    }
    const auto tuned_like_best = [&](const std::vector<double>& places) {
      return tuning_.tuned(tuning_.steps_at(written_places(places, decimals_), law_), best.steps);
    };
    const auto time_s = [&](const std::vector<double>& places) {
      const Tuned tried = tuned_like_best(places);
      return tried.run.size_reached_s ? tried.time_s() : std::numeric_limits<double>::infinity();
    };
    Tuned moved = tuned_like_best(search_places(places_of(best), allowance_mm_, decimals_, time_s));
    return moved.run.size_reached_s && moved.time_s() < best.time_s() ? moved : best;
  }

 private:
  // The feed of the first step: tuned like the others, or the greatest.
  enum class Begin { tuned, plunge_in };

  [[nodiscard]] Tuned tuned_at(const std::vector<double>& places_mm, Begin begin) const {
    std::vector<Step> steps = tuning_.steps_at(written_places(places_mm, decimals_), law_);
    if (begin == Begin::plunge_in) steps.front().feed_mm_per_s = feeds_.max_mm_per_s;
    return tuning_.tuned(std::move(steps));
  }
  static std::vector<double> places_of(const Tuned& tuned) {
    std::vector<double> places;
    for (std::size_t k = 1; k < tuned.steps.size(); ++k) places.push_back(tuned.steps[k].begin_mm);
    return places;
  }

  const StaircaseTuning& tuning_;
  const QuasiSteadyLaw& law_;
  FeedRange feeds_;
  double allowance_mm_;
  int decimals_;
};

}  // namespace

InfeedLaw law_of_steps(const std::vector<Step>& steps, double end_mm) {
  InfeedLaw law;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double next_mm = k + 1 < steps.size() ? steps[k + 1].begin_mm : end_mm;
    law.push_back({steps[k].begin_mm, steps[k].feed_mm_per_s});
    law.push_back({next_mm, steps[k].feed_mm_per_s});
  }
  return law;
}

int usual_decimals(const GrindingProcess& process) {
  const double feed = steady_feed_mm_per_s(process, process.removal_end_mm2_per_rad);
  const int of_two_digits = static_cast<int>(std::ceil(-std::log10(feed))) + 1;
  return std::clamp(of_two_digits, decimals_min, decimals_max);
}

Staircase design_staircase(const GrindingProcess& process, double allowance_mm,
                           const FeedRange& feeds, const StaircaseOptions& options,
                           const PlungeOptions& simulation) {
  const int decimals = options.decimals.value_or(usual_decimals(process));
  const StaircaseTuning tuning(process, allowance_mm, feeds, decimals, simulation);
  const QuasiSteadyLaw quasi_steady = quasi_steady_law(process, allowance_mm, feeds);
  const bool is_given = !options.at_mm.empty();
  const int points = options.points.value_or(is_given ? 0 : points_worth_it(quasi_steady));
  StaircaseChoice choice(tuning, quasi_steady, feeds, allowance_mm, decimals);
  const bool is_thorough = options.effort == StaircaseEffort::thorough && points > 0;
  const StaircaseTuning::Tuned best =
      is_given      ? tuning.tuned(tuning.steps_at(options.at_mm, quasi_steady))
      : is_thorough ? choice.thorough(points)
                    : choice.quick(points);
  double end_mm = tuning.end_mm(best);
  if (simulation.spark_out_revolutions > 0.0 && best.run.size_reached_s) {
    const double quantum_mm = std::pow(10.0, -decimals);
    end_mm =
        rounded(end_for_spark_out(process, best.steps, end_mm, quantum_mm, simulation), decimals);
  }
  return {law_of_steps(begun_steps(best.steps, end_mm), end_mm),
          best.run.size_reached_s.has_value()};
}

}  // namespace stanok::process
