// ProcessPlant: the cut of a simulated machine, between its setpoints and its sensors.
//
// Follows tool and master spindle of the channel of [simulation.cutting], and gives the power and
// the vibration that its sensors would: with ideal drives as values sampled and held, else as the
// load of the simulated spindle drive, which its bus then brings. Real-time; allocates in its
// constructor only.
#pragma once

#include <span>
#include <vector>

#include "base/axis_index.h"
#include "channels/machine/machine.h"
#include "config/files/machine_file.h"
#include "drives/vibration_meter.h"
#include "plant/cutting/cutting_process.h"
#include "plant/drive/simulated_drive.h"
#include "plant/mechanics/spindle_plant.h"

namespace stanok::runtime {

class ProcessPlant {
 public:
  // Throws std::invalid_argument where the channel of the cut has no spindle.
  explicit ProcessPlant(const config::MachineFile& file);

  // One cycle on.
  void advance(const channels::CycleOutput& output) RT_SAFE;

  // The sensors of all spindles of the machine; their power includes the idle power.
  [[nodiscard]] std::span<const channels::SpindleSensors> sensors() const RT_SAFE {
    return sensors_;
  }
  // What the drive of the spindle has to bear.
  [[nodiscard]] const plant::ProcessLoad& load() const RT_SAFE { return load_; }
  [[nodiscard]] std::size_t spindle() const RT_SAFE { return spindle_; }  // index in the machine
  [[nodiscard]] const plant::CuttingProcess& cut() const RT_SAFE { return cut_; }

 private:
  double cycle_s_;
  double power_lag_s_;
  std::int64_t sample_cycles_;
  std::size_t channel_ = 0;  // index in the machine
  std::size_t spindle_ = 0;
  AxisIndex x_ = 0;
  AxisIndex z_ = 0;
  plant::CuttingProcess cut_;
  plant::SpindlePlant motor_;
  drives::VibrationMeter meter_;
  double power_w_ = 0.0;  // behind the lag of the sensor
  plant::ProcessLoad load_;
  std::vector<channels::SpindleSensors> sensors_;
};

}  // namespace stanok::runtime
