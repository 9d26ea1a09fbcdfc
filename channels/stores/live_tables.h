// The live tables of the machine: tools, work offsets and reference points, read by all
// preparations, written by programs and operators.
//
// Which entries exist is fixed when the machine starts, but for the free places of tools, which an
// operator's value fills; each value is read and written atomically,
// by programs in the cycle, reference points by the preparation of their channel alone. Names:
// "G54".."G59", "G59.1".."G59.3", "G54.1 P1".. for the work offsets; absent rows are zero. Any
// thread.
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
#include "lang/contract/environment.h"

namespace stanok::channels {

// The table name of a work offset number: 1 = "G54" ... 7 = "G59.1", 10 = "G54.1 P1".
[[nodiscard]] std::string work_offset_name(int number);

// "G28" for 1, "G30 P2" to "G30 P4".
[[nodiscard]] std::string reference_point_name(int which);
// The number of work_offset_name; 0: there is no such offset.
[[nodiscard]] int work_offset_number(std::string_view name) RT_SAFE;

// Programs may be kept from writing by the machine file; operators may not.
enum class Writer : std::uint8_t { program, person };

class LiveTables {
 public:
  explicit LiveTables(const MachineConfig& machine);

  // Offset of one axis (mm or deg); nothing when the work offset does not exist.
  [[nodiscard]] std::optional<double> offset(int number, const std::string& axis) const;
  [[nodiscard]] std::optional<ToolEdge> tool(int number, int edge) const;
  [[nodiscard]] TablesConfig snapshot() const;

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
  // `axis` of the calls above by the name of the machine's axis, "R": the rotation; -1: none.
  [[nodiscard]] int column(std::string_view axis) const RT_SAFE;
  // "X" or "R" of an axis that has an offset.
  [[nodiscard]] std::string_view column_name(int axis) const RT_SAFE {
    return columns_[axis == lang::rotation_of_offset ? column_count() - 1 : axis];
  }
  [[nodiscard]] std::optional<double> tool_value(int number, int edge, int value) const RT_SAFE;
  // Number 0 where there is no such tool, and of tool 0, which is none.
  [[nodiscard]] ToolRow row(int number, int edge) const RT_SAFE;
  // How often values of tools were written: as long as it is the same, so are the rows.
  [[nodiscard]] std::uint64_t tool_writes() const RT_SAFE {
    return tool_writes_.load(std::memory_order_acquire);
  }
  // A tool is there, or an operator's value would make one.
  [[nodiscard]] bool has_place(int number, int edge) const RT_SAFE;
  [[nodiscard]] bool set_tool_value(int number, int edge, int value, double to,
                                    Writer writer = Writer::program) RT_SAFE;
  // What is plausible. Writes are not held against it: whoever has confirmed a value may.
  [[nodiscard]] const EntryBounds& bounds() const RT_SAFE { return bounds_; }

 private:
  struct ToolPlace {
    ToolEdge fixed;           // number, edge, name, kind, shape
    ToolRow row;              // of the same
    bool is_default = false;  // no row of the tables: left out of a snapshot until it is written
    std::atomic<bool> exists{true};                            // false: a free place
    NumberedArray<std::atomic<double>, tool_values> values{};  // ToolValue less 1
  };

  // A tool that exists.
  [[nodiscard]] const ToolPlace* find(int number, int edge) const RT_SAFE;
  // Its number in `tools_`, or that of a free place; -1: there is none.
  [[nodiscard]] int find_place(int number, int edge) const RT_SAFE;
  [[nodiscard]] int column_count() const RT_SAFE { return static_cast<int>(columns_.size()); }
  [[nodiscard]] int cell(int number, int axis) const RT_SAFE {
    return (number - 1) * column_count() + axis;
  }

  void read_reference_points(int channel, const TablesConfig& tables);
  void add_reference_points(int channel, TablesConfig& tables) const;
  void read_variables(int channel, const TablesConfig& tables);
  void add_variables(int channel, TablesConfig& tables) const;
  [[nodiscard]] int variable_cell(int channel, int number) const;
  [[nodiscard]] int reference_cell(int channel, int which, std::string_view axis) const;

  NumberedList<std::string> columns_;  // of the offsets: the axes, and R, the rotation
  std::vector<int> channels_;          // ids
  bool write_protected_ = false;
  bool unnamed_tools_ = true;
  EntryBounds bounds_;
  NumberedList<std::atomic<double>> offsets_;           // by cell()
  NumberedList<std::atomic<double>> reference_points_;  // by reference_cell()
  NumberedList<std::atomic<double>> variables_;         // by variable_cell()
  NumberedList<ToolPlace> tools_;                       // ascending by number and edge
  std::atomic<std::uint64_t> tool_writes_{0};
};

// The row of the tool at work, looked for again when tool or table have changed.
class RowAtWork {
 public:
  [[nodiscard]] const ToolRow& of(const LiveTables& tables, int number, int edge) RT_SAFE {
    const std::uint64_t writes = tables.tool_writes();
    if (number == number_ && edge == edge_ && writes == writes_) return row_;
    row_ = tables.row(number, edge);
    number_ = number;
    edge_ = edge;
    writes_ = writes;
    return row_;
  }
  // What `of` gave last.
  [[nodiscard]] const ToolRow& row() const RT_SAFE { return row_; }

 private:
  ToolRow row_;
  int number_ = 0;
  int edge_ = 1;
  std::uint64_t writes_ = 0;
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
