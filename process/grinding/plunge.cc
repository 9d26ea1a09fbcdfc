#include "process/grinding/plunge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/place.h"
#include "process/grinding/elastic_system.h"

namespace stanok::process {
namespace {

// The part as the depth of its surface at each of a whole number of angles.
class Surface {
 public:
  Surface(int angles, double allowance_mm)
      : depth_mm_(checked_size(angles), 0.0),
        allowance_mm_(allowance_mm),
        oversize_(depth_mm_.size()) {}

  // The depth ground so far at the angle that is under the wheel.
  [[nodiscard]] double depth_mm() const { return depth_mm_[angle_]; }
  // Takes a layer there and turns by one angle.
  void grind(double layer_mm) {
    double& depth = depth_mm_[angle_];
    const bool was_oversize = depth < allowance_mm_;
    depth += layer_mm;
    if (was_oversize && depth >= allowance_mm_) --oversize_;
    angle_ = angle_ + 1 == depth_mm_.size() ? 0 : angle_ + 1;
  }
  [[nodiscard]] bool is_at_size() const { return oversize_ == 0; }
  [[nodiscard]] double residual_max_mm() const {
    return allowance_mm_ - *std::min_element(depth_mm_.begin(), depth_mm_.end());
  }
  [[nodiscard]] double residual_min_mm() const {
    return allowance_mm_ - *std::max_element(depth_mm_.begin(), depth_mm_.end());
  }
  [[nodiscard]] double residual_mean_mm() const {
    double sum = 0.0;
    for (const double depth : depth_mm_) sum += depth;
    return allowance_mm_ - sum / static_cast<double>(depth_mm_.size());
  }

 private:
  std::vector<double> depth_mm_;
  double allowance_mm_;
  std::size_t oversize_;  // how many angles have something left
  std::size_t angle_ = 0;
};

class Plunge {
 public:
  Plunge(const GrindingProcess& process, const InfeedLaw& law, const PlungeOptions& options)
      : options_(options),
        radius_mm_(removal_radius_mm(process)),
        revolution_s_(revolution_s(process)),
        plunge_in_s_(plunge_in_s(process)),
        steps_per_revolution_(static_cast<int>(std::ceil(revolution_s_ / options.time_step_max_s))),
        step_s_(revolution_s_ / steps_per_revolution_),
        begin_mm_(law.front().x_mm),
        travel_(law, options.at_end),
        system_(process, step_s_),
        surface_(steps_per_revolution_, begin_mm_) {}

  [[nodiscard]] PlungeRun run() && {
    const double time_max_s =
        options_.at_end == InfeedTravel::AtEnd::goes_on ? options_.time_max_s : planned_time_s();
    run_.samples.reserve(checked_size(planned_time_s() / step_s_) + 2);
    for (std::int64_t step = 1; !is_done(time_max_s); ++step) {
      advance(static_cast<double>(step) * step_s_);
    }
    run_.residual_mm = surface_.residual_max_mm();
    run_.residual_min_mm = surface_.residual_min_mm();
    run_.residual_mean_mm = surface_.residual_mean_mm();
    return std::move(run_);
  }

 private:
  [[nodiscard]] double planned_time_s() const {
    return std::min(options_.time_max_s,
                    law_time_s(travel_.law()) + options_.spark_out_revolutions * revolution_s_);
  }
  // To half a step, so that a cycle is not one step longer than its law for want of a last bit.
  [[nodiscard]] bool is_done(double time_max_s) const {
    if (run_.time_s > time_max_s - 0.5 * step_s_) return true;
    return options_.at_end == InfeedTravel::AtEnd::goes_on && run_.size_reached_s.has_value();
  }

  void advance(double time_s) {
    travel_.advance(step_s_);
    run_.time_s = time_s;
    const double rigid_depth_mm = begin_mm_ - travel_.x_mm() - run_.wear_mm;
    const double before_mm = surface_.depth_mm();
    const double layer_mm = system_.advance(rigid_depth_mm - before_mm);
    surface_.grind(layer_mm);
    const double removal = radius_mm_ * layer_mm;
    count_contact(layer_mm);
    run_.volume_mm2 += removal * 2.0 * std::numbers::pi / steps_per_revolution_;
    run_.force_max_n = std::max(run_.force_max_n, system_.force_n());
    if (options_.wear_rate_mm_per_s) run_.wear_mm += options_.wear_rate_mm_per_s(removal) * step_s_;
    if (!run_.size_reached_s && surface_.is_at_size()) run_.size_reached_s = time_s;
    run_.samples.push_back({.time_s = time_s,
                            .x_mm = travel_.x_mm(),
                            .allowance_mm = begin_mm_ - rigid_depth_mm + system_.deflection_mm(),
                            .feed_mm_per_s = travel_.feed_mm_per_s(),
                            .removal_mm2_per_rad = removal,
                            .deflection_mm = system_.deflection_mm()});
  }

  void count_contact(double layer_mm) {
    const bool has_contact = layer_mm > 0.0;
    const bool is_fed = run_.time_s > plunge_in_s_ && !travel_.is_at_end();
    if (had_contact_ && !has_contact && is_fed) ++run_.contact_losses;
    had_contact_ = has_contact;
  }

  const PlungeOptions& options_;
  double radius_mm_;
  double revolution_s_;
  double plunge_in_s_;
  int steps_per_revolution_;
  double step_s_;
  double begin_mm_;
  InfeedTravel travel_;
  ElasticSystem system_;
  Surface surface_;
  PlungeRun run_;
  bool had_contact_ = false;
};

}  // namespace

PlungeRun simulate_plunge(const GrindingProcess& process, const InfeedLaw& law,
                          const PlungeOptions& options) {
  return Plunge(process, law, options).run();
}

}  // namespace stanok::process
