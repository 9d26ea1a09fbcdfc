// ModbusDrives: drives on a Modbus bus: those of the machine file, or simulated ones behind a
// server of their own on loopback.
#pragma once

#include <memory>
#include <vector>

#include "drives/modbus/modbus_bus.h"
#include "plant/modbus/modbus_server.h"
#include "runtime/drive_side/drive_exchange.h"
#include "runtime/drive_side/drive_side.h"

namespace stanok::runtime {

enum class DrivesBehindBus { real, simulated };

class ModbusDrives final : public DriveSide {
 public:
  // The server of simulated drives runs from here on. Throws as make_drive_side does.
  ModbusDrives(const DriveSurroundings& surroundings, DrivesBehindBus drives);
  ~ModbusDrives() override { stop(); }

  void start() override { bus_.start(); }
  void stop() override;

  void read(std::span<const channels::OperatorEvent> events) RT_SAFE override {
    exchange_.read(events);
  }
  [[nodiscard]] std::span<const channels::AxisFeedback> feedback() const RT_SAFE override {
    return exchange_.feedback();
  }
  [[nodiscard]] std::span<const channels::SpindleSensors> sensors() RT_SAFE override {
    return exchange_.sensors();
  }
  [[nodiscard]] std::optional<Signals> signals() RT_SAFE override;
  [[nodiscard]] double position_of(int axis, const channels::CycleOutput& /*last*/) const
      RT_SAFE override {
    return exchange_.position_of(axis);
  }
  void write(const channels::CycleOutput& output) RT_SAFE override;

  [[nodiscard]] drives::BusStatus status() const override { return bus_.status(); }
  [[nodiscard]] bool reset_drive(std::string_view drive) override {
    return exchange_.demand_reset(drive);
  }
  [[nodiscard]] bool inject_fault(std::string_view drive, plant::FaultKind fault) override;

 private:
  std::vector<plant::SimulatedDriveConfig> simulated_;  // in the order of the bus; empty: real ones
  std::unique_ptr<plant::ModbusServer> server_;         // nullptr: real ones
  drives::ModbusBus bus_;
  DriveExchange exchange_;
  const ProcessPlant* process_;
  bool has_signals_;
};

}  // namespace stanok::runtime
