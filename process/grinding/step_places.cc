// Where the steps of a staircase end: dynamic programming over the places of the quasi-steady law.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/place.h"
#include "process/grinding/force_law.h"
#include "process/grinding/staircase.h"

namespace stanok::process {
namespace {

constexpr int places = 400;  // of the quasi-steady law
// The removal settles to that of the last feed within this many revolutions, to a few per cent.
constexpr double finishing_revolutions = 5.0;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Index of the place of the law nearest to x.
std::size_t nearest_place(const QuasiSteadyLaw& law, double x_mm) {
  const auto after = std::lower_bound(law.x_mm.begin(), law.x_mm.end(), x_mm, std::greater<>());
  return std::min(checked_size(after - law.x_mm.begin()), law.x_mm.size() - 1);
}

// Least time to come from each place to the end with a number of switch points, and the place of
// the first of them.
struct Stage {
  std::vector<double> time_s;
  std::vector<std::size_t> next;
};

double step_time_s(const QuasiSteadyLaw& law, std::size_t begin, std::size_t end) {
  return (law.x_mm[begin] - law.x_mm[end]) / law.feed_mm_per_s[end];
}

Stage last_stage(const QuasiSteadyLaw& law) {
  const std::size_t end = law.x_mm.size() - 1;
  Stage stage{std::vector<double>(end + 1), std::vector<std::size_t>(end + 1, end)};
  for (std::size_t i = 0; i <= end; ++i) {
    const bool is_too_short = i > 0 && law.x_mm[i] - law.x_mm[end] < law.last_step_min_mm;
    stage.time_s[i] = is_too_short ? infinity : step_time_s(law, i, end);
  }
  return stage;
}

// One switch point more than `after`.
Stage earlier_stage(const QuasiSteadyLaw& law, const Stage& after) {
  const std::size_t count = law.x_mm.size();
  Stage stage{std::vector<double>(count, infinity), std::vector<std::size_t>(count, count - 1)};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      const double time_s = step_time_s(law, i, j) + after.time_s[j];
      if (time_s >= stage.time_s[i]) continue;
      stage.time_s[i] = time_s;
      stage.next[i] = j;
    }
  }
  return stage;
}

}  // namespace

// At the allowance H the removal D(H) bends the system by P/C, so that X = H - P/C there. Below
// H = 0 the feed of the end goes on, for the layer of the last revolution.
QuasiSteadyLaw quasi_steady_law(const GrindingProcess& process, double allowance_mm,
                                const FeedRange& feeds) {
  const Boundary boundary(process);
  const ForceLaw force(process);
  const double stiffness_n_per_mm = process.stiffness_n_per_m / 1000.0;
  QuasiSteadyLaw law;
  const auto add = [&](double x_mm, double removal) {
    const double feed =
        std::clamp(steady_feed_mm_per_s(process, removal), feeds.min_mm_per_s, feeds.max_mm_per_s);
    if (law.x_mm.empty() || x_mm < law.x_mm.back()) {
      law.x_mm.push_back(x_mm);
      law.feed_mm_per_s.push_back(feed);
    } else {
      law.feed_mm_per_s.back() = std::min(law.feed_mm_per_s.back(), feed);
    }
  };
  for (int k = 0; k <= places; ++k) {
    const double H = allowance_mm * (1.0 - static_cast<double>(k) / places);
    const double D = boundary.at(H);
    add(k == 0 ? allowance_mm : H - force.force_n(D) / stiffness_n_per_mm, D);
  }
  const double layer_mm = boundary.removal_end() / removal_radius_mm(process);
  add(law.x_mm.back() - layer_mm, boundary.removal_end());
  law.last_step_min_mm = finishing_revolutions * layer_mm;
  return law;
}

std::vector<double> best_places(const QuasiSteadyLaw& law, int points) {
  std::vector<Stage> stages{last_stage(law)};
  for (int k = 0; k < points; ++k) stages.push_back(earlier_stage(law, stages.back()));
  std::vector<double> chosen;
  std::size_t place = 0;
  for (auto stage = stages.rbegin(); stage + 1 != stages.rend(); ++stage) {
    place = stage->next[place];
    chosen.push_back(law.x_mm[place]);
  }
  return chosen;
}

double steps_time_s(const QuasiSteadyLaw& law, const std::vector<double>& places_mm) {
  double time_s = 0.0;
  std::size_t begin = 0;
  for (const double place_mm : places_mm) {
    const std::size_t end = nearest_place(law, place_mm);
    time_s += step_time_s(law, begin, end);
    begin = end;
  }
  return time_s + step_time_s(law, begin, law.x_mm.size() - 1);
}

}  // namespace stanok::process
