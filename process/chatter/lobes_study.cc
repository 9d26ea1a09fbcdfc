#include "process/chatter/lobes_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "process/chatter/grinding_lobes.h"

namespace stanok::process {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double depth_seen = 8.0;  // of the zeroth-order limit, where the motion itself is asked
constexpr double safe_part = 0.9;   // of a limit, that a proposed speed leaves unused a tenth of
constexpr std::size_t best_max = 5;

// Limits by either method.
class Limits {
 public:
  explicit Limits(const LobesRequest& request)
      : method_(request.method), lobes_(request.process), motion_(request.process) {
    if (request.process.kind == CutKind::grinding) {
      grinding_.emplace(request.process);
      return;
    }
    const auto least = lobes_.least_limit();
    depth_max_ = least ? depth_seen * least->depth_mm : unlimited;
  }

  [[nodiscard]] LimitAt at(double speed) const {
    const auto limit = grinding_ ? grinding_->limit_at(speed) : lobes_.limit_at(speed);
    if (grinding_ || method_ == LobesMethod::zeroth_order || depth_max_ == unlimited) {
      if (!limit) return {.speed_rev_per_min = speed, .depth_mm = unlimited};
      return {
          .speed_rev_per_min = speed, .depth_mm = limit->depth_mm, .chatter_hz = limit->chatter_hz};
    }
    const double depth = motion_.limit_at(speed, depth_max_);
    return {.speed_rev_per_min = speed, .depth_mm = depth < depth_max_ ? depth : unlimited};
  }

 private:
  LobesMethod method_;
  StabilityLobes lobes_;
  SemiDiscretisation motion_;
  std::optional<GrindingLobes> grinding_;
  double depth_max_ = 0.0;
};

// Speeds evenly spaced in their logarithm, as lobes are.
double speed_at(const LobesRequest& request, int k) {
  const double part = request.count > 1 ? static_cast<double>(k) / (request.count - 1) : 0.0;
  return request.speed_from * std::pow(request.speed_to / request.speed_from, part);
}

std::vector<LimitAt> peaks(const std::vector<LimitAt>& limits) {
  std::vector<LimitAt> best;
  for (std::size_t k = 1; k + 1 < limits.size(); ++k) {
    const double depth = limits[k].depth_mm;
    if (depth > limits[k - 1].depth_mm && depth >= limits[k + 1].depth_mm)
      best.push_back(limits[k]);
  }
  std::ranges::stable_sort(best, std::greater{}, &LimitAt::depth_mm);
  if (best.size() > best_max) best.resize(best_max);
  return best;
}

PlannedCut judge(const LobePoint& cut, const Limits& limits, const std::vector<LimitAt>& known) {
  PlannedCut judged{.speed_rev_per_min = cut.speed_rev_per_min,
                    .depth_mm = cut.depth_mm,
                    .limit_mm = limits.at(cut.speed_rev_per_min).depth_mm};
  if (judged.is_stable()) return judged;
  const auto away = [&](const LimitAt& limit) {
    return std::abs(std::log(limit.speed_rev_per_min / cut.speed_rev_per_min));
  };
  for (const LimitAt& limit : known) {
    if (cut.depth_mm > safe_part * limit.depth_mm) continue;
    const LimitAt best{.speed_rev_per_min = judged.better_speed};
    if (judged.better_speed == 0.0 || away(limit) < away(best))
      judged.better_speed = limit.speed_rev_per_min;
  }
  return judged;
}

}  // namespace

LobesStudy study_lobes(const LobesRequest& request, const std::function<bool()>& gives_up) {
  const Limits limits(request);
  LobesStudy study;
  study.kind = request.process.kind;
  study.always_mm = unlimited;
  for (int k = 0; k < request.count && !gives_up(); ++k) {
    study.limits.push_back(limits.at(speed_at(request, k)));
    study.always_mm = std::min(study.always_mm, study.limits.back().depth_mm);
  }
  study.best = peaks(study.limits);
  for (const LobePoint& cut : request.programmed)
    study.cuts.push_back(judge(cut, limits, study.limits));
  return study;
}

}  // namespace stanok::process
