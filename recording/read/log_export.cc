#include "recording/read/log_export.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <string>

#include "recording/read/setpoint_walk.h"

namespace stanok::recording {
namespace {

constexpr std::size_t write_threshold = 1UL << 16;  // bytes

// Rows of comma-separated numbers, gathered before they are written.
class CsvRows {
 public:
  explicit CsvRows(std::FILE* csv) : csv_(csv) {}

  template <class Number>
  void add(Number value) {
    std::array<char, 32> digits{};  // enough for every double and 64-bit integer
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    add_text({digits.data(), end});
  }
  void add_text(std::string_view text) {
    if (!is_row_start_) text_ += ',';
    text_ += text;
    is_row_start_ = false;
  }
  void end_row() {
    text_ += '\n';
    is_row_start_ = true;
    if (text_.size() > write_threshold) write();
  }
  // False when something could not be written, errno says why.
  bool finish() {
    write();
    return is_good_ && std::fflush(csv_) == 0;
  }

 private:
  void write() {
    is_good_ = is_good_ && std::fwrite(text_.data(), 1, text_.size(), csv_) == text_.size();
    text_.clear();
  }

  std::FILE* csv_;
  std::string text_;
  bool is_row_start_ = true;
  bool is_good_ = true;
};

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
