// AxesPlace: where the axes are, by the point of the path and the transform of its segment, and
// where they stand while there is no path.
//
// Axes that a scheme gives only up to whole turns go on from where they were in the cycle before.
// Thread: the cycle. Owner: the interpolator. Invariant: axes that stand do not move until the path
// goes on or they are told to stand elsewhere.
#pragma once

#include "base/rt_safe.h"
#include "motion/path/path.h"

namespace stanok::motion {

class AxesPlace {
 public:
  // `lengths`, which outlive it, count for transforms that were made before them; nullptr: none do.
  explicit AxesPlace(const kinematics::LengthChanges* lengths = nullptr) : lengths_(lengths) {}

  // They stand there; `transform` gives the programmed point that belongs to `axes_M`.
  void stand_at(const Point& axes_M, const kinematics::Transform& transform) RT_SAFE;
  // They stand so far along a segment.
  void stand_on(const Segment& segment, double s) RT_SAFE;

  // The axes that belong to a point of a segment, from cycle to cycle.
  void follow(const Segment& segment, const JetPoint& point, JetPoint& axes) RT_SAFE;

  // Where they stand, at rest.
  void standing(JetPoint& point, JetPoint& axes) const RT_SAFE;
  // Of the segment on which they came to stand.
  [[nodiscard]] const BlockTag& tag() const RT_SAFE { return tag_; }
  [[nodiscard]] const SegmentProcess& process() const RT_SAFE { return process_; }

 private:
  [[nodiscard]] bool is_changed(const kinematics::Transform& transform) const RT_SAFE {
    return lengths_ != nullptr && lengths_->concern(transform.row);
  }
  void to_axes(const kinematics::Transform* transform, const JetPoint& point, JetPoint& axes) const
      RT_SAFE;
  void unwind(const kinematics::Transform* transform, JetPoint& axes) const RT_SAFE;

  const kinematics::LengthChanges* lengths_;
  Point last_axes_{};  // of the cycle before
  Point standing_point_{};
  Point standing_axes_{};
  BlockTag tag_;
  SegmentProcess process_;
};

}  // namespace stanok::motion
