#include "runtime/drive_side/drive_side.h"

#include "runtime/drive_side/direct_drives.h"
#include "runtime/drive_side/ideal_drives.h"
#include "runtime/drive_side/modbus_drives.h"

namespace stanok::runtime {

std::unique_ptr<DriveSide> make_drive_side(DriveChoice choice,
                                           const DriveSurroundings& surroundings) {
  switch (choice) {
    case DriveChoice::ideal:
      break;
    case DriveChoice::simulated:
      return std::make_unique<DirectDrives>(surroundings);
    case DriveChoice::embedded:
      return std::make_unique<ModbusDrives>(surroundings, DrivesBehindBus::simulated);
    case DriveChoice::real:
      return std::make_unique<ModbusDrives>(surroundings, DrivesBehindBus::real);
  }
  return std::make_unique<IdealDrives>(surroundings);
}

}  // namespace stanok::runtime
