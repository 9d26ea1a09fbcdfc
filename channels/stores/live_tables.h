// The live tables of the machine: tools, work offsets and reference points, read by all
// preparations, written by programs and operators.
//
// Which entries exist is fixed when the machine starts (table_layout.h). Values of tools and
// offsets are written by the cycle alone, each write with a number, so that a preparation reads a
// copy of its own that it brings up to a write (table_view.h); reference points and common
// variables by the preparation of their channel alone. Any thread.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/numbered.h"
#include "base/rt_safe.h"
#include "channels/contract/entry_bounds.h"
#include "channels/contract/machine_config.h"
#include "channels/contract/tool_row.h"
#include "channels/contract/tool_value.h"
#include "channels/messages/request.h"
#include "channels/stores/table_layout.h"
#include "channels/stores/table_writes.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

// "G28" for 1, "G30 P2" to "G30 P4".
[[nodiscard]] std::string reference_point_name(int which);

// Programs may be kept from writing by the machine file; operators may not.
enum class Writer : std::uint8_t { program, person };

class LiveTables {
 public:
  explicit LiveTables(const MachineConfig& machine);

  [[nodiscard]] TablesConfig snapshot() const;

  // For copies of tools and offsets.
  [[nodiscard]] const TableLayout& layout() const RT_SAFE { return layout_; }
  [[nodiscard]] const TableWrites& writes() const RT_SAFE { return writes_; }
  [[nodiscard]] double value_of(int cell) const RT_SAFE {
    return cells_[cell].load(std::memory_order_acquire);
  }
  // Whether the tool of a place is there from the start.
  [[nodiscard]] bool begins_present(int place) const RT_SAFE;

  // A coordinate in M of reference point `which` from 1. The machine has the channel (its id) and
  // the axis.
  [[nodiscard]] double reference_point(int channel, int which, std::string_view axis) const;
  void store_reference_point(int channel, int which, std::string_view axis, double value);

  // Common variable #500 to #999 of a channel; NaN: vacant. Written by its preparation alone.
  [[nodiscard]] double variable(int channel, int number) const;
  void set_variable(int channel, int number, double value);

  // The cycle: single values. `axis` counts among all axes of the machine, or is
  // lang::rotation_of_offset (deg). Nothing, or false, when
  // there is no such entry; a write also when the value is out of range or the tables are
  // write-protected.
  [[nodiscard]] std::optional<double> offset(int number, int axis) const RT_SAFE;
  [[nodiscard]] bool set_offset(int number, int axis, double value, Writer writer = Writer::program)
      RT_SAFE;
  [[nodiscard]] std::optional<double> tool_value(int number, int edge, int value) const RT_SAFE;
  // Number 0 where there is no such tool, and of tool 0, which is none.
  [[nodiscard]] ToolRow row(int number, int edge) const RT_SAFE;
  // The number of the newest write: as long as it is the same, so are all values.
  [[nodiscard]] std::uint64_t version() const RT_SAFE { return writes_.newest(); }
  // A tool is there, or an operator's value would make one.
  [[nodiscard]] bool has_place(int number, int edge) const RT_SAFE;
  [[nodiscard]] bool set_tool_value(int number, int edge, int value, double to,
                                    Writer writer = Writer::program) RT_SAFE;
  // What is plausible. Writes are not held against it: whoever has confirmed a value may.
  [[nodiscard]] const EntryBounds& bounds() const RT_SAFE { return bounds_; }

 private:
  // The place of a tool that is there; -1: none.
  [[nodiscard]] int find(int number, int edge) const RT_SAFE;
  void write(int cell, double value) RT_SAFE;
  void read_tools_and_offsets(const TablesConfig& tables);

  void read_reference_points(int channel, const TablesConfig& tables);
  void add_reference_points(int channel, TablesConfig& tables) const;
  void read_variables(int channel, const TablesConfig& tables);
  void add_variables(int channel, TablesConfig& tables) const;
  [[nodiscard]] int variable_cell(int channel, int number) const;
  [[nodiscard]] int reference_cell(int channel, int which, std::string_view axis) const;

  TableLayout layout_;
  std::vector<int> channels_;  // ids
  bool write_protected_ = false;
  bool unnamed_tools_ = true;
  EntryBounds bounds_;
  NumberedList<std::atomic<double>> cells_;             // of the layout
  TableWrites writes_;                                  // of `cells_`
  NumberedList<std::atomic<double>> reference_points_;  // by reference_cell()
  NumberedList<std::atomic<double>> variables_;         // by variable_cell()
};

// The row of the tool at work, looked for again when tool or table have changed.
class RowAtWork {
 public:
  [[nodiscard]] const ToolRow& of(const LiveTables& tables, int number, int edge) RT_SAFE {
    const std::uint64_t version = tables.version();
    if (number == number_ && edge == edge_ && version == version_) return row_;
    row_ = tables.row(number, edge);
    number_ = number;
    edge_ = edge;
    version_ = version;
    return row_;
  }
  // What `of` gave last.
  [[nodiscard]] const ToolRow& row() const RT_SAFE { return row_; }

 private:
  ToolRow row_;
  int number_ = 0;
  int edge_ = 1;
  std::uint64_t version_ = 0;
};

// Reads or writes what a program asks of the tables; `machine_axes`: the axes of its channel,
// counted among all axes of the machine. Nothing when there is no such entry, when it cannot be
// written so, or when something else is asked for.
[[nodiscard]] std::optional<double> execute_table_request(LiveTables& tables,
                                                          const Request& request,
                                                          NumberedSpan<const int> machine_axes)
    RT_SAFE;

// Why a program must not write this into the tables, for E5022; empty: it may, or there is no such
// entry, or it writes nothing.
[[nodiscard]] ReasonText implausible_entry(const LiveTables& tables, const Request& request,
                                           NumberedSpan<const int> machine_axes) RT_SAFE;

}  // namespace stanok::channels
