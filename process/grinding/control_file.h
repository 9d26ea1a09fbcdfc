// The control file of a plunge cycle, in the form of figure 9 of the paper: the sheet of the
// process, one number a line, then the table of the infeed.
//
//   30.0 - radius of the part, mm              3.600 - C_p
//   20.0 - width                               0.560 - alpha
//   200.0 - radius of the wheel                0.010   permitted deflection, mm
//   25000000.0 - stiffness, N/m                0.090   critical allowance, mm
//   32.0 - reduced mass, kg                    0.050   Q_end, mm2/rad
//   50911.7 - viscous friction, N s/m          11 - number of intervals: rows less one
//   120.0 - speed of the part, rev/min         0.3000 0.0400   X mm, feed mm/s
//
// What stands behind the numbers is a label and free. A file is written as it was read: labels,
// decimals, blank lines and line ends stay, and a number that has not changed keeps its digits.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "process/grinding/grinding_process.h"
#include "process/grinding/infeed_law.h"

namespace stanok::process {

// A line as it was read: `numbers` with what stands before, between and behind them.
struct ControlLine {
  std::vector<std::string> numbers;  // none: a blank line
  std::vector<std::string> between;  // one more than numbers
};

struct ControlFile {
  GrindingProcess process;
  InfeedLaw law;  // X from the allowance down, mm; feed in mm/s
  // How it is written; empty: with the labels and decimals of the paper.
  std::vector<ControlLine> lines{};

  [[nodiscard]] double allowance_mm() const { return law.front().x_mm; }
};

// All errors of a text, with line and column, or the file. `name` stands in the places.
[[nodiscard]] Expected<ControlFile, Diagnostics> read_control_text(std::string_view text,
                                                                   const std::string& name);

[[nodiscard]] std::string control_text(const ControlFile& file);

}  // namespace stanok::process
