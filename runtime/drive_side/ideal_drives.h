// IdealDrives: every axis is where it should be. Nothing is read or written; what a simulated cut
// shows of the spindle comes from the cut itself.
#pragma once

#include "runtime/drive_side/drive_side.h"

namespace stanok::runtime {

class IdealDrives final : public DriveSide {
 public:
  explicit IdealDrives(const DriveSurroundings& surroundings)
      : machine_(surroundings.file.machine), process_(surroundings.process) {}

  void read(std::span<const channels::OperatorEvent> /*events*/) RT_SAFE override {}
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const RT_SAFE override {
    return {};
  }
  [[nodiscard]] std::span<const channels::SpindleSensors> sensors() RT_SAFE override;
  // As it was set last; an axis that no channel has set is at its start.
  [[nodiscard]] double position_of(int axis, const channels::CycleOutput& last) const
      RT_SAFE override;
  void write(const channels::CycleOutput& /*output*/) RT_SAFE override {}

 private:
  const channels::MachineConfig& machine_;
  const ProcessPlant* process_;
};

}  // namespace stanok::runtime
