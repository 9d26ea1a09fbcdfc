#include "runtime/drive_side/ideal_drives.h"

#include <algorithm>

namespace stanok::runtime {

std::span<const channels::SpindleSensors> IdealDrives::sensors() RT_SAFE {
  if (process_ == nullptr) return {};
  return process_->sensors();
}

double IdealDrives::position_of(int axis, const channels::CycleOutput& last) const RT_SAFE {
  for (std::size_t c = 0; c < machine_.channels.size(); ++c) {
    const AxisList<int>& axes = machine_.channels[c].axes;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (axes[k] == axis && last.channel_count > 0) return last.channels[c].axes[k].position;
    }
  }
  return machine_.axes[axis].start;
}

}  // namespace stanok::runtime
