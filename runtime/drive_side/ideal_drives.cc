#include "runtime/drive_side/ideal_drives.h"

#include <algorithm>

namespace stanok::runtime {

std::span<const channels::SpindleSensors> IdealDrives::sensors() RT_SAFE {
  if (process_ == nullptr) return {};
  return process_->sensors();
}

double IdealDrives::position_of(int axis, const channels::CycleOutput& last) const RT_SAFE {
  for (std::size_t c = 0; c < machine_.channels.size(); ++c) {
    const std::vector<int>& axes = machine_.channels[c].axes;
    const auto place = std::ranges::find(axes, axis);
    if (place != axes.end() && last.channel_count > 0)
      return last.channels[c].axes[static_cast<std::size_t>(place - axes.begin())].position;
  }
  return machine_.axes[static_cast<std::size_t>(axis)].start;
}

}  // namespace stanok::runtime
