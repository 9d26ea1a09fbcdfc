// ChannelTables: the tables as the interpreter of one channel sees them: tools and work offsets as
// they were behind a write (table_view.h), the rest as it is.
//
// Thread: that of the channel's preparation. Owner: its parts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/ring.h"
#include "channels/contract/machine_config.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/table_view.h"
#include "kinematics/direction_choice.h"
#include "kinematics/length_changes.h"
#include "kinematics/scheme.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

// How the row of a tool is in a length.
[[nodiscard]] kinematics::ToolRow row_of(const lang::ToolLength& length);

class ChannelTables final : public lang::Tables {
 public:
  // `lengths`: changes of a run that count at once, each there before its write; nullptr: there are
  // none.
  ChannelTables(LiveTables& live, const MachineConfig& machine, const ChannelConfig& channel,
                Ring<kinematics::LengthChange>* lengths = nullptr);

  [[nodiscard]] std::optional<lang::AxisValues> work_offset(int number) const override;
  [[nodiscard]] double work_offset_rotation(int number) const override;
  [[nodiscard]] std::optional<lang::Tool> tool(int number) const override;
  [[nodiscard]] std::optional<lang::Tool> tool_edge(int number, int edge) const override;
  [[nodiscard]] std::uint64_t version() const override { return view_.version(); }
  [[nodiscard]] lang::ToolLength in_force(const lang::ToolLength& length) const override;
  [[nodiscard]] lang::MachineReading machine_reading() const override { return reading_; }
  [[nodiscard]] lang::AxisValues reference_point(int which) const override;
  void store_reference_point(int which, const lang::AxisValues& point_M) override;
  [[nodiscard]] double common_variable(int number) const override {
    return live_.variable(channel_, number);
  }
  void set_common_variable(int number, double value) override {
    live_.set_variable(channel_, number, value);
  }

  [[nodiscard]] lang::AxisSet axes_of_scheme() const override { return axes_of_scheme_; }
  [[nodiscard]] lang::AxisSet leading_axes() const override;

  [[nodiscard]] lang::Alignment alignment(const lang::AlignmentWish& wish) const override;
  [[nodiscard]] std::optional<lang::AxisValues> carried_by_table(
      const lang::AxisValues& point_B, const lang::AxisValues& position_B) const override;
  [[nodiscard]] std::array<lang::Direction, 3> spindle_axes(
      const lang::AxisValues& position_B) const override;

  // The copy of tools and offsets, brought up to a write by whoever runs the interpreter.
  [[nodiscard]] const TableView& view() const { return view_; }
  // The number of the newest write of all.
  [[nodiscard]] std::uint64_t newest_version() const { return live_.version(); }
  void advance_to(std::uint64_t version);
  // A run begins: what is read from now on is read anew.
  void begin_run() { length_changes_.forget(); }
  // Of lengths, in this run.
  [[nodiscard]] const kinematics::LengthChanges& length_changes() const { return length_changes_; }

  // The scheme that is active from now on; it outlives the tables.
  void set_scheme(const kinematics::Scheme& scheme);

 private:
  LiveTables& live_;
  TableView view_;
  Ring<kinematics::LengthChange>* lengths_to_come_;
  kinematics::LengthChanges length_changes_;
  int channel_;
  std::vector<std::string> axis_names_;
  AxisList<kinematics::AngleTravel> travel_;  // as the axes read it
  const kinematics::Scheme* scheme_ = nullptr;
  lang::MachineReading reading_;
  lang::AxisSet axes_of_scheme_ = 0;
};

}  // namespace stanok::channels
