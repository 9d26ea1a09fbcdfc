// What the log of a cut tells of drive, material and machine: the job behind `stanok process
// identify`, process.figures and identify_... of Python. Off line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "jobs/columns/columns.h"
#include "jobs/cutting/cut_log.h"
#include "jobs/cutting/figures.h"
#include "jobs/cutting/grind_log.h"
#include "jobs/cutting/milling_log.h"
#include "jobs/cutting/power_points.h"

namespace stanok::jobs {

// A cut whose log is to be read, and what is known of it.
struct LoggedTurning {
  std::filesystem::path log;
  CutLogRequest reading;
  double coefficient_n = 0.0;  // C of the material, which gives the efficiency; 0: it is not known
};
struct LoggedMilling {
  std::filesystem::path log;
  MillingLogRequest reading;
  std::string cut_text;     // of the file of tool and material
  double efficiency = 1.0;  // of the drive, known from elsewhere
};
struct LoggedPlunge {
  std::filesystem::path log;
  GrindLogRequest reading;
  process::GrindingProcess sheet;
  std::string process_text;  // of the process file
};

struct IdlePower {
  double rev_per_min = 0.0;   // the greatest speed of the record
  double power_w = 0.0;       // there
  double coulomb_part = 0.0;  // of it, that which grows with the speed
};

struct Identification {
  Figures figures;
  std::optional<IdlePower> idle;     // none: grinding, where it is one of the figures
  std::optional<double> efficiency;  // of the drive, as it was given
  double noise = 0.0;                // of the cutting power, standard deviation
  double residual_w = 0.0;           // rms
  int readings = 0;
  process::FitVerdict verdict;
  std::vector<PowerPoint> power;  // where there is a reading
  // A file with what was found: [process] of a machine file (turning), or the file that was given
  // with the new figures.
  std::string text;
};

// A row of the record, and the power of it that the model has.
template <class Row>
struct FittedRow {
  double time_s = 0.0;
  Row row;
  double fitted_w = 0.0;
};
template <class Row>
struct IdentifiedCut : Identification {
  std::vector<FittedRow<Row>> rows;
};
using IdentifiedTurning = IdentifiedCut<process::CutRow>;
using IdentifiedMilling = IdentifiedCut<process::MillingRow>;
using IdentifiedPlunge = IdentifiedCut<process::GrindRow>;

// They throw std::runtime_error with what the log lacks.
[[nodiscard]] IdentifiedTurning identify(const LoggedTurning& request);
[[nodiscard]] IdentifiedMilling identify(const LoggedMilling& request);
[[nodiscard]] IdentifiedPlunge identify(const LoggedPlunge& request);

// Each figure with value, low and high, in SI units, then what is said of the fit: "fit" with "ok",
// false where the figures are not those of the cut, "kind", "reason" and "remedy", of an "ok" fit
// where the intervals are widened.
[[nodiscard]] Fields identification_fields(const Identification& found);
// Of these, "fit".
[[nodiscard]] Fields fit_fields(const process::FitVerdict& verdict);

// time_s, what the record has, power_w, fitted_w.
[[nodiscard]] const Columns<FittedRow<process::CutRow>>& turning_row_columns();
[[nodiscard]] const Columns<FittedRow<process::MillingRow>>& milling_row_columns();
[[nodiscard]] const Columns<FittedRow<process::GrindRow>>& plunge_row_columns();

}  // namespace stanok::jobs
