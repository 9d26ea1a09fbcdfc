#include "recording/read/log_export.h"

#include <cerrno>
#include <string>

#include "recording/read/csv_rows.h"
#include "recording/read/setpoint_walk.h"

namespace stanok::recording {
namespace {

void add_heading(const std::vector<AxisDescription>& axes, CsvRows& rows) {
  for (const char* name :
       {"time_s", "cycle", "seq", "state", "flags", "run", "file", "line", "block", "scheme",
        "feed_commanded_mm_per_s", "path_speed_mm_per_s", "feed_override"}) {
    rows.add_text(name);
  }
  for (const AxisDescription& axis : axes) {
    const std::string unit = axis.rotary ? "deg" : "mm";
    rows.add_text("tip_" + axis.word + "_" + unit);
    rows.add_text("tip_velocity_" + axis.word + "_" + unit + "_per_s");
  }
  for (const AxisDescription& axis : axes) {
    const std::string unit = axis.rotary ? "deg" : "mm";
    rows.add_text(axis.name + "_" + unit);
    rows.add_text(axis.name + "_velocity_" + unit + "_per_s");
    rows.add_text(axis.name + "_acceleration_" + unit + "_per_s2");
    rows.add_text(axis.name + "_jerk_" + unit + "_per_s3");
    rows.add_text(axis.name + "_position_code");
    rows.add_text(axis.name + "_velocity_code");
  }
  rows.end_row();
}

void add_row(const setpoint_t& setpoint, double time_s, std::size_t axis_count, CsvRows& rows) {
  rows.add(time_s);
  rows.add(setpoint.cycle);
  rows.add(setpoint.seq);
  rows.add(static_cast<int>(setpoint.state));
  rows.add(static_cast<int>(setpoint.flags));
  rows.add(setpoint.run);
  rows.add(static_cast<int>(setpoint.file));
  rows.add(setpoint.line);
  rows.add(setpoint.block);
  rows.add(setpoint.scheme);
  rows.add(setpoint.feed_commanded);
  rows.add(setpoint.path_speed);
  rows.add(setpoint.feed_override);
  for (std::size_t k = 0; k < axis_count; ++k) {
    rows.add(setpoint.tip_position[k]);
    rows.add(setpoint.tip_velocity[k]);
  }
  for (std::size_t k = 0; k < axis_count; ++k) {
    rows.add(setpoint.position[k]);
    rows.add(setpoint.velocity[k]);
    rows.add(setpoint.acceleration[k]);
    rows.add(setpoint.jerk[k]);
    rows.add(setpoint.position_code[k]);
    rows.add(setpoint.velocity_code[k]);
  }
  rows.end_row();
}

}  // namespace

Expected<std::int64_t, LogError> export_setpoints(const std::filesystem::path& file,
                                                  const LogContents& contents, int channel,
                                                  std::FILE* csv) {
  CsvRows rows(csv);
  std::int64_t count = 0;
  std::vector<AxisDescription> axes;
  const auto error = for_each_setpoint(file, contents, channel, [&](const setpoint_t& setpoint) {
    if (count++ == 0) {
      axes = axes_of(contents, channel, from_setpoint(setpoint).axis_count);
      add_heading(axes, rows);
    }
    const double time_s = static_cast<double>(setpoint.utime - contents.utime_first) * 1e-6;
    add_row(setpoint, time_s, axes.size(), rows);
  });
  if (error) return Unexpected<LogError>(*error);
  if (!rows.finish()) {
    return Unexpected<LogError>(log_error("cannot write CSV", errno));
  }
  return count;
}

}  // namespace stanok::recording
