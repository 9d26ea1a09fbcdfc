// The tool that is in place, and rows of the tables that an operator has changed.
#pragma once

namespace stanok::lang {

// The tool in the spindle or at the working place of the turret; number 0: none.
struct ToolInPlace {
  int number = 0;
  int edge = 1;
};

struct ChangedRows {
  bool all = false;
  int tool = 0;  // 0: none
  int edge = 1;
  int work_offset = 0;  // 0: none

  [[nodiscard]] bool has_tool(int number, int of_edge) const {
    return all || (tool == number && edge == of_edge);
  }
  [[nodiscard]] bool has_offset(int number) const { return all || work_offset == number; }
};

}  // namespace stanok::lang
