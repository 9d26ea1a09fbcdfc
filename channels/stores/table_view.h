// TableView: the tables of tools and work offsets as they were behind one write.
//
// The copy that a preparation reads: what others write meanwhile counts from where the copy is
// brought up to it, and that place can be recorded and repeated. Thread: one at a time, beside the
// cycle, which writes. Owner: the tables of a channel. Invariant: all cells are as they were behind
// the write version().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "channels/stores/live_tables.h"

namespace stanok::channels {

class TableView {
 public:
  // As the tables are now; they outlive the view.
  explicit TableView(const LiveTables& live) : live_(live) { copy(); }

  // The number of the newest write that it has.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  // Behind a later write. At most the newest one; one that it has already changes nothing. If it is
  // too far behind to follow, it goes on to the newest one.
  void advance_to(std::uint64_t version);

  // As the calls of LiveTables, and by the name of an axis of the machine.
  [[nodiscard]] std::optional<double> offset(int number, int axis) const;
  [[nodiscard]] std::optional<double> offset(int number, const std::string& axis) const;
  [[nodiscard]] std::optional<double> tool_value(int number, int edge, int value) const;
  [[nodiscard]] std::optional<ToolEdge> tool(int number, int edge) const;
  // Tools and offsets as a file has them: without rows that nobody has written.
  [[nodiscard]] TablesConfig rows() const;

 private:
  void copy();
  // -1: there is none.
  [[nodiscard]] int place_of_tool(int number, int edge) const;
  [[nodiscard]] ToolEdge edge_at(int place) const;

  const LiveTables& live_;
  std::uint64_t version_ = 0;
  NumberedList<double> cells_;
};

}  // namespace stanok::channels
