// Overlap of two straight legs in time: the axes set out on the second leg before the first one has
// ended.
//
// The first leg comes to rest at the corner and the second one starts there from rest. When the
// second begins `tau` before the first has ended, the axes move by the sum of both during tau: they
// cut the corner without standing, with continuous velocity and acceleration. Speeds, accelerations
// and jerks are sums too, and are checked axis by axis. Derivation:
// docs/developer/motion.md#overlap.
#pragma once

#include <optional>
#include <span>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// A corner that may be cut so, as far as geometry says.
struct OverlapCorner {
  // Both legs may be this far from the corner, the first still and the second already, at the same
  // instant; mm (or deg) along the path. It keeps the tolerance whatever the profiles are.
  double reach = 0.0;
  double speed_max = 0.0;  // of the path: the lower feed of both legs
  Point incoming{};        // machine axes per path length on the first leg
  Point outgoing{};        // and on the second
  bool rapid = false;      // one of the legs is rapid travel
};

// None where the legs are not both straight lines of the machine axes or the path is exact.
[[nodiscard]] std::optional<OverlapCorner> overlap_corner(const Segment& incoming,
                                                          const Segment& outgoing,
                                                          const Tolerance& tolerance,
                                                          const MotionConfig& config);

// The part of both jerks along the legs with which their sum keeps the limits of every axis, at
// most 1.
[[nodiscard]] double jerk_part_allowed(const OverlapCorner& corner, double jerk_incoming,
                                       double jerk_outgoing, const MotionConfig& config);

// The part of a chain's phases that ends, or begins, with rest at the corner: one change of speed.
[[nodiscard]] std::span<const Phase> last_ramp(std::span<const Phase> phases);
[[nodiscard]] std::span<const Phase> first_ramp(std::span<const Phase> phases);

// The longest overlap of `braking`, which ends with rest at the corner, and `starting`, which
// begins there, that keeps the reach and the limits of every axis; neither is farther from the
// corner than its room. 0: none.
struct OverlapRoom {
  double incoming = 0.0;  // length of the straight path before the corner
  double outgoing = 0.0;  // and behind it
};
[[nodiscard]] double overlap_duration(const OverlapCorner& corner, std::span<const Phase> braking,
                                      std::span<const Phase> starting, const OverlapRoom& room,
                                      const MotionConfig& config);

}  // namespace stanok::motion
