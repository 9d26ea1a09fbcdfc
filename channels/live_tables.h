// The live tables of the machine: tools and work offsets, read by all preparations, written by
// programs and operators.
//
// Names: "G54".."G59", "G59.1".."G59.3", "G54.1 P1".. for the work offsets; absent rows are zero.
// Any thread.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "channels/machine_config.h"
#include "lang/environment.h"

namespace stanok::channels {

// The table name of a work offset number: 1 = "G54" ... 7 = "G59.1", 10 = "G54.1 P1".
[[nodiscard]] std::string work_offset_name(int number);

class LiveTables {
 public:
  explicit LiveTables(const TablesConfig& initial);

  // Offset of one axis (mm or deg); nothing when the work offset does not exist.
  [[nodiscard]] std::optional<double> offset(int number, const std::string& axis) const;
  [[nodiscard]] std::optional<ToolEdge> tool(int number, int edge) const;
  [[nodiscard]] TablesConfig snapshot() const;

 private:
  mutable std::mutex mutex_;
  TablesConfig tables_;
};

// The tables as the interpreter of one channel sees them.
class ChannelTables final : public lang::Tables {
 public:
  ChannelTables(const LiveTables& live, const MachineConfig& machine, const ChannelConfig& channel);

  [[nodiscard]] std::optional<lang::AxisValues> work_offset(int number) const override;
  [[nodiscard]] double work_offset_rotation(int number) const override;
  [[nodiscard]] std::optional<lang::Tool> tool(int number) const override;
  [[nodiscard]] lang::AxisValues scheme_zero() const override { return scheme_zero_; }

  void set_scheme_zero(const lang::AxisValues& zero) { scheme_zero_ = zero; }

 private:
  const LiveTables& live_;
  std::vector<std::string> axis_names_;
  lang::AxisValues scheme_zero_{};
};

}  // namespace stanok::channels
