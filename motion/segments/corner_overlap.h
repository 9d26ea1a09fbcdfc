// Overlap of two legs in time: the axes set out on the second leg before the first one has ended.
//
// The first leg comes to rest at the corner and the second one starts there from rest. When the
// second begins `tau` before the first has ended, the axes move by the sum of both during tau: they
// cut the corner without standing, with continuous velocity and acceleration. Speeds, accelerations
// and jerks are sums too, and are checked axis by axis: exactly on straight lines of the machine
// axes, at samples with a margin on arcs and where the tip is led through rotary axes. Derivation:
// docs/developer/motion.md#overlap.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "motion/path/path.h"
#include "motion/path/tolerance.h"

namespace stanok::motion {

// Whole blocks of which one at least is not a straight line of the machine axes.
struct CurvedLegs {
  Segment incoming;
  Segment outgoing;
};

// A corner that may be cut so, as far as geometry says.
struct OverlapCorner {
  // Both legs may be this far from the corner, the first still and the second already, at the same
  // instant; mm (or deg) along the path. It keeps the tolerance whatever the profiles are.
  double reach = 0.0;
  double speed_max = 0.0;  // of the path: the lower feed of both legs
  Point incoming{};        // machine axes per path length on the first leg, at the corner
  Point outgoing{};        // and on the second
  bool rapid = false;      // one of the legs is rapid travel
  // Where they are, an overlap stays within this distance of the corner.
  double distance_max = unlimited;
  std::optional<CurvedLegs> curved = std::nullopt;
};

// Null where the legs are not both lines or arcs, the path is exact, or the scheme has places where
// an axis would have to jump.
[[nodiscard]] std::shared_ptr<const OverlapCorner> overlap_corner(const Segment& incoming,
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
  double incoming = 0.0;  // length of the path before the corner that is the leg's own
  double outgoing = 0.0;  // and behind it
};
[[nodiscard]] double overlap_duration(const OverlapCorner& corner, std::span<const Phase> braking,
                                      std::span<const Phase> starting, const OverlapRoom& room,
                                      const MotionConfig& config);

}  // namespace stanok::motion
