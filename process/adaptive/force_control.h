// ForceControl: the adaptive system of the cutting force, blocks 8 to 23 wired as in the drawing.
//
// Power sensor 8 and vibration sensor 16 come in with CutState, block 1 with commands and the
// programmed feed, block 3 takes the demand. Docs and the table of blocks:
// docs/programmer/adaptive-control.md. One object per channel. Real-time; allocates nothing.
#pragma once

#include "motion/segments/feed_modifier.h"
#include "process/adaptive/feed_clamps.h"
#include "process/adaptive/feed_controller.h"
#include "process/adaptive/force_control_config.h"
#include "process/adaptive/force_events.h"
#include "process/adaptive/idle_power_compensator.h"
#include "process/adaptive/interrupted_cut.h"
#include "process/adaptive/missing_force.h"
#include "process/adaptive/power_correction.h"
#include "process/adaptive/process_observer.h"
#include "process/adaptive/radius_counter.h"
#include "process/adaptive/setpoint_law.h"
#include "process/adaptive/vibration_amplifier.h"

namespace stanok::process {

class ForceControl final : public motion::FeedModifier {
 public:
  explicit ForceControl(const ForceControlConfig& config);

  [[nodiscard]] bool command(const motion::ForceCommand& command) RT_SAFE override;
  [[nodiscard]] motion::FeedDemand advance(const motion::CutState& cut) RT_SAFE override;
  [[nodiscard]] bool is_ready() const RT_SAFE override;
  [[nodiscard]] motion::ForceEvent event() const RT_SAFE override { return events_.event(); }
  [[nodiscard]] motion::ForceStatus status() const RT_SAFE override { return status_; }

  [[nodiscard]] const RadiusCounter& radius_counter() const RT_SAFE { return radius_.counter(); }

 private:
  void switch_off() RT_SAFE;
  void command_force(const motion::ForceCommand& command) RT_SAFE;
  void set_force(double force_n) RT_SAFE;
  void adjust(const motion::ForceCommand& command) RT_SAFE;
  [[nodiscard]] bool command_vibration(const motion::ForceCommand& command) RT_SAFE;
  [[nodiscard]] bool is_on() const RT_SAFE { return status_.state != motion::ForceState::off; }
  void resolve_clamps(const motion::CutState& cut) RT_SAFE;
  void observe(const motion::CutState& cut) RT_SAFE;
  [[nodiscard]] bool path_follows(const motion::CutState& cut) const RT_SAFE;
  [[nodiscard]] motion::FeedDemand control(const motion::CutState& cut) RT_SAFE;
  [[nodiscard]] bool is_cutting(const motion::CutState& cut) RT_SAFE;
  [[nodiscard]] ForceSetpoint form_setpoint(const motion::CutState& cut) RT_SAFE;
  void regulate(const motion::CutState& cut, const ForceSetpoint& setpoint) RT_SAFE;
  void watch_force(const motion::CutState& cut) RT_SAFE;
  [[nodiscard]] motion::FeedDemand demand(double feed_per_s) RT_SAFE;

  ForceControlConfig config_;
  IdlePowerCompensator compensator_;  // 9
  CutRadius radius_;                  // 10 and 11
  ComputingBlock computing_;          // 12
  FeedController controller_;         // 14
  VibrationAmplifier amplifier_;      // 17 to 20, 18 its level
  SetpointLaw law_;                   // 21
  ProcessObserver observer_;
  InterruptedCut interruption_;
  MissingForce missing_;

  FeedClamps clamps_;
  double feed_asked_ = 0.0;  // in the cycle before, mm/s
  bool cuts_ = false;
  ForceEvents events_;
  motion::ForceStatus status_;
};

}  // namespace stanok::process
