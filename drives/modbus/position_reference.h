// PositionReference: whether the counter of a drive tells the position of its machine axis.
//
// A drive says so itself, or the control has found the reference and given the offset between what
// the drive counts and the position of the machine. It is no longer so when the axis, out of sight,
// went further than it can have moved: `reach`, as the drive counts. Whether an incremental encoder
// has counted on during a loss, or begun anew, nobody can tell. Owned by the exchange of one axis,
// on the bus thread.
#pragma once

#include "base/rt_safe.h"
#include "drives/drive.h"

namespace stanok::drives {

// Of positions, as the drive counts.
struct Band {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool excludes(double counted) const RT_SAFE {
    return counted < low || counted > high;
  }
};

enum class Encoder : bool { incremental, absolute };

class PositionReference {
 public:
  explicit PositionReference(Encoder encoder) : encoder_(encoder) {}

  // What the cycle says of the position; the offset counts while it accepts it.
  void take(const DriveTarget& target) RT_SAFE;
  // Contact ends: where the axis can be until it comes to rest.
  void lose_sight(const Band& reach) RT_SAFE;
  // The drive counts that, for the first time after a loss.
  void see_again(double counted) RT_SAFE { moved_out_of_sight_ |= reach_.excludes(counted); }
  // An answer came while the cycle accepts the position.
  void confirm() RT_SAFE;

  [[nodiscard]] double offset() const RT_SAFE { return offset_; }
  [[nodiscard]] bool is_accepted() const RT_SAFE { return accepted_; }
  // By the control, for a drive that does not know it itself.
  [[nodiscard]] bool is_found() const RT_SAFE { return found_; }
  // Whoever knew it: it holds no more until it is confirmed.
  [[nodiscard]] bool has_moved_out_of_sight() const RT_SAFE { return moved_out_of_sight_; }

 private:
  Encoder encoder_;
  double offset_ = 0.0;
  Band reach_{};  // out of sight
  bool accepted_ = false;
  bool found_ = false;
  bool moved_out_of_sight_ = false;
};

}  // namespace stanok::drives
