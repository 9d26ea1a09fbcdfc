// Fitting a blend to the tolerance (motion/path/blend.h).
//
// t and k are tangent and curvature (q', q'') of the two segments at the corner; a blend of reach L
// deviates by about bow * L * |t_out - t_in| + sag * L^2 * |k_out - k_in|, for lines exactly so.
#include "motion/path/blend.h"

#include <algorithm>
#include <cmath>

#include "motion/path/deviation.h"

namespace stanok::motion {
namespace {

constexpr double bow = (1.0 + 5.0 * blend_beta + 10.0 * blend_gamma) / 32.0;
constexpr double sag = 1.0 / 64.0;

constexpr double reach_min = 1e-5;  // mm: below, the stored points no longer resolve the curve
constexpr int fit_attempts = 16;

Blend blend_of_reach(const Segment& incoming, const Segment& outgoing, double reach) {
  return {blend_curve(incoming.geometry.metric, contact_at(incoming, incoming.length - reach),
                      contact_at(outgoing, reach), reach),
          reach};
}

}  // namespace

std::optional<Blend> fit_blend(const Segment& incoming, const Segment& outgoing, double reach_max,
                               const Tolerance& tolerance, const MotionConfig& config) {
  const Tolerance used = used_by_curves(tolerance);
  const Growth grown = growth(incoming, outgoing, {.kink = bow, .step = sag}, used, config);
  double reach = std::min({reach_max, grown.reach(), replaceable(incoming), replaceable(outgoing)});
  const bool between_lines =
      incoming.geometry.kind == SegmentKind::line && outgoing.geometry.kind == SegmentKind::line;
  for (int i = 0; i < fit_attempts && reach >= reach_min; ++i) {
    const Blend blend = blend_of_reach(incoming, outgoing, reach);
    if (between_lines) return blend;
    const double share =
        deviation_share({&blend.shape, 1}, blend.reach, incoming, outgoing, used, config);
    if (share <= 1.0) return blend;
    reach *= std::clamp(0.98 * std::pow(share, -1.0 / grown.exponent(reach)), 0.1, 0.9);
  }
  return std::nullopt;
}

}  // namespace stanok::motion
