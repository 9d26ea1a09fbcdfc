// Channel: one channel's part of the real-time cycle. Items and path in, set-points out; allocates
// nothing.
//
// States after docs/reference/language.md#kinematics-and-channels: idle, ready, running, held,
// alarm. The coordinator asks it for effects (start, hold, reset, switch) between cycles' halves;
// requests of the channel's own program are taken by the coordinator through `request()`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "channels/axes/channel_figures.h"
#include "channels/axes/spindle.h"
#include "channels/contract/command_rules.h"
#include "channels/contract/output.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/mark_worker.h"
#include "channels/cycle/stepper.h"
#include "channels/messages/channel_link.h"
#include "motion/automatic_feed.h"
#include "motion/feed_modifier.h"
#include "motion/interpolator.h"
#include "motion/position_regulator.h"
#include "motion/spindle_observer.h"

namespace stanok::channels {

class Channel {
 public:
  // `schemes` is written by nobody after construction; the scheme active at power-on is `scheme`.
  Channel(const motion::MotionConfig& motion, const ChannelFigures& figures,
          const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes, int scheme,
          ChannelLink& link, CycleBooks books);

  // Before the first cycle only.
  void select_scheme(int scheme);

  // What the preparation has made so far is seen in this cycle; of a recorded run, what that saw.
  // Whether the preparation has made what a recorded cycle saw of it. Not of the cycle.
  [[nodiscard]] bool has_prepared(const Arrivals& recorded) const;
  void see_arrivals(const Arrivals& recorded = {.resets = 0,
                                                .chunks = Arrivals::everything,
                                                .items = Arrivals::everything,
                                                .riders = Arrivals::everything,
                                                .remarks = Arrivals::everything}) RT_SAFE;
  void advance(std::int64_t cycle) RT_SAFE;
  // A drive that is lost or faulty stops the channel along its path. Empty feedback: ideal drives.
  void watch_drives(std::span<const AxisFeedback> feedback) RT_SAFE;
  // The sensors of all spindles of the machine.
  void sense(std::span<const SpindleSensors> sensors) RT_SAFE;
  void fill(ChannelOutput& output) const RT_SAFE;

  // Effects, asked for by the coordinator. Each is legal in every state or says so.
  void power(bool on) RT_SAFE;  // off: axes braked and drives off at standstill
  void begin_load(const ShortText& text, Job job) RT_SAFE;
  // Where the loaded program begins when it is started the next time.
  void begin_search(const ShortText& target, bool calculates, double pass) RT_SAFE;
  void begin_run(Job job) RT_SAFE;  // of what was loaded last as such a job
  void hold(HoldCause cause) RT_SAFE;
  // Feed hold of an operator: waits where the program does not let it act (M53). What moves outside
  // of programs is over with it.
  void hold_by_operator() RT_SAFE;
  void resume() RT_SAFE;
  // Reaction to a fault: stops along the path, forgets the run, drives off; the alarm stays until
  // reset.
  void fault(std::string_view code, std::string_view text) RT_SAFE;
  // The same by an operator, drives off; told also when a fault is being reacted to.
  void stop_in_emergency() RT_SAFE;
  void begin_reset() RT_SAFE;  // stops along the path, then forgets the run and its alarms
  void begin_stop() RT_SAFE;   // the same; alarms stay
  void begin_switch(int scheme) RT_SAFE;
  void power_off_at_rest() RT_SAFE { power_off_wanted_ = true; }
  void answer(const ChannelAnswer& answer) RT_SAFE;
  void fail_run(std::string_view code, std::string_view text, const motion::BlockTag& tag) RT_SAFE;
  void raise_alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
      RT_SAFE;
  // An alarm that leaves the run as it is.
  void record_alarm(std::string_view code, std::string_view text, const motion::BlockTag& tag)
      RT_SAFE;
  void set_feed_override(double factor) RT_SAFE { control_.feed_override = factor; }
  void set_rapid_override(double factor) RT_SAFE { control_.rapid_override = factor; }
  void set_spindle_override(double factor) RT_SAFE;
  // Until the end of the run, or of the next one.
  void interrupt_feed(const motion::InterruptionLengths& lengths) RT_SAFE {
    interpolator_.interrupt(lengths);
  }
  void set_optional_stop(bool on) RT_SAFE { optional_stop_ = on; }
  void set_block_skip(int level, bool on) RT_SAFE;
  void set_single_block(bool on) RT_SAFE;

  // Claims.
  [[nodiscard]] Situation situation() const RT_SAFE;
  // Counts what ends all that was asked for before: stops, resets, faults.
  [[nodiscard]] std::uint32_t generation() const RT_SAFE { return generation_; }
  [[nodiscard]] int id() const RT_SAFE { return figures_.id; }
  [[nodiscard]] ChannelState state() const RT_SAFE { return state_; }
  [[nodiscard]] bool has_program() const RT_SAFE { return has_program_; }
  [[nodiscard]] bool is_powered() const RT_SAFE { return powered_; }
  [[nodiscard]] bool drives_answer() const RT_SAFE { return drives_answer_; }
  // Every drive that is commanded on holds its axis.
  [[nodiscard]] bool drives_ready() const RT_SAFE { return drives_ready_; }
  [[nodiscard]] bool is_standing() const RT_SAFE {
    return interpolator_.at_rest() && !manual_.is_active();
  }
  [[nodiscard]] bool is_resetting() const RT_SAFE { return resetting_; }
  [[nodiscard]] bool is_quiet() const RT_SAFE;  // nothing under way at all
  // M99 in the main program: from its first line, in the same run.
  [[nodiscard]] bool begins_again() const RT_SAFE { return !figures_.stops_go_on; }
  [[nodiscard]] std::int64_t cycle() const RT_SAFE { return cycle_; }
  [[nodiscard]] double path_speed() const RT_SAFE { return path_.s_speed; }  // mm/s
  [[nodiscard]] double feed_override() const RT_SAFE { return control_.feed_override; }
  [[nodiscard]] std::uint16_t block_skip() const RT_SAFE { return block_skip_; }
  [[nodiscard]] double position_W(int axis) const RT_SAFE {
    return path_.point[static_cast<std::size_t>(axis)].value;
  }
  [[nodiscard]] double position_M(int axis) const RT_SAFE {
    return path_.axes[static_cast<std::size_t>(axis)].value;
  }
  // The position of the axis belongs to the machine, as its drive says.
  [[nodiscard]] bool is_homed(int axis) const RT_SAFE {
    return feedback_[static_cast<std::size_t>(axis)].referenced;
  }
  // rev/min, clockwise > 0; 0 is the master spindle. Nothing: the channel has no such spindle.
  [[nodiscard]] std::optional<double> spindle_speed(int id) const RT_SAFE;
  [[nodiscard]] int machine_axis(int axis) const RT_SAFE {
    return figures_.machine_axis[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] int scheme() const RT_SAFE { return scheme_; }
  [[nodiscard]] bool has_scheme(int scheme) const RT_SAFE { return find_scheme(scheme) != nullptr; }
  [[nodiscard]] Outcome load_outcome() const RT_SAFE { return load_; }
  [[nodiscard]] Outcome switch_outcome() const RT_SAFE { return switch_; }
  [[nodiscard]] const FixedText<8>& switch_fault() const RT_SAFE { return switch_fault_; }
  [[nodiscard]] const ShortText& last_text() const RT_SAFE { return text_; }
  [[nodiscard]] std::uint32_t run() const RT_SAFE { return run_; }
  [[nodiscard]] bool has_ended(std::uint32_t run) const RT_SAFE { return run != run_ || !running_; }
  // How the latest run, or the one before it, ended.
  [[nodiscard]] bool ended_well(std::uint32_t run) const RT_SAFE;
  [[nodiscard]] bool was_reset_since_run() const RT_SAFE { return was_reset_; }
  [[nodiscard]] bool is_running() const RT_SAFE { return running_; }  // held or not
  [[nodiscard]] std::int64_t start_cycle() const RT_SAFE { return start_cycle_; }
  [[nodiscard]] std::int64_t end_cycle() const RT_SAFE { return end_cycle_; }
  [[nodiscard]] const ChannelAlarm& last_alarm() const RT_SAFE { return last_alarm_; }
  [[nodiscard]] const FileName& file_name(const motion::BlockTag& tag) const RT_SAFE;
  // The request of the own program that waits for the coordinator, or nullptr.
  [[nodiscard]] const Item* request() const RT_SAFE { return asks_ ? &asked_ : nullptr; }

  // Axes (channel_axes.cc). An axis that another channel has stands still for this one.
  struct YieldedAxis {
    double position = 0.0;
    DriveCommand drive;
  };
  [[nodiscard]] int axis_count() const RT_SAFE { return figures_.axis_count; }
  [[nodiscard]] bool owns(int axis) const RT_SAFE { return (owned_ >> axis & 1U) != 0; }
  [[nodiscard]] int axis_of_machine_axis(int machine_axis) const RT_SAFE;  // -1: none
  [[nodiscard]] lang::AxisSet axes_of_scheme() const RT_SAFE;
  [[nodiscard]] lang::AxisSet axes_of_scheme(int scheme) const RT_SAFE;  // parked ones, too
  void set_owned(int axis, bool owned) RT_SAFE;
  YieldedAxis yield_axis(int axis) RT_SAFE;
  void take_axis(int axis, const YieldedAxis& yielded) RT_SAFE;
  void release_axes(lang::AxisSet axes) RT_SAFE;  // drives on, brakes open
  [[nodiscard]] const FixedText<16>& axis_name(int axis) const RT_SAFE {
    return figures_.axes[static_cast<std::size_t>(axis)].name;
  }
  [[nodiscard]] bool is_switching() const RT_SAFE { return switch_ == Outcome::pending; }

  // Spindles and axes (channel_spindle_axis.cc). `id` of a spindle of the channel; 0: the first.
  [[nodiscard]] int axis_of_spindle(int id) const RT_SAFE;  // index in the channel; -1: none
  [[nodiscard]] bool is_spindle_now(int axis) const RT_SAFE;
  void stop_spindle(int id) RT_SAFE;
  [[nodiscard]] bool spindle_stands(int id) const RT_SAFE;
  void close_position_loop(int id) RT_SAFE;  // of a spindle that stands
  [[nodiscard]] bool position_loop_is_closed(int id) const RT_SAFE;
  void open_position_loop(int id) RT_SAFE;
  // Of its axis; false: the machine file gives it no mark to look for.
  [[nodiscard]] bool begin_homing_of_spindle(int id) RT_SAFE;

  // A law of the cycle on or off; false: the channel has no such law (channel_process.cc).
  [[nodiscard]] bool switch_automatic_feed(motion::LawKind law, bool on) RT_SAFE;

  // Force control, as an operator orders it; false: there is none, or it does not take the order
  // (channel_force.cc).
  [[nodiscard]] bool order_force(const motion::ForceOrder& order) RT_SAFE;

  [[nodiscard]] bool has_force_control() const RT_SAFE { return figures_.feed_modifier != nullptr; }

  // Axes moved by hand (channel_manual.cc).
  [[nodiscard]] int axis_named(std::string_view name) const RT_SAFE;  // -1: none
  // Why not: a code of the catalogue; empty: it goes.
  [[nodiscard]] std::string_view jog(const Jog& jog) RT_SAFE;
  void home(lang::AxisSet axes) RT_SAFE { manual_.home(axes); }
  [[nodiscard]] lang::AxisSet axes_to_home() const RT_SAFE;
  void return_to_parking() RT_SAFE;
  [[nodiscard]] const ManualMotion& manual_motion() const RT_SAFE { return manual_; }
  // The first axis that stands on a limit switch; -1: none.
  [[nodiscard]] int axis_on_limit_switch() const RT_SAFE;

  [[nodiscard]] const MarkWorker& marks() const RT_SAFE { return marks_; }
  void open_soft_mark() RT_SAFE { marks_.open(); }

 private:
  enum class Activity : std::uint8_t { none, frame, dwell, spindle, brakes, request, stop };

  // Items (channel_items.cc).
  void work_items() RT_SAFE;
  [[nodiscard]] bool stops_where_preparation_broke_off() RT_SAFE;
  [[nodiscard]] bool finish_activity() RT_SAFE;
  void execute(const Item& item) RT_SAFE;
  void take_step() RT_SAFE;
  void stop_at_step() RT_SAFE;
  void take_load(const Item& item) RT_SAFE;
  void command_spindles(const lang::SpindleCommand& command) RT_SAFE;
  void command_cutting_speed(const lang::CuttingSpeedMode& mode) RT_SAFE;
  void set_output(const Item& item) RT_SAFE;
  void stop_by_program(const Item& item) RT_SAFE;
  void begin_brakes(const Item& item) RT_SAFE;
  [[nodiscard]] int disobedient_axis() const RT_SAFE;
  void fail_switch(int axis) RT_SAFE;
  void end_switch() RT_SAFE;
  [[nodiscard]] Notice notice_of_start(NoticeKind kind) const RT_SAFE;
  void end_run(bool ok, std::uint64_t blocks) RT_SAFE;
  void end_effects() RT_SAFE;
  void close_run(bool ok, std::uint64_t blocks) RT_SAFE;
  void set_axes(lang::AxisSet axes, bool free) RT_SAFE;
  void move() RT_SAFE;
  [[nodiscard]] int spindle_index(int id) const RT_SAFE;
  void open_position_loops() RT_SAFE;
  // Feed laws, constant cutting speed (channel_process.cc).
  struct AskedSpeed {
    motion::LawSpeed unit = motion::LawSpeed::unchanged;
    double value = 0.0;  // 0: none
  };
  [[nodiscard]] double form_feed() RT_SAFE;
  void restart_automatic_feeds() RT_SAFE;
  void follow_process() RT_SAFE;
  void ask_speed(const AskedSpeed& speed) RT_SAFE;
  [[nodiscard]] double diameter() const RT_SAFE;  // of a part turned around Z, at the tool; mm
  [[nodiscard]] ProcessOutput process() const RT_SAFE;
  void turn_spindles() RT_SAFE;
  // Force control (channel_force.cc).
  void order_force(const Item& item) RT_SAFE;
  void control_force() RT_SAFE;
  [[nodiscard]] motion::CutState cut_state() RT_SAFE;
  [[nodiscard]] unsigned geometry_axes() const RT_SAFE;  // bit k: channel axis k
  void apply_feed_demand(motion::FeedControl& control) const RT_SAFE;
  void tell_force_event(motion::ForceEvent event) RT_SAFE;
  // Axes moved by hand (channel_manual.cc).
  [[nodiscard]] bool is_parked(int axis) const RT_SAFE;  // by the active scheme
  void move_by_hand() RT_SAFE;
  void watch_limit_switches() RT_SAFE;
  enum class Steps { of_axes, of_numbers };
  [[nodiscard]] bool guard_setpoints(Steps steps) RT_SAFE;
  void guard_limits() RT_SAFE;
  // Probing (channel_probe.cc).
  void begin_probing(const Item& item) RT_SAFE;
  void watch_probe() RT_SAFE;
  void answer_probing() RT_SAFE;
  // Threads (channel_thread.cc).
  void observe_spindles() RT_SAFE;
  [[nodiscard]] std::optional<double> measured_angle(std::size_t spindle) RT_SAFE;
  void follow_thread() RT_SAFE;
  // Position regulators (channel_drives.cc).
  void make_regulators();
  void adopt_positions() RT_SAFE;
  void demand_velocities() RT_SAFE;
  void work_marks() RT_SAFE;
  [[nodiscard]] std::uint64_t riders_before_item() const RT_SAFE;
  [[nodiscard]] std::uint64_t closed_from_block() const RT_SAFE;
  [[nodiscard]] std::uint64_t chunk_limit(std::uint64_t available) const RT_SAFE;
  void show_remarks(std::int64_t cycle) RT_SAFE;
  void name_program() RT_SAFE;
  void show(const Remark& remark, std::int64_t cycle) RT_SAFE;
  void continue_reset() RT_SAFE;
  void forget_arrivals() RT_SAFE;
  void take_overrides(const lang::OverrideControl& overrides) RT_SAFE;
  void apply_spindle_override() RT_SAFE;
  void wait(Activity activity, double seconds) RT_SAFE;
  void emit(std::int64_t cycle, std::string_view code, std::string_view text,
            const motion::BlockTag& tag) RT_SAFE;
  // Of the block that is executed, on the path or, as a dwell or a stop, beside it.
  [[nodiscard]] const motion::BlockTag& tag_at_hand() const RT_SAFE {
    return activity_ == Activity::none || item_.tag.run != run_ ? path_.tag : item_.tag;
  }
  [[nodiscard]] const kinematics::Scheme* find_scheme(int scheme) const RT_SAFE;
  [[nodiscard]] motion::Point axes_M() const RT_SAFE;
  void stand_in_frame() RT_SAFE;
  [[nodiscard]] RunRecord run_record() const RT_SAFE;

  motion::MotionConfig motion_;
  ChannelFigures figures_;
  std::array<std::pair<int, const kinematics::Scheme*>, 16> schemes_{};
  int scheme_count_ = 0;
  ChannelLink& link_;
  Arrivals arrivals_;   // seen in this cycle
  Arrivals forgotten_;  // with the latest reset, counted since construction
  CycleBooks books_;

  motion::Interpolator interpolator_;
  ManualMotion manual_;
  ProbeWatch probe_;
  lang::AxisSet on_limit_switch_ = 0;
  motion::FeedControl control_;
  motion::InterpolatorOutput path_;
  kinematics::Transform transform_;
  Workpiece workpiece_;
  ToolAtWork tool_;
  std::array<DriveCommand, motion::axes_max> drives_{};
  std::array<AxisSetpoint, motion::axes_max> setpoints_{};
  std::array<Spindle, spindles_max> spindles_{};
  AskedSpeed speed_behind_law_;  // when the law at hand is over
  std::array<motion::SpindleObserver, spindles_max> observers_{};
  SpindleSensors sensors_;  // of the master spindle
  std::array<motion::AutomaticFeed, automatic_feeds_max> automatic_feeds_{};
  motion::FeedDemand feed_demand_;  // of force control, for the cycle to come
  bool frame_is_new_ = true;
  std::uint32_t spindle_starts_ = 0;
  int spindle_direction_ = 0;
  struct EncoderNews {
    double angle_deg = 0.0;
    double age_s = 0.0;
  };
  std::array<EncoderNews, spindles_max> encoder_news_{};  // the latest of each spindle

  ChannelState state_ = ChannelState::idle;
  bool powered_ = false;
  bool has_program_ = false;
  std::int32_t loads_ = 0;         // that were begun
  std::int32_t program_load_ = 0;  // of the program that is there
  Job loading_ = Job::program;
  bool running_ = false;
  bool run_ok_ = true;
  bool run_before_ok_ = true;
  bool was_reset_ = false;  // since the latest run
  bool resetting_ = false;
  bool reset_sent_ = false;
  bool power_off_wanted_ = false;
  bool alarm_stays_ = false;  // after the reset under way
  std::uint32_t generation_ = 0;
  bool drives_answer_ = true;
  bool drives_ready_ = true;
  std::array<bool, motion::axes_max> drive_was_ready_{};  // since it was commanded on
  // What the drives told last; `enabled` and `referenced` count only while they are valid.
  std::array<AxisFeedback, motion::axes_max> feedback_{};
  bool drives_are_ideal_ = true;
  lang::AxisSet spindle_axes_ = 0;  // axes that are spindles now
  lang::AxisSet owned_ = 0;         // that no other channel moves
  std::array<motion::PositionRegulator, motion::axes_max> regulators_{};  // feedback in the cycle
  lang::OverrideControl overrides_;                                       // which of them act
  double spindle_override_ = 1.0;
  HoldCause hold_cause_ = HoldCause::none;
  bool hold_wanted_ = false;  // by an operator while M53 does not let it act
  bool optional_stop_ = false;
  std::uint16_t block_skip_ = 0;  // bit n: level n
  Stepper stepper_;
  Outcome load_ = Outcome::succeeded;
  Outcome switch_ = Outcome::succeeded;
  FixedText<8> switch_fault_;        // why the latest switch failed; its text is text_
  lang::AxisSet switched_axes_ = 0;  // that the switch at hand braked or released so far
  int scheme_ = 0;
  std::uint32_t run_ = 0;
  FileName program_;  // of the run, once one of its blocks is at hand
  std::int64_t cycle_ = 0;
  std::int64_t start_cycle_ = 0;
  std::int64_t end_cycle_ = 0;
  double path_mm_ = 0.0;
  std::uint32_t lookahead_max_ = 0;
  std::uint64_t blocks_ = 0;
  Activity activity_ = Activity::none;
  std::int64_t activity_cycles_ = 0;
  std::int64_t activity_began_ = 0;  // when the activity began
  Item item_;                        // the item being executed
  bool asks_ = false;                // the own program waits for the answer to `asked_`
  Item asked_;
  ShortText text_;
  ChannelAlarm last_alarm_;

  MarkWorker marks_;
};

}  // namespace stanok::channels
