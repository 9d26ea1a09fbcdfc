// AxisHoming: the search of one axis for its home position.
//
// An axis with a home switch looks for it fast in the direction of the search, at a limit switch
// turns back and looks on the other side, leaves it again, and comes back to it slowly: the home
// position is the edge of the switch, or the first index pulse of the encoder behind it. So it is
// always met from the same side, wherever the axis stands. A limit switch can stand for the home
// switch, and is left again behind its edge; and an axis that turns needs only the index pulse.
// Real-time.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/rt_safe.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "motion/profile/axis_move.h"

namespace stanok::channels {

class AxisHoming {
 public:
  enum class Result : std::uint8_t { running, found, failed };

  // `search_length`: distance, in mm or deg, within which the home position lies for sure.
  void begin(const HomingConfig& homing, const motion::RampLimits& ramp, double search_length)
      RT_SAFE;

  // Once a cycle, before `move` goes on: begins and stops it. Found means at rest behind the home
  // position.
  [[nodiscard]] Result advance(const AxisFeedback& drive, motion::AxisMove& move) RT_SAFE;

  // What the drive read at the edge of the switch or at the index pulse.
  [[nodiscard]] double home() const RT_SAFE { return home_; }
  // Why it failed.
  [[nodiscard]] std::string_view reason() const RT_SAFE { return reason_; }

 private:
  enum class Stage : std::uint8_t {
    start,
    search,
    search_back,
    leave,
    approach,
    back_off,
    found,
    failed
  };

  struct Sight {
    bool on_switch = false;
    bool end_ahead = false;   // a limit switch in the direction of the search
    bool end_behind = false;  // and the other one
    bool at_rest = false;
  };
  [[nodiscard]] Sight see(const AxisFeedback& drive, const motion::AxisMove& move) const RT_SAFE;
  void step(const AxisFeedback& drive, const Sight& sight, motion::AxisMove& move) RT_SAFE;
  void look_for_home(const AxisFeedback& drive, const Sight& sight, motion::AxisMove& move) RT_SAFE;
  void go(Stage stage, motion::AxisMove& move) RT_SAFE;
  // Stops the move; then the stage follows.
  void stop_for(Stage stage, motion::AxisMove& move) RT_SAFE;
  void fail(std::string_view reason, motion::AxisMove& move) RT_SAFE;

  HomingConfig homing_;
  motion::RampLimits ramp_;
  double search_length_ = 0.0;
  Stage stage_ = Stage::start;
  Stage next_ = Stage::start;
  bool stops_ = false;  // the next stage begins at rest
  bool was_on_switch_ = false;
  std::uint32_t index_count_ = 0;  // at the edge of the switch
  double home_ = 0.0;
  std::string_view reason_;
};

}  // namespace stanok::channels
