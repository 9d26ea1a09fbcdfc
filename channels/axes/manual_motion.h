// ManualMotion: the axes of one channel moved one by one, or along a straight line, outside of
// programs: jogging, homing.
//
// A continuous jog is a lease: it ends when it is not renewed. Homing goes through the axes in the
// order of the machine file, those of one order together; where an axis found its home switch or
// index pulse its drive is told what it reads there. Real-time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/axis_index.h"
#include "base/fixed_text.h"
#include "base/rt_safe.h"
#include "channels/axes/axis_homing.h"
#include "channels/axes/manual_axis.h"
#include "channels/axes/straight_jog.h"
#include "channels/contract/output.h"
#include "lang/contract/environment.h"
#include "motion/profile/axis_move.h"

namespace stanok::channels {

// A jog of one axis: with a velocity while it is renewed, or by an increment.
struct Jog {
  int axis = 0;
  double velocity = 0.0;   // mm/s or deg/s; its sign is the direction
  double increment = 0.0;  // mm or deg, > 0; 0: while it is renewed
};

class ManualMotion {
 public:
  enum class HomingState : std::uint8_t { running, succeeded, failed };

  void set_up(std::span<const ManualAxis> axes, double cycle_s);

  // Begins a jog from `from`, or renews the current one; the other direction stops that one.
  // Increments that come while one is under way add up, in either direction.
  // Returns why not: a code of the catalogue; empty: it goes.
  [[nodiscard]] std::string_view jog(const Jog& jog, double from, const AxisFeedback& drive)
      RT_SAFE;
  // As a handwheel was turned: adds a way, in either direction, to where the axis goes, as fast as
  // it can. What it could not follow at once is dropped, so that it stands soon after the wheel
  // does.
  [[nodiscard]] std::string_view turn(int axis, double way, double from, const AxisFeedback& drive)
      RT_SAFE;
  // The same for axes along a line: none of them moves otherwise meanwhile.
  [[nodiscard]] std::string_view jog(const JogLine& line, std::span<const AxisFeedback> drives,
                                     std::span<const kinematics::Jet> positions) RT_SAFE;
  // From `from` to a place of the axis, with the velocity of its search.
  void go(int axis, double from, double to) RT_SAFE;
  // All along a straight line to `to`, exactly; 0: with the velocity of their searches.
  void go(const AxisArray<double>& to, std::span<const kinematics::Jet> positions, double speed)
      RT_SAFE;
  // Homes these axes; those with an absolute encoder (order 0) are left out.
  void home(lang::AxisSet axes) RT_SAFE;
  // All axes come to rest; what was begun is over.
  void stop() RT_SAFE;
  // The same at once: nothing is moved any more.
  void break_off() RT_SAFE;

  [[nodiscard]] bool is_active() const RT_SAFE;
  // The jog under way takes it up: it is renewed, or goes further.
  [[nodiscard]] bool takes_up(const Jog& jog) const RT_SAFE;
  // Under a lease: of this axis, along a line, any.
  [[nodiscard]] bool jogs(int axis) const RT_SAFE;
  [[nodiscard]] bool jogs_along_line() const RT_SAFE { return line_.is_leased(); }
  [[nodiscard]] bool is_jogging() const RT_SAFE;
  [[nodiscard]] HomingState homing() const RT_SAFE { return homing_state_; }
  [[nodiscard]] const FixedText<128>& homing_fault() const RT_SAFE { return fault_; }

  // Once a cycle: positions of the axes that are moved are replaced.
  void advance(std::span<const AxisFeedback> drives, std::span<kinematics::Jet> positions) RT_SAFE;
  // What the drive of an axis shall take for its position.
  [[nodiscard]] const DriveReference& reference(int axis) const RT_SAFE {
    return states_[axis].reference;
  }

 private:
  enum class Task : std::uint8_t { none, jog, search, accept };
  struct AxisState {
    Task task = Task::none;
    motion::AxisMove move;
    AxisHoming homing;
    DriveReference reference;
    std::int64_t cycles_left = 0;  // of the lease, or for the drive to answer; < 0: no end
    bool adds = false;             // jog: by increments
    double end = 0.0;              // of the increment under way
    double more = 0.0;             // behind it, with its sign
    double speed = 0.0;            // of that
  };

  [[nodiscard]] std::string_view add(const Jog& jog, const AxisFeedback& drive) RT_SAFE;
  [[nodiscard]] double highest_speed(int axis, const AxisFeedback& drive) const RT_SAFE;
  static void aim_at(AxisState& state, double target, double speed) RT_SAFE;
  void go_on(AxisState& state, const ManualAxis& axis) RT_SAFE;
  void begin_next_order(std::span<const kinematics::Jet> positions) RT_SAFE;
  void search(std::size_t axis, const AxisFeedback& drive, kinematics::Jet& position) RT_SAFE;
  void accept(std::size_t axis, const AxisFeedback& drive, const kinematics::Jet& position) RT_SAFE;
  void run(AxisState& state, kinematics::Jet& position) RT_SAFE;
  void fail(std::size_t axis, std::string_view reason) RT_SAFE;

  std::size_t count_ = 0;
  double cycle_s_ = 0.001;
  AxisArray<ManualAxis> axes_{};
  AxisArray<AxisState> states_{};
  StraightJog line_;
  lang::AxisSet to_home_ = 0;  // whose turn has not come yet
  HomingState homing_state_ = HomingState::succeeded;
  FixedText<128> fault_;
};

}  // namespace stanok::channels
