#include "process/grinding/optimiser.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"

namespace stanok::process {
namespace {

// Nodes of the law over X; between them it is linear.
constexpr int nodes = 300;

// An iteration that changes the error by less than this part has settled.
constexpr double settled_change = 0.01;
// Growing iterations after which there is nothing to be gained.
constexpr int growing_max = 3;

InfeedLaw first_law(const GrindingProcess& process, double allowance_mm, double feed_mm_per_s) {
  const double end_mm = -overrun_max_mm(process);
  InfeedLaw law;
  for (int k = 0; k <= nodes; ++k) {
    const double part = static_cast<double>(k) / nodes;
    law.push_back({allowance_mm + part * (end_mm - allowance_mm), feed_mm_per_s});
  }
  return law;
}

// Mean of the error over the samples around each node of the law, weighted by their nearness.
class NodeErrors {
 public:
  explicit NodeErrors(const InfeedLaw& law)
      : begin_mm_(law.front().x_mm),
        spacing_mm_((law.front().x_mm - law.back().x_mm) / (static_cast<double>(law.size()) - 1)),
        sum_(law.size(), 0.0),
        weight_(law.size(), 0.0) {}

  void add(double x_mm, double error) {
    const double place =
        std::clamp((begin_mm_ - x_mm) / spacing_mm_, 0.0, static_cast<double>(sum_.size()) - 1.0);
    const auto node = std::min(checked_size(place), sum_.size() - 2);
    const double part = place - static_cast<double>(node);
    sum_[node] += (1.0 - part) * error;
    weight_[node] += 1.0 - part;
    sum_[node + 1] += part * error;
    weight_[node + 1] += part;
  }
  // 0 where the cycle did not come by.
  [[nodiscard]] double at(std::size_t node) const {
    return weight_[node] > 0.0 ? sum_[node] / weight_[node] : 0.0;
  }

 private:
  double begin_mm_;
  double spacing_mm_;
  std::vector<double> sum_;
  std::vector<double> weight_;
};

class Optimisation {
 public:
  Optimisation(const GrindingProcess& process, const FeedRange& feeds,
               const OptimiserOptions& options, PlungeOptions simulation)
      : process_(process),
        boundary_(process),
        feeds_(feeds),
        options_(options),
        simulation_(std::move(simulation)) {
    simulation_.at_end = InfeedTravel::AtEnd::goes_on;
  }

  [[nodiscard]] OptimalLaw run(InfeedLaw law) && {
    for (int number = 0; number <= options_.iterations_max; ++number) {
      PlungeRun plunge = simulate_plunge(process_, law, simulation_);
      const Iteration iteration = assessed(number, plunge);
      const InfeedLaw next = corrected(law, plunge);
      keep_if_best(iteration, std::move(law), std::move(plunge));
      result_.iterations.push_back(iteration);
      if (options_.on_iteration) options_.on_iteration(iteration);
      if (is_settled()) break;
      law = next;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Iteration assessed(int number, const PlungeRun& plunge) const {
    Iteration iteration{.number = number};
    double squares = 0.0;
    int count = 0;
    for (const PlungeSample& sample : plunge.samples) {
      if (sample.time_s < plunge_in_s(process_)) continue;
      const double error = 1.0 - sample.removal_mm2_per_rad / boundary_.at(sample.allowance_mm);
      squares += error * error;
      iteration.worst = std::max(iteration.worst, std::abs(error));
      ++count;
    }
    iteration.rms = std::sqrt(squares / std::max(count, 1));
    return iteration;
  }

  [[nodiscard]] InfeedLaw corrected(const InfeedLaw& law, const PlungeRun& plunge) const {
    NodeErrors errors(law);
    for (const PlungeSample& sample : plunge.samples) {
      errors.add(sample.x_mm, boundary_.at(sample.allowance_mm) - sample.removal_mm2_per_rad);
    }
    InfeedLaw next = law;
    for (std::size_t k = 0; k < next.size(); ++k) {
      const double change = options_.feedback * steady_feed_mm_per_s(process_, errors.at(k));
      next[k].feed_mm_per_s =
          std::clamp(next[k].feed_mm_per_s + change, feeds_.min_mm_per_s, feeds_.max_mm_per_s);
    }
    return next;
  }

  void keep_if_best(const Iteration& iteration, InfeedLaw law, PlungeRun plunge) {
    const bool is_best = result_.iterations.empty() || iteration.rms < result_.best.rms;
    growing_ = is_best ? 0 : growing_ + 1;
    if (!is_best) return;
    change_ = result_.iterations.empty() ? 1.0 : 1.0 - iteration.rms / result_.best.rms;
    result_.best = iteration;
    result_.law = std::move(law);
    result_.run = std::move(plunge);
  }

  [[nodiscard]] bool is_settled() {
    if (!options_.stops_when_growing) return false;
    if (growing_ >= growing_max) {
      result_.settling = Settling::grew;
      return true;
    }
    if (growing_ == 0 && change_ < settled_change) {
      result_.settling = Settling::converged;
      return true;
    }
    return false;
  }

  const GrindingProcess& process_;
  Boundary boundary_;
  FeedRange feeds_;
  const OptimiserOptions& options_;
  PlungeOptions simulation_;
  OptimalLaw result_;
  int growing_ = 0;
  double change_ = 1.0;  // part by which the best error fell
};

}  // namespace

OptimalLaw optimal_law(const GrindingProcess& process, double allowance_mm, const FeedRange& feeds,
                       const OptimiserOptions& options, const PlungeOptions& simulation) {
  const double first_feed =
      std::clamp(steady_feed_mm_per_s(process, Boundary(process).removal_max()), feeds.min_mm_per_s,
                 feeds.max_mm_per_s);
  return Optimisation(process, feeds, options, simulation)
      .run(first_law(process, allowance_mm, first_feed));
}

}  // namespace stanok::process
