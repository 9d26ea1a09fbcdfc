// [axis.drive] and [spindle.drive]: a drive on the bus, its registers, its bits and its words.
#pragma once

#include <vector>

#include "config/text/key_table.h"
#include "drives/bus_config.h"

namespace stanok::config {

// What a drive drives decides which registers it must have.
enum class DriveLoad { axis, spindle };

// The keys of the bus; the times of brake and power belong to the axis.
struct DriveSection {
  drives::AxisDriveConfig drive;
  double brake_s = 0.1;
  double power_s = 0.1;
};

// `section` comes with the defaults of its axis or spindle.
void read_drive(const toml::table& table, DriveLoad load, DriveSection& section,
                const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> drive_key_rows();
[[nodiscard]] std::vector<KeyRow> run_word_key_rows();

}  // namespace stanok::config
