// DriveSide: the drives of a machine as its cycle has them: what they tell before the cycle, and
// what they are told behind it.
//
// Chosen once, when an assembly is put together. There are three: IdealDrives are where they should
// be; DirectDrives are simulated on the clock of the cycle; ModbusDrives are on a bus, real ones or
// simulated ones behind a server of their own. Threads: `start`, `stop` and `inject_fault` belong
// to one, `reset_drive` and `status` to anybody, all else to the real-time cycle.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "base/rt_safe.h"
#include "base/signals.h"
#include "channels/contract/operator_event.h"
#include "channels/contract/output.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "drives/bus.h"
#include "plant/drive/fault.h"
#include "runtime/drive_side/process_plant.h"

namespace stanok::runtime {

enum class DriveChoice {
  ideal,      // setpoints only; every axis is where it should be
  simulated,  // simulated drives on the clock of the cycle: repeatable to the bit
  embedded,   // simulated drives behind a real Modbus TCP server on loopback
  real,       // the bus of the machine file
};

class DriveSide {
 public:
  DriveSide() = default;
  virtual ~DriveSide() = default;
  DriveSide(const DriveSide&) = delete;
  DriveSide& operator=(const DriveSide&) = delete;

  virtual void start() {}
  virtual void stop() {}

  // Before the cycle of the machine. A reset or a switching on among `events` acknowledges the
  // faults of the drives concerned.
  virtual void read(std::span<const channels::OperatorEvent> events) RT_SAFE = 0;
  // What was read, of the axes of the machine; empty: they are where they should be.
  [[nodiscard]] virtual std::span<const channels::AxisFeedback> feedback() const RT_SAFE = 0;
  // Of the spindles of the machine; empty: there are none.
  [[nodiscard]] virtual std::span<const channels::SpindleSensors> sensors() RT_SAFE = 0;
  // Inputs of programs; nothing: the drives have none.
  [[nodiscard]] virtual std::optional<Signals> signals() RT_SAFE { return std::nullopt; }
  // Of an axis of the machine, whose last output was this.
  [[nodiscard]] virtual double position_of(int axis, const channels::CycleOutput& last) const
      RT_SAFE = 0;

  // Behind the cycle of the machine, and behind that of the process where one is simulated.
  virtual void write(const channels::CycleOutput& output) RT_SAFE = 0;

  // Periods pass in which the drives are told nothing. Those whose time is not that of the cycle
  // have gone on already.
  virtual void pass(std::int64_t /*periods*/) RT_SAFE {}

  [[nodiscard]] virtual drives::BusStatus status() const { return {}; }
  // Acknowledges the fault of one drive, as a reset of its channel would. False: there is no such
  // drive.
  [[nodiscard]] virtual bool reset_drive(std::string_view /*drive*/) { return false; }
  // Makes a simulated drive fail, or work again. False: there is no such drive.
  [[nodiscard]] virtual bool inject_fault(std::string_view /*drive*/, plant::FaultKind /*fault*/) {
    return false;
  }
};

// What the drives of an assembly are made of; all outlives them.
struct DriveSurroundings {
  config::MachineFile& file;  // gets the bus that the drives are on
  const channels::MachineOptions& options;
  const ProcessPlant* process = nullptr;  // what the spindle bears; nullptr: no cut is simulated
};

// Throws config::ConfigError where the machine file has no bus for real drives, and
// std::invalid_argument where it has more drives than there is room for.
[[nodiscard]] std::unique_ptr<DriveSide> make_drive_side(DriveChoice choice,
                                                         const DriveSurroundings& surroundings);

}  // namespace stanok::runtime
