// DriveExchange: what a machine and the drives on its bus tell each other in a cycle: targets of
// axes and spindles, feedback, and the demand to acknowledge a fault.
//
// Thread: the real-time cycle, but for demand_reset of a drive by its name, which anybody may call.
// Owner: DirectDrives, ModbusDrives. Invariant: the drives are in the order of the bus, the axes of
// the machine first, then the spindles that have one.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/numbered.h"
#include "channels/contract/operator_event.h"
#include "channels/machine/machine.h"
#include "drives/bus.h"
#include "drives/bus_config.h"

namespace stanok::runtime {

inline constexpr std::size_t axes_of_machine_max = 64;
inline constexpr std::size_t drives_of_machine_max = axes_of_machine_max + 16;  // and the spindles

class DriveExchange {
 public:
  // `machine` and `bus` outlive the exchange. Throws std::invalid_argument where there are more
  // drives than there is room for.
  DriveExchange(const channels::MachineConfig& machine, const drives::BusConfig& config,
                drives::DriveBus& bus);

  void read(std::span<const channels::OperatorEvent> events) RT_SAFE;
  void write(const channels::CycleOutput& output) RT_SAFE;
  // A period passes without a cycle, the `late`th in a row: nothing new is told.
  void pass(int late) RT_SAFE;

  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const RT_SAFE {
    return {feedback_.data(), machine_.axes.size()};
  }
  // Of the spindles that have a drive on the bus, their own or that of their axis.
  [[nodiscard]] std::span<const channels::SpindleSensors> sensors() RT_SAFE;
  [[nodiscard]] double position_of(int axis) const RT_SAFE { return raw_feedback_[axis].position; }
  // Of a spindle of the machine; nothing: it has none on the bus.
  [[nodiscard]] std::optional<std::size_t> drive_of_spindle(std::size_t spindle) const RT_SAFE {
    return spindle_drives_[spindle];
  }
  // From the next cycle on. False: there is no such drive.
  [[nodiscard]] bool demand_reset(std::string_view drive);

 private:
  void find_spindle_drives();
  void find_vibration_sensors(const drives::BusConfig& config);
  void take_feedback() RT_SAFE;
  void turn_spindles(const channels::CycleOutput& output) RT_SAFE;
  void note_fault_resets(std::span<const channels::OperatorEvent> events) RT_SAFE;
  [[nodiscard]] bool has_drive(const channels::ChannelConfig& channel, std::size_t drive) const
      RT_SAFE;
  void acknowledge(std::size_t drive) RT_SAFE;
  void carry_out_fault_resets() RT_SAFE;

  const channels::MachineConfig& machine_;
  drives::DriveBus& bus_;
  std::vector<drives::AxisDriveConfig> drives_;
  NumberedArray<drives::DriveFeedback, drives_of_machine_max> raw_feedback_{};
  NumberedArray<channels::AxisFeedback, axes_of_machine_max> feedback_{};
  NumberedArray<drives::DriveTarget, drives_of_machine_max> targets_{};
  NumberedArray<drives::DriveTarget, drives_of_machine_max> carried_{};  // on, over lost periods
  std::vector<channels::SpindleSensors> sensors_;
  std::vector<std::optional<std::size_t>> spindle_drives_;
  std::vector<std::optional<std::size_t>> vibration_sensors_;             // of each spindle
  std::array<std::atomic<bool>, drives_of_machine_max> reset_demands_{};  // of operators
  std::array<int, drives_of_machine_max> fault_reset_cycles_{};  // still to go with the demand
  int reset_cycles_ = 0;
};

}  // namespace stanok::runtime
