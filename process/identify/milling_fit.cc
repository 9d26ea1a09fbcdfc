#include "process/identify/milling_fit.h"

#include <algorithm>

namespace stanok::process {
namespace {

constexpr double w_per_n_mm_per_s = 1e-3;
constexpr double thickness_differs = 0.1;

DriveRecord drive_record_of_milling(const MillingRecord& record) {
  DriveRecord drive{.cycle_s = record.cycle_s};
  for (const MillingRow& row : record.rows) {
    drive.rev_per_min.push_back(row.rev_per_min);
    drive.power_w.push_back(row.power_w);
    drive.cuts.push_back(row.rubbing_mm2_per_s > 0.0);
  }
  return drive;
}

// Whether the readings of the cut have chips of several mean thicknesses; without the thinnest and
// the thickest tenth, where the tool enters and leaves.
bool has_thicknesses(const MillingRecord& record, const DriveRecord& drive) {
  std::vector<double> in_cut;
  for (const std::size_t row : reading_rows(drive)) {
    if (drive.cuts[row])
      in_cut.push_back(record.rows[row].removal_mm3_per_s / record.rows[row].rubbing_mm2_per_s);
  }
  std::ranges::sort(in_cut);
  const double least = in_cut[in_cut.size() / 10];
  const double most = in_cut[in_cut.size() * 9 / 10];
  return most >= (1.0 + thickness_differs) * least;
}

}  // namespace

Expected<MillingFit, std::string> fit_milling(const MillingRecord& record) {
  const DriveRecord drive = drive_record_of_milling(record);
  if (std::string lacks = what_lacks(drive); !lacks.empty())
    return Unexpected<std::string>(std::move(lacks));
  if (!has_thicknesses(record, drive)) {
    return Unexpected<std::string>(
        "the cut has chips of one thickness only, which does not tell the force of the edges from "
        "that of the chip; change the feed");
  }
  constexpr double usual_force = 1000.0;  // N/mm2
  constexpr double usual_edge = 10.0;     // N/mm
  const CutModel cut{.begin = {usual_force, usual_edge},
                     .scale = {usual_force, usual_edge},
                     .power =
                         [&](const std::array<double, 2>& figures, std::vector<double>& watts) {
                           for (std::size_t k = 0; k < watts.size(); ++k) {
                             const MillingRow& row = record.rows[k];
                             watts[k] = w_per_n_mm_per_s * (figures[0] * row.removal_mm3_per_s +
                                                            figures[1] * row.rubbing_mm2_per_s);
                           }
                         },
                     .law_w = {}};
  auto fitted = fit_drive(drive, cut);
  if (!fitted) return Unexpected<std::string>(std::move(fitted.error()));
  if (fitted->figures[0].low <= 0.0) return Unexpected<std::string>(not_of_the_cut);
  return MillingFit{{std::move(fitted->drive)}, fitted->figures[0], fitted->figures[1]};
}

}  // namespace stanok::process
