#include "process/identify/turning_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stanok::process {
namespace {

constexpr double feed_differs = 0.1;

// The way over the last turn at the end of each cycle; ways out of the cut do not count.
std::vector<double> thicknesses(const CutRecord& record) {
  std::vector<double> turns{0.0};
  std::vector<double> ways{0.0};
  std::vector<double> all;
  std::size_t begin = 0;
  for (const CutRow& row : record.rows) {
    turns.push_back(turns.back() + row.rev_per_min / 60.0 * record.cycle_s);
    ways.push_back(ways.back() + (row.depth_mm > 0.0 ? row.travel_mm : 0.0));
    const double since = turns.back() - 1.0;
    while (begin + 2 < turns.size() && turns[begin + 1] <= since) ++begin;
    const double span = turns[begin + 1] - turns[begin];
    const double part = span > 0.0 ? std::clamp((since - turns[begin]) / span, 0.0, 1.0) : 0.0;
    all.push_back(
        std::max(0.0, ways.back() - (ways[begin] + part * (ways[begin + 1] - ways[begin]))));
  }
  return all;
}

// Of a force for unit depth, times depth and hardness, by row.
std::vector<double> watts_per_newton(const CutRecord& record) {
  constexpr double m_per_mm = 1e-3;
  std::vector<double> all;
  for (const CutRow& row : record.rows) {
    const double speed = 2.0 * std::numbers::pi * row.rev_per_min / 60.0 * row.radius_mm * m_per_mm;
    all.push_back(row.depth_mm * row.hardness_factor * speed);
  }
  return all;
}

DriveRecord drive_record_of_turning(const CutRecord& record,
                                    const std::vector<double>& per_newton) {
  DriveRecord drive{.cycle_s = record.cycle_s};
  for (std::size_t k = 0; k < record.rows.size(); ++k) {
    drive.rev_per_min.push_back(record.rows[k].rev_per_min);
    drive.power_w.push_back(record.rows[k].power_w);
    drive.cuts.push_back(per_newton[k] > 0.0);
    drive.z_mm.push_back(record.rows[k].z_mm);
  }
  return drive;
}

// Whether the readings of the cut have several feeds; without entries and exits, where the chip
// builds up.
bool has_feeds(const DriveRecord& drive, const std::vector<double>& thickness_mm) {
  std::vector<double> in_cut;
  for (const std::size_t row : reading_rows(drive))
    if (drive.cuts[row]) in_cut.push_back(thickness_mm[row]);
  std::ranges::sort(in_cut);
  const double least = in_cut[in_cut.size() / 10];
  const double most = in_cut[in_cut.size() * 9 / 10];
  return most >= (1.0 + feed_differs) * least;
}

// A newton of force of the edge by mm of depth, which the law does not have.
std::vector<double> edge_w(const std::vector<double>& per_newton,
                           const std::vector<double>& thickness_mm) {
  std::vector<double> all = per_newton;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!(thickness_mm[k] > 0.0)) all[k] = 0.0;
  return all;
}

// Of all metals that are turned.
FitVerdict check_figures(const TurningFit& fit) {
  constexpr double exponent_least = 0.3;
  constexpr double exponent_most = 1.2;
  constexpr double exponent_open = 0.1;
  constexpr double lag_most_s = 1.0;
  const double y = fit.exponent.value;
  if (y < exponent_least || y > exponent_most) {
    return verdict(FitState::refused, Misfit::bounds,
                   "the exponent y of the force is not between 0.3 and 1.2");
  }
  if (fit.idle_linear.high < 0.0)
    return verdict(FitState::refused, Misfit::bounds, "the idle power would be negative");
  if (fit.lag_s.value > lag_most_s)
    return verdict(FitState::refused, Misfit::bounds, "the power would come more than 1 s late");
  if (fit.exponent.half_width() > exponent_open) {
    return verdict(
        FitState::refused, Misfit::open,
        "the feeds of the cut differ too little, or for too short, to tell the exponent");
  }
  return {};
}

}  // namespace

Expected<TurningFit, std::string> fit_turning(const CutRecord& record) {
  const std::vector<double> thickness_mm = thicknesses(record);
  const std::vector<double> per_newton = watts_per_newton(record);
  const DriveRecord drive = drive_record_of_turning(record, per_newton);
  if (std::string lacks = what_lacks(drive); !lacks.empty())
    return Unexpected<std::string>(std::move(lacks));
  if (!has_feeds(drive, thickness_mm))
    return Unexpected<std::string>(
        "the cut has one feed only, which does not tell the exponent; change the feed");
  constexpr double usual_coefficient_n = 2000.0;
  constexpr double usual_exponent = 0.75;
  const CutModel cut{.begin = {std::log(usual_coefficient_n), usual_exponent},
                     .scale = {1.0, 1.0},
                     .power =
                         [&](const std::array<double, 2>& figures, std::vector<double>& watts) {
                           const double coefficient = std::exp(figures[0]);
                           for (std::size_t k = 0; k < watts.size(); ++k) {
                             if (per_newton[k] > 0.0)
                               watts[k] = coefficient * per_newton[k] *
                                          std::pow(thickness_mm[k], figures[1]);
                           }
                         },
                     .law_w = edge_w(per_newton, thickness_mm)};
  auto fitted = fit_drive(drive, cut);
  if (!fitted) return Unexpected<std::string>(std::move(fitted.error()));
  TurningFit turning{{std::move(fitted->drive)}, {}, fitted->figures[1]};
  const Estimate& ln = fitted->figures[0];
  turning.coefficient_n = {
      .value = std::exp(ln.value), .low = std::exp(ln.low), .high = std::exp(ln.high)};
  add_verdict(check_figures(turning), turning.verdict);
  return turning;
}

}  // namespace stanok::process
