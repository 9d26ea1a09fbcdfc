// The drives of a bus in the order of its targets.
#include "drives/bus_config.h"

namespace stanok::drives {

std::vector<AxisDriveConfig> drives_of(const BusConfig& bus) {
  std::vector<AxisDriveConfig> drives = bus.axes;
  drives.insert(drives.end(), bus.spindles.begin(), bus.spindles.end());
  return drives;
}

}  // namespace stanok::drives
