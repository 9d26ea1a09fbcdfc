// A simulated vibration sensor with its own memory of samples: the sine that the process makes, as
// 16-bit samples behind their count (drives/vibration.h).
#pragma once

#include <modbus/modbus.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "drives/vibration.h"
#include "plant/drive/simulated_drive.h"

namespace stanok::plant {

class VibrationModule {
 public:
  explicit VibrationModule(const drives::VibrationSensorConfig& config);

  [[nodiscard]] const drives::VibrationSensorConfig& config() const { return config_; }

  // Takes the samples of the next `dt_s`.
  void advance(const ProcessLoad& load, double dt_s);
  [[nodiscard]] modbus_mapping_t* registers();

 private:
  struct Unmap {
    void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
  };

  drives::VibrationSensorConfig config_;
  std::unique_ptr<modbus_mapping_t, Unmap> registers_;
  std::vector<std::int16_t> samples_;  // a ring; the next one goes to `next_`
  std::size_t next_ = 0;
  std::uint16_t taken_ = 0;
  double due_ = 0.0;    // share of the next sample that has passed
  double phase_ = 0.0;  // of the vibration, rad
};

}  // namespace stanok::plant
