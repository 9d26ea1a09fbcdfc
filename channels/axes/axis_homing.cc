#include "channels/axes/axis_homing.h"

#include <cmath>

namespace stanok::channels {

void AxisHoming::begin(const HomingConfig& homing, const motion::RampLimits& ramp,
                       double search_length) RT_SAFE {
  homing_ = homing;
  ramp_ = ramp;
  search_length_ = search_length;
  stage_ = Stage::start;
  stops_ = false;
  was_on_switch_ = false;
  reason_ = {};
}

AxisHoming::Result AxisHoming::advance(const AxisFeedback& drive, motion::AxisMove& move) RT_SAFE {
  if (stops_) {
    if (!move.is_at_rest()) return Result::running;
    stops_ = false;
    go(next_, move);
  }
  if (stage_ == Stage::found) return Result::found;
  if (stage_ == Stage::failed) return Result::failed;
  step(drive, see(drive, move), move);
  return Result::running;
}

AxisHoming::Sight AxisHoming::see(const AxisFeedback& drive, const motion::AxisMove& move) const
    RT_SAFE {
  Sight sight;
  const bool up = homing_.velocity > 0.0;
  sight.end_ahead = up ? drive.limit_positive : drive.limit_negative;
  sight.end_behind = up ? drive.limit_negative : drive.limit_positive;
  sight.on_switch =
      homing_.signal == HomingSignal::limit_switch ? sight.end_ahead : drive.home_switch;
  if (homing_.signal == HomingSignal::limit_switch) sight.end_ahead = false;
  sight.at_rest = move.is_at_rest();
  return sight;
}

void AxisHoming::step(const AxisFeedback& drive, const Sight& sight, motion::AxisMove& move)
    RT_SAFE {
  switch (stage_) {
    case Stage::start:
      if (homing_.signal == HomingSignal::index_alone) {
        index_count_ = drive.index_count;
        return go(Stage::approach, move);
      }
      if (sight.on_switch) return go(Stage::leave, move);
      return go(sight.end_ahead ? Stage::search_back : Stage::search, move);
    case Stage::search:
      if (sight.on_switch) return stop_for(Stage::leave, move);
      if (sight.end_ahead) return stop_for(Stage::search_back, move);
      break;
    case Stage::search_back:
      was_on_switch_ = was_on_switch_ || sight.on_switch;
      if (was_on_switch_ && !sight.on_switch) return stop_for(Stage::approach, move);
      if (sight.end_behind) return fail("there is no home switch between the limit switches", move);
      break;
    case Stage::leave:
      if (!sight.on_switch) return stop_for(Stage::approach, move);
      if (sight.end_behind) return fail("the axis cannot leave the home switch", move);
      break;
    case Stage::approach:
      return look_for_home(drive, sight, move);
    case Stage::back_off:
      if (!sight.on_switch) return stop_for(Stage::found, move);
      break;
    case Stage::found:
    case Stage::failed:
      return;
  }
  if (sight.at_rest) fail("there is no home switch within the whole travel", move);
}

void AxisHoming::look_for_home(const AxisFeedback& drive, const Sight& sight,
                               motion::AxisMove& move) RT_SAFE {
  const bool needs_switch = homing_.signal != HomingSignal::index_alone;
  // No program starts with an axis on its limit switch.
  const Stage behind_home =
      homing_.signal == HomingSignal::limit_switch ? Stage::back_off : Stage::found;
  if (needs_switch && !was_on_switch_) {
    if (sight.on_switch) {
      was_on_switch_ = true;
      index_count_ = drive.index_count;
      home_ = drive.position;
      if (!homing_.index) return stop_for(behind_home, move);
    }
  } else if (drive.index_count != index_count_) {
    home_ = drive.index_position;
    return stop_for(behind_home, move);
  }
  if (sight.end_ahead)
    return fail("the axis reached the limit switch before the home switch or index pulse", move);
  if (sight.at_rest)
    fail(was_on_switch_ || !needs_switch ? "the encoder gave no index pulse"
                                         : "the axis did not reach the home switch again",
         move);
}

void AxisHoming::go(Stage stage, motion::AxisMove& move) RT_SAFE {
  stage_ = stage;
  if (stage == Stage::found || stage == Stage::failed || stage == Stage::start) return;
  const bool ahead = stage == Stage::search || stage == Stage::approach;
  const double direction = std::copysign(1.0, ahead ? homing_.velocity : -homing_.velocity);
  const double speed =
      stage == Stage::approach ? homing_.velocity_slow : std::abs(homing_.velocity);
  if (stage == Stage::approach) was_on_switch_ = false;
  const double from = move.position().value;
  move.begin(from, from + direction * search_length_, {.speed = speed, .ramp = ramp_});
}

void AxisHoming::stop_for(Stage stage, motion::AxisMove& move) RT_SAFE {
  move.stop();
  stops_ = true;
  next_ = stage;
}

void AxisHoming::fail(std::string_view reason, motion::AxisMove& move) RT_SAFE {
  reason_ = reason;
  stop_for(Stage::failed, move);
}

}  // namespace stanok::channels
