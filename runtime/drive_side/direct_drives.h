// DirectDrives: simulated drives on the clock of the cycle, without bus and threads: repeatable to
// the bit.
#pragma once

#include <vector>

#include "plant/drive/direct_bus.h"
#include "runtime/drive_side/drive_exchange.h"
#include "runtime/drive_side/drive_side.h"

namespace stanok::runtime {

class DirectDrives final : public DriveSide {
 public:
  explicit DirectDrives(const DriveSurroundings& surroundings);

  void read(std::span<const channels::OperatorEvent> events) RT_SAFE override {
    exchange_.read(events);
  }
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const RT_SAFE override {
    return exchange_.feedback();
  }
  [[nodiscard]] std::span<const channels::SpindleSensors> sensors() RT_SAFE override {
    return exchange_.sensors();
  }
  [[nodiscard]] double position_of(int axis, const channels::CycleOutput& /*last*/) const
      RT_SAFE override {
    return exchange_.position_of(axis);
  }
  void write(const channels::CycleOutput& output) RT_SAFE override;
  void pass(std::int64_t periods) RT_SAFE override {
    for (int late = 1; late <= periods; ++late) exchange_.pass(late);
  }

  [[nodiscard]] drives::BusStatus status() const override { return bus_.status(); }
  [[nodiscard]] bool reset_drive(std::string_view drive) override {
    return exchange_.demand_reset(drive);
  }
  [[nodiscard]] bool inject_fault(std::string_view drive, plant::FaultKind fault) override;

 private:
  std::vector<plant::SimulatedDriveConfig> simulated_;  // in the order of the bus
  plant::DirectBus bus_;
  DriveExchange exchange_;
  const ProcessPlant* process_;
};

}  // namespace stanok::runtime
