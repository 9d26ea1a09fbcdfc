// The simulated drives without sockets and threads, on the clock of the cycle: for the virtual
// clock, where a run must give the same bits every time.
//
// Each write is one cycle: the drives are exchanged with when a poll is due, with the same
// registers, scales and supervision as over Modbus, and then move by one cycle.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "base/units.h"
#include "drives/bus.h"
#include "drives/modbus/axis_exchange.h"
#include "plant/drive/simulated_drive.h"

namespace stanok::plant {

class DirectBus final : public drives::DriveBus {
 public:
  DirectBus(const drives::BusConfig& config, const std::vector<SimulatedDriveConfig>& drives,
            Duration cycle);

  void start() override {}
  void stop() override {}
  void write(std::span<const drives::DriveTarget> targets) RT_SAFE override;
  void read(std::span<drives::DriveFeedback> feedback) RT_SAFE override;
  [[nodiscard]] drives::BusStatus status() const override;

  void inject(std::size_t drive, FaultKind kind) RT_SAFE { axes_[drive].drive.inject(kind); }
  void load(std::size_t drive, const ProcessLoad& load) RT_SAFE { axes_[drive].drive.load(load); }

 private:
  struct Axis {
    drives::AxisExchange exchange;
    SimulatedDrive drive;
    std::uint32_t sequence_seen = 0;
    std::uint32_t age_cycles = 0;
  };

  void exchange(Axis& axis, const drives::DriveTarget& target) RT_SAFE;

  std::vector<Axis> axes_;
  drives::BusTime cycle_;
  drives::BusTime poll_;
  drives::BusTime now_{0};
  drives::BusTime next_poll_{0};
  std::uint64_t exchanges_ = 0;
  drives::ErrorCounts errors_{};
  std::vector<std::string> names_;
};

}  // namespace stanok::plant
