// What is in force of a channel while nothing runs: the state in which the next line of an operator
// begins.
//
// Owner: the interpreter. The path of the preparation and the cycle are brought to it at the end of
// every run, behind a reset, and when an operator has changed a table; nobody makes it up from other
// values.
#pragma once

#include "lang/contract/command.h"

namespace stanok::lang {

struct Standing {
  FrameChange frame;
  ToolLength length;
  TransformationChange transformation;
};

// The tool in the spindle or at the working place of the turret; number 0: none.
struct ToolInPlace {
  int number = 0;
  int edge = 1;
};

// Rows of the tables that an operator has changed.
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
