// Channel: one channel's part of the real-time cycle. Items and path in, setpoints out; allocates
// nothing.
//
// Here stands the order of a cycle; the work is that of its parts (channels/cycle/cycle_parts.h),
// which it shows to the coordinator. That asks for effects between the halves of a cycle, and takes
// the requests of the channel's own program through items().request(). Thread: the real-time cycle.
// Owner: the machine.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>

#include "channels/contract/clock_gap.h"
#include "channels/cycle/announcements.h"
#include "channels/cycle/arrival_window.h"
#include "channels/cycle/cycle_parts.h"
#include "channels/cycle/item_worker.h"
#include "channels/cycle/refill.h"

namespace stanok::channels {

class Channel : public CycleParts {
 public:
  // `schemes` is written by nobody after construction; the scheme active at power-on is `scheme`.
  Channel(const motion::MotionConfig& motion, const ChannelConstants& constants,
          const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes, int scheme,
          ChannelLink& link, const CycleBooks& books);

  // The cycle, in this order.
  void see_arrivals(const Arrivals& recorded = ArrivalWindow::all) RT_SAFE {
    arrivals_.open(recorded);
  }
  void see_gap(const ClockGap& gap) RT_SAFE;                          // only where there was one
  void watch_drives(std::span<const AxisFeedback> feedback) RT_SAFE;  // empty: ideal drives
  void sense(NumberedSpan<const SpindleSensors> sensors) RT_SAFE { process.sense(sensors); }
  void advance(std::int64_t cycle, Period period) RT_SAFE;
  void fill(ChannelOutput& output) const RT_SAFE;

  // How far its preparation is, in a run that is repeated. Not of the cycle.
  [[nodiscard]] const ArrivalWindow& window() const { return arrivals_; }

  // Effects that concern several parts.
  void power(Power to) RT_SAFE;  // off: axes braked and drives off at standstill
  [[nodiscard]] YieldedAxis yield_axis(int axis) RT_SAFE { return axes.yield(axis); }
  void take_axis(int axis, const YieldedAxis& yielded) RT_SAFE;
  // By hand; see jogging.h, too.
  void home(lang::AxisSet axes) RT_SAFE;
  // Of the axis of a spindle; false: the machine file gives it no home switch or index pulse.
  [[nodiscard]] bool begin_homing_of_spindle(int id) RT_SAFE;
  void return_to_parking() RT_SAFE;
  void set_single_block(Switch to) RT_SAFE;

  [[nodiscard]] int id() const RT_SAFE { return constants.id; }
  [[nodiscard]] const RunState& state() const RT_SAFE { return run.state(); }
  [[nodiscard]] bool is_quiet() const RT_SAFE;  // nothing under way at all
  // A probe is awaited, or axes are homed.
  [[nodiscard]] bool looks_for_contact() const RT_SAFE;
  // M99 in the main program: from its first line, in the same run.
  [[nodiscard]] bool begins_again() const RT_SAFE { return !constants.stops_go_on; }
  [[nodiscard]] bool has_ended(std::uint32_t run) const RT_SAFE {
    return run != runs.run() || !state().is_running();
  }

  [[nodiscard]] ItemWorker& items() RT_SAFE { return items_; }
  [[nodiscard]] const ItemWorker& items() const RT_SAFE { return items_; }

 private:
  [[nodiscard]] bool is_at_rest() const RT_SAFE;  // no run, no reset, no switch, no motion
  void continue_reset() RT_SAFE;
  void remove_power_when_it_lasts() RT_SAFE;
  void forget_path() RT_SAFE;
  void stop_where_probe_meets_something() RT_SAFE;
  void take_step() RT_SAFE;
  void move() RT_SAFE;
  [[nodiscard]] motion::FeedControl feed_control() RT_SAFE;
  [[nodiscard]] std::uint64_t closed_from_block() const RT_SAFE;
  void tell_when_it_runs_dry() RT_SAFE;
  void follow_thread() RT_SAFE;
  void control_force() RT_SAFE;
  void stop_at_step() RT_SAFE;
  void work_items() RT_SAFE;
  void work_marks(Period period) RT_SAFE;
  void announce() RT_SAFE;
  void name_program() RT_SAFE;

  ItemWorker items_;
  Announcements announcements_;
  ArrivalWindow arrivals_;
  Refill refill_;
  bool rests_after_gap_ = false;
};

}  // namespace stanok::channels
