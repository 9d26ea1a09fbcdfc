// All simulated drives of a machine with their register images, modules of signals and
// vibration sensors, and the fault panel.
//
// Belongs to the thread of the server, except `inject` and `load`, which any one other thread may
// call.
#pragma once

#include <modbus/modbus.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/latest.h"
#include "plant/drive/fault.h"
#include "plant/drive/simulated_drive.h"
#include "plant/modbus/modbus_request.h"
#include "plant/modbus/signal_module.h"
#include "plant/modbus/vibration_module.h"

namespace stanok::plant {

// Units that are no drives.
struct ModuleConfig {
  std::vector<int> signals{};  // units of inputs and outputs
  std::vector<drives::VibrationSensorConfig> vibration{};
};

class DriveBank {
 public:
  // The drives move in steps of at most `step_s`.
  DriveBank(const std::vector<SimulatedDriveConfig>& drives, const ModuleConfig& modules,
            double step_s);

  [[nodiscard]] std::size_t size() const { return drives_.size(); }

  // Moves all drives on to this time. A pause longer than half a second (the process was stopped)
  // is skipped, not caught up.
  void advance_to(std::chrono::nanoseconds time);

  // How the request (function code first) to this unit is to be answered; no value: no such unit.
  [[nodiscard]] std::optional<AnswerKind> answer_kind(int unit);

  // Carries out what the request writes, and returns the registers from which libmodbus answers it.
  // The unit must exist.
  [[nodiscard]] modbus_mapping_t* registers_after(int unit, std::span<const std::uint8_t> pdu);

  void inject(std::size_t drive, FaultKind kind);
  void load(std::size_t drive, const ProcessLoad& load) RT_SAFE;

 private:
  struct Unmap {
    void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
  };
  using Registers = std::unique_ptr<modbus_mapping_t, Unmap>;

  struct Slot {
    explicit Slot(const SimulatedDriveConfig& config);

    SimulatedDrive drive;
    Registers registers;
    std::atomic<std::uint16_t> injected{0};
    std::uint16_t injected_seen = 0;
    Latest<ProcessLoad> load;
  };

  [[nodiscard]] Slot* slot_of(int unit);
  [[nodiscard]] SignalModule* module_of(int unit);
  [[nodiscard]] VibrationModule* vibration_of(int unit);
  void sample_vibration(double dt_s);
  void apply_injections();
  void write_drive(Slot& slot, const RegisterWrite& write);
  void write_panel(const RegisterWrite& write);
  void show_faults();
  static void show_status(Slot& slot);

  std::deque<Slot> drives_;  // slots stay where they are
  std::vector<SignalModule> modules_;
  std::vector<VibrationModule> vibrations_;
  Registers panel_;
  double step_s_;
  std::chrono::nanoseconds time_{0};
};

}  // namespace stanok::plant
