// What lies ahead of the cycle on the committed plan: gates, and places where the plan is run again
// as it was made. Real-time.
#pragma once

#include "base/rt_safe.h"
#include "motion/interpolation/path_cursor.h"
#include "motion/path/path.h"
#include "motion/path/path_queue.h"
#include "motion/profile/feed_control.h"
#include "motion/profile/profile.h"

namespace stanok::motion {

// Where the first segment behind a gate begins, along the current chunk, if that is so near that
// the motion has to prepare for it; else far away.
[[nodiscard]] double gate_ahead(const PathQueue& queue, const PathCursor& cursor,
                                const FeedControl& control, const PathMotion& motion) RT_SAFE;

// What the plan leaves for a change of its pace: within the next cycle of `time`, and with all that
// comes so soon that a change has to be taken away before. The current phase began `elapsed` ago,
// the motion is at `s` along the current chunk.
struct PaceRoom {
  PaceLimits here{};
  PaceLimits ahead{};
};
[[nodiscard]] PaceRoom pace_room(const PathQueue& queue, const PathCursor& cursor, double s,
                                 double elapsed, double time) RT_SAFE;

// The part of its own speed that overrides ask of the plan on a segment, at most 1.
[[nodiscard]] double asked_pace(const Segment& segment, const FeedControl& asked) RT_SAFE;

// A stop brakes along the plan (motion/interpolation/stop_brake.h): where that leaves the limits of
// segments, or follows a curve at one speed. Straight segments and ramps are braked by the override
// planner, which minds gates and the end of what is known.
[[nodiscard]] bool brakes_along_plan(const PathQueue& queue, const PathCursor& cursor,
                                     const FeedControl& asked, const PathMotion& motion) RT_SAFE;

// The feed may be higher than planned, and nothing is asked to be slower; no law forms it.
[[nodiscard]] bool raises_feed(const Segment& segment, const FeedControl& asked) RT_SAFE;

// The plan holds the programmed feed there: an override may raise it.
[[nodiscard]] bool holds_feed(const Phase& phase, const Segment& segment) RT_SAFE;

// What a brake to rest from the speed `v` takes under the limits of all segments that it touches;
// `part`: of the programmed feeds, for which the limits hold.
[[nodiscard]] double rest_distance(const PathQueue& queue, const PathCursor& cursor, double s,
                                   double v, double part) RT_SAFE;

// Where the plan is next run as it was made: it goes over from an even speed `v` to something else.
struct PlanStart {
  double s = unlimited;  // along the current chunk
  double v = 0.0;
};
// As far as `farthest`. `every`: plans made of ramps, too, and not only those that are run at a
// pace.
enum class PlanKind : std::uint8_t { paced, every };
[[nodiscard]] PlanStart next_plan_start(const PathQueue& queue, const PathCursor& cursor,
                                        PlanKind kind, double s, double farthest) RT_SAFE;

}  // namespace stanok::motion
