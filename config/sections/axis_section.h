// [[axis]] and [[spindle]] of the machine file.
#pragma once

#include <optional>
#include <vector>

#include "channels/contract/machine_config.h"
#include "config/sections/machine_description.h"
#include "config/text/key_table.h"
#include "drives/bus_config.h"

namespace stanok::config {

// One [[axis]]: its part in the channels and its drive on the bus.
struct AxisSection {
  channels::AxisConfig axis;
  drives::AxisDriveConfig drive;
  AxisSimulation plant;
};

// All axes in the order of the file.
[[nodiscard]] std::vector<AxisSection> read_axes(Subtables axes, const Scope& scope);

// One [[spindle]] and its drive, if it has one of its own.
struct SpindleSection {
  channels::SpindleConfig spindle;
  std::optional<drives::AxisDriveConfig> drive;
};

// All spindles; `axes` are the axes a spindle may become.
[[nodiscard]] std::vector<SpindleSection> read_spindles(Subtables spindles,
                                                        const std::vector<AxisSection>& axes,
                                                        const Scope& scope);

// One of the letters A B C U V W X Y Z, then digits: "X", "C1".
[[nodiscard]] bool is_axis_name(std::string_view name);

// Whether every axis has a name of its own, so that other sections can refer to it.
[[nodiscard]] bool names_are_right(const std::vector<AxisSection>& axes);

// Rows of the documentation, by TOML table.
[[nodiscard]] std::vector<KeyRow> axis_key_rows();
[[nodiscard]] std::vector<KeyRow> homing_key_rows();
[[nodiscard]] std::vector<KeyRow> controller_key_rows();
[[nodiscard]] std::vector<KeyRow> spindle_key_rows();

}  // namespace stanok::config
