#include "config/files/machine_remarks.h"

#include "channels/contract/machine_config.h"
#include "config/text/key_table.h"

namespace stanok::config {

// Between two polls a drive goes on with the velocity of the one before, while a stop brakes: where
// that is farther than it may stray the drive may trip in each stop.
std::vector<std::string> remarks_on(const MachineFile& machine) {
  std::vector<std::string> remarks;
  const double poll_s = machine.bus.poll_ms * 1e-3;
  for (const drives::AxisDriveConfig& drive : machine.bus.axes) {
    const double apart = 0.5 * drive.target_acceleration_max * poll_s * poll_s;
    if (drive.kind != drives::DriveKind::position || apart <= drive.following_error_max) continue;
    remarks.push_back("axis " + drive.axis + ": a stop brakes at " +
                      number_text(drive.target_acceleration_max) +
                      " /s2 (acceleration_max x stop_limits), and a drive that is polled every " +
                      std::to_string(machine.bus.poll_ms) + " ms is " + number_text(apart) +
                      " away from its setpoint when the stop reaches it; following_error_max is " +
                      number_text(drive.following_error_max) +
                      ". Poll it more often, lower acceleration_max or stop_limits, or raise "
                      "following_error_max");
  }
  return remarks;
}

}  // namespace stanok::config
