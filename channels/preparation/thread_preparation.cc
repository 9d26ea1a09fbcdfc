#include "channels/preparation/thread_preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/units.h"
#include "channels/preparation/cutting_speed.h"
#include "channels/preparation/scheme_switch.h"
#include "channels/preparation/tap_trial.h"
#include "motion/threads/synchronous_run.h"

namespace stanok::channels {
namespace {

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

// In rev/min, rounded down: what is named as the highest speed is one that can be used.
std::string speed_text(double turns_per_s) {
  return short_number(std::floor(turns_per_s * seconds_per_minute));
}

// On the way from one point to another, mm; `x` below 0: there is no diameter.
double smallest_diameter(const motion::Point& start, const motion::Point& end, int x) {
  if (x < 0) return 0.0;
  const double from = start[static_cast<std::size_t>(x)];
  const double to = end[static_cast<std::size_t>(x)];
  return from * to < 0.0 ? 0.0 : 2.0 * std::min(std::abs(from), std::abs(to));
}

double length_of(const motion::Point& way) {
  double squared = 0.0;
  for (const double part : way) squared += part * part;
  return std::sqrt(squared);
}

motion::Point difference(const motion::Point& to, const motion::Point& from) {
  motion::Point way = to;
  for (std::size_t k = 0; k < way.size(); ++k) way[k] -= from[k];
  return way;
}

// Where a tap that stands so comes to, parallel to its way. Nothing: it stands elsewhere.
std::optional<motion::Point> end_of_way_out(const HeldTap& tap, const TapWay& way) {
  constexpr double across_max = 0.1;  // of the lead: play of the chuck, and an axis that sagged
  constexpr double stands = 1e-6;     // mm
  const motion::Point in = difference(way.deepest, way.start);
  const double depth = length_of(in);
  if (depth < stands) return way.now;
  const motion::Point gone = difference(way.now, way.start);
  double along = 0.0;
  for (std::size_t k = 0; k < in.size(); ++k) along += gone[k] * in[k] / depth;
  motion::Point across = gone;
  for (std::size_t k = 0; k < in.size(); ++k) across[k] -= along * in[k] / depth;
  const bool is_on_way = length_of(across) <= across_max * tap.lead_mm &&
                         along >= -across_max * tap.lead_mm && along <= depth + tap.lead_mm;
  if (!is_on_way) return std::nullopt;
  if (along < stands) return way.now;
  motion::Point end = way.start;
  for (std::size_t k = 0; k < end.size(); ++k) end[k] += across[k];
  return end;
}

Diagnostic fault(const char* code, std::string message, std::string help) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.help = {std::move(help)};
  return diagnostic;
}

}  // namespace

ThreadPreparation::ThreadPreparation(const MachineConfig& machine, const ChannelConfig& channel,
                                     const motion::MotionConfig& motion)
    : channel_(channel), builder_(motion), cycle_s_(motion.cycle_s) {
  for (const int id : channel.spindles) {
    const auto config = std::ranges::find(machine.spindles, id, &SpindleConfig::id);
    if (config != machine.spindles.end()) spindles_.push_back({.config = *config});
  }
}

// The language has checked that the channel has the spindle; 0 is its first.
std::size_t ThreadPreparation::index_of(int spindle) const {
  for (std::size_t k = 0; k < spindles_.size(); ++k) {
    if (spindles_[k].config.id == spindle) return k;
  }
  return 0;
}

double ThreadPreparation::ThreadSpindle::speed_at(double diameter_mm) const {
  if (cutting_m_per_min <= 0.0) return rev_per_min;
  return speed_of_cut({config.speed_min, config.speed_max, limit_rev_per_min}, cutting_m_per_min,
                      diameter_mm);
}

void ThreadPreparation::take_cutting_speed(const lang::CuttingSpeedMode& mode,
                                           const motion::Point& position, int x) {
  const double diameter_mm = smallest_diameter(position, position, x);
  for (std::size_t k = 0; k < spindles_.size(); ++k) {
    ThreadSpindle& spindle = spindles_[k];
    if (mode.spindle >= 0 && index_of(mode.spindle) != k) continue;
    if (!mode.constant) spindle.rev_per_min = spindle.speed_at(diameter_mm);
    spindle.cutting_m_per_min = mode.constant ? mode.speed_m_per_min : 0.0;
    spindle.limit_rev_per_min = mode.constant ? mode.limit_rev_per_min : 0.0;
  }
}

void ThreadPreparation::take_spindle(const lang::SpindleCommand& command) {
  for (std::size_t k = 0; k < spindles_.size(); ++k) {
    const bool is_meant = command.spindle < 0 || index_of(command.spindle) == k;
    const bool turns = command.action != lang::SpindleAction::stop &&
                       command.action != lang::SpindleAction::orient;
    if (!is_meant) continue;
    spindles_[k].cutting_m_per_min = command.cutting_speed_m_per_min;
    if (turns) spindles_[k].rev_per_min = command.speed_rev_per_min;
  }
}

bool ThreadPreparation::continues(const lang::SynchronousMove& move) const {
  const bool same_start = move.start_angle_deg == 0.0 || move.start_angle_deg == start_angle_deg_;
  return !is_empty() && !is_tap_ && move.kind == lang::SynchronousMove::Kind::thread &&
         same_start && index_of(move.spindle) == spindle_;
}

std::optional<Diagnostic> ThreadPreparation::refusal(const lang::SynchronousMove& move) const {
  if (spindles_.empty()) {
    return fault("E5301", "a thread needs a spindle, which the channel does not have",
                 "add a spindle with an encoder to the channel in the machine file");
  }
  const SpindleConfig& spindle = spindles_[index_of(move.spindle)].config;
  if (spindle.encoder_pulses <= 0) {
    return fault("E5301",
                 "a thread needs the angle of spindle " + std::to_string(spindle.id) +
                     ", which has no encoder",
                 "enter `encoder` (pulses per revolution) in the machine file, or tap with G84 "
                 "and a floating chuck");
  }
  if (move.kind == lang::SynchronousMove::Kind::rigid_tap && spindle.acceleration <= 0.0) {
    return fault("E5305",
                 "rigid tapping needs the acceleration of spindle " + std::to_string(spindle.id),
                 "enter `acceleration` of the spindle, in rev/min/s, in the machine file");
  }
  return std::nullopt;
}

std::optional<Diagnostic> ThreadPreparation::add(const lang::SynchronousMove& move,
                                                 const motion::PathBlock& line,
                                                 const motion::Point& start,
                                                 const std::array<int, 3>& geometry) {
  if (auto refused = refusal(move)) return refused;
  const bool is_tap = move.kind == lang::SynchronousMove::Kind::rigid_tap;
  const double rev_per_min =
      spindles_[index_of(move.spindle)].speed_at(smallest_diameter(start, line.end, geometry[0]));
  if (is_empty()) {
    rev_per_min_ = rev_per_min;
    is_tap_ = is_tap;
    spindle_ = index_of(move.spindle);
    start_angle_deg_ = move.start_angle_deg;
    motion::SpindleCoupling coupling;
    coupling.kind =
        is_tap ? motion::SpindleCoupling::Kind::tap : motion::SpindleCoupling::Kind::thread;
    coupling.spindle = static_cast<std::int32_t>(spindle_);
    coupling.start_angle_deg = start_angle_deg_;
    coupling.spindle_acceleration = spindles_[spindle_].config.acceleration / seconds_per_minute;
    coupling.return_speed_factor = move.return_speed_factor;
    coupling.dwell_s = move.dwell_s;
    const double fastest = is_tap ? std::max(1.0, move.return_speed_factor) : 1.0;
    builder_.begin(start, geometry, coupling, fastest * rev_per_min / seconds_per_minute,
                   motion::jerk_to_follow(spindles_[spindle_].config.encoder_pulses, cycle_s_));
  }
  if (rev_per_min > rev_per_min_) {
    rev_per_min_ = rev_per_min;
    if (const auto fault = builder_.turn_faster(rev_per_min / seconds_per_minute))
      return diagnostic_of(*fault);
  }
  motion::ThreadBlock block;
  block.tag = line.tag;
  block.end = line.end;
  block.lead_mm = move.lead_mm_per_rev;
  block.runs_out = move.runs_out;
  block.keeps_tolerance =
      move.line.path.mode == lang::PathMode::continuous && move.line.path.tolerance_mm >= 0.0;
  block.tolerance_mm = line.tolerance_mm;
  block.transform = line.transform;
  const auto found = is_tap ? builder_.add_tap(block) : builder_.add(block);
  if (found) return diagnostic_of(*found);
  return is_tap ? tried_tap() : std::nullopt;
}

Expected<motion::Point, Diagnostic> ThreadPreparation::take_out(
    const HeldTap& tap, const TapWay& way, const std::array<int, 3>& geometry) {
  const auto index = static_cast<std::size_t>(tap.spindle);
  const auto end = end_of_way_out(tap, way);
  if (!end) {
    return Unexpected<Diagnostic>(fault("E6104", "the tap does not stand on its way any more",
                                        "free it by hand, then jog the axes away"));
  }
  if (*end == way.now) return *end;
  const SpindleConfig& spindle = spindles_[index].config;
  const double speed = std::abs(tap.rev_per_min) / seconds_per_minute;
  spindle_ = index;
  rev_per_min_ = std::abs(tap.rev_per_min);
  is_tap_ = true;
  motion::SpindleCoupling coupling;
  coupling.kind = motion::SpindleCoupling::Kind::tap_out;
  coupling.spindle = tap.spindle;
  coupling.spindle_acceleration = spindle.acceleration / seconds_per_minute;
  coupling.out_speed = -tap.rev_per_min / seconds_per_minute;
  builder_.begin(*end, geometry, coupling, speed,
                 motion::jerk_to_follow(spindle.encoder_pulses, cycle_s_));
  motion::ThreadBlock block;
  block.end = way.now;
  block.lead_mm = tap.lead_mm;
  block.transform = way.transform;
  if (const auto found = builder_.add_tap(block)) {
    forget();
    return Unexpected<Diagnostic>(diagnostic_of(*found));
  }
  return *end;
}

// A spindle whose speed is not known is not tried.
std::optional<Diagnostic> ThreadPreparation::tried_tap() const {
  if (rev_per_min_ <= 0.0) return std::nullopt;
  const motion::ThreadChain chain = motion::ThreadBuilder(builder_).finish();
  const TapTrial trial{spindles_[spindle_].config, chain, cycle_s_};
  if (trial.succeeds_at(rev_per_min_)) return std::nullopt;
  const double speed = std::floor(trial.fastest_below(rev_per_min_));
  return fault("A4001",
               "the axes cannot follow the spindle into and out of this hole at " +
                   short_number(rev_per_min_) + " rev/min",
               speed >= 1.0
                   ? "use at most S" + short_number(speed) + ", or tap deeper"
                   : "tap deeper: the path is too short for the axes to catch up with the spindle");
}

Diagnostic ThreadPreparation::diagnostic_of(const motion::ThreadFault& found) const {
  using Kind = motion::ThreadFault::Kind;
  const std::string speed = short_number(rev_per_min_) + " rev/min";
  const std::string by_itself = spindles_[spindle_].cutting_m_per_min > 0.0 ? " of G97" : "";
  switch (found.kind) {
    case Kind::unreachable:
      return unreachable_pose({{}, found.axis, found.value, found.limit}, channel_);
    case Kind::axis_too_slow:
      return fault(
          "E5302",
          "axis " + axis_word(channel_, found.axis) + " would need " + short_number(found.value) +
              " mm/s at " + speed + ", but its limit in a thread is " + short_number(found.limit),
          "use at most S" + speed_text(found.speed_max) + by_itself + ", or cut a smaller lead");
    case Kind::corner_too_sharp:
      return fault(
          "E5303",
          "the corner before this block of the thread is too sharp for the axes at " + speed,
          "use at most S" + speed_text(found.speed_max) + by_itself +
              ", or allow a larger tolerance with G64 P");
    case Kind::encoder_too_coarse: {
      const SpindleConfig& spindle = spindles_[spindle_].config;
      return fault(
          "E5306",
          "the encoder of spindle " + std::to_string(spindle.id) + ", " +
              std::to_string(spindle.encoder_pulses) +
              " pulses per revolution, is too coarse for this lead and the jerk of the axes",
          "cut a lead of at most " + short_number(found.lead_max) +
              " mm, or enter the number of counts that the encoder really delivers, with all "
              "edges");
    }
    case Kind::too_many_blocks:
      break;
  }
  return fault("E5304", "a thread has more than 500 blocks without a stop",
               "split it with a block of another kind");
}

}  // namespace stanok::channels
