#include "jobs/cutting/identification.h"

#include <algorithm>
#include <stdexcept>

#include "jobs/cutting/found_figures.h"

namespace stanok::jobs {
namespace {

using process::CutRow;
using process::GrindRow;
using process::MillingRow;

template <class Fit>
Fit fit_or_throw(Expected<Fit, std::string> fit) {
  if (!fit) throw std::runtime_error(fit.error());
  return std::move(*fit);
}

// What identifications of all cuts have in common.
template <class Row, class Fit>
IdentifiedCut<Row> identified_cut(const std::vector<double>& time_s, const std::vector<Row>& rows,
                                  const Fit& fit) {
  IdentifiedCut<Row> found;
  found.noise = fit.noise;
  found.residual_w = fit.residual_w;
  found.verdict = fit.verdict;
  found.power = power_points(time_s, rows, fit.fitted_w);
  for (std::size_t k = 0; k < rows.size(); ++k)
    found.rows.push_back({time_s[k], rows[k], fit.fitted_w[k]});
  return found;
}

template <class Row>
IdlePower idle_power(const std::vector<Row>& rows, const process::DriveFit& fit) {
  double most = 0.0;
  for (const Row& row : rows) most = std::max(most, row.rev_per_min);
  return {.rev_per_min = most, .power_w = fit.idle_w(most), .coulomb_part = fit.coulomb_part(most)};
}

template <class Row>
Columns<FittedRow<Row>> row_columns(const Columns<FittedRow<Row>>& of_record) {
  using Fitted = FittedRow<Row>;
  Columns<Fitted> columns{
      {"time_s", 3, Together::first, [](const Fitted& fitted) { return fitted.time_s; }}};
  columns.insert(columns.end(), of_record.begin(), of_record.end());
  columns.push_back(
      {"power_w", 1, Together::peak, [](const Fitted& fitted) { return fitted.row.power_w; }});
  columns.push_back(
      {"fitted_w", 1, Together::peak, [](const Fitted& fitted) { return fitted.fitted_w; }});
  return columns;
}

}  // namespace

IdentifiedTurning identify(const LoggedTurning& request) {
  const CutLog log = read_cut_log(request.log, request.reading);
  const auto fit = fit_or_throw(process::fit_turning(log.record));
  IdentifiedTurning found = identified_cut(log.time_s, log.record.rows, fit);
  found.figures = figures_of(fit, request.coefficient_n);
  found.idle = idle_power(log.record.rows, fit);
  found.readings = fit.readings;
  found.text = process_section(fit, found.idle->rev_per_min, request.coefficient_n);
  return found;
}

IdentifiedMilling identify(const LoggedMilling& request) {
  const MillingLog log = read_milling_log(request.log, request.reading);
  const auto fit = fit_or_throw(process::fit_milling(log.record));
  IdentifiedMilling found = identified_cut(log.time_s, log.record.rows, fit);
  found.figures = figures_of(fit, request.efficiency);
  found.idle = idle_power(log.record.rows, fit);
  found.efficiency = request.efficiency;
  found.readings = fit.readings;
  found.text = with_figures(request.cut_text, cut_forces(fit, request.efficiency));
  return found;
}

IdentifiedPlunge identify(const LoggedPlunge& request) {
  const GrindLog log = read_grind_log(request.log, request.reading);
  const auto fit = fit_or_throw(process::fit_grinding(log.record, request.sheet));
  IdentifiedPlunge found = identified_cut(log.time_s, log.record.rows, fit);
  found.figures = figures_of(fit);
  found.readings = static_cast<int>(found.power.size());
  found.text = with_figures(request.process_text, fit);
  return found;
}

Fields fit_fields(const process::FitVerdict& verdict) {
  return {{"ok", !verdict.is_refused()},
          {"kind", text_field(process::name_of(verdict.kind))},
          {"reason", verdict.reason},
          {"remedy", verdict.remedy}};
}

Fields identification_fields(const Identification& found) {
  Fields fields;
  for (const Figure& figure : found.figures) {
    const process::Estimate& estimate = figure.estimate;
    fields.push_back(
        {std::string(figure.name),
         Fields{{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}}});
  }
  if (found.efficiency) fields.push_back({"efficiency", *found.efficiency});
  if (found.idle) fields.push_back({"idle_coulomb_part", found.idle->coulomb_part});
  fields.push_back({"noise", found.noise});
  fields.push_back({"residual_w", found.residual_w});
  fields.push_back({"readings", count_field(found.readings)});
  fields.push_back({"fit", fit_fields(found.verdict)});
  return fields;
}

const Columns<FittedRow<CutRow>>& turning_row_columns() {
  using Fitted = FittedRow<CutRow>;
  constexpr Together first = Together::first;
  static const Columns<Fitted> columns = row_columns<CutRow>({
      {"rev_per_min", 1, first, [](const Fitted& fitted) { return fitted.row.rev_per_min; }},
      {"radius_mm", 4, first, [](const Fitted& fitted) { return fitted.row.radius_mm; }},
      {"depth_mm", 4, Together::peak, [](const Fitted& fitted) { return fitted.row.depth_mm; }},
      {"travel_mm", 5, Together::peak, [](const Fitted& fitted) { return fitted.row.travel_mm; }},
  });
  return columns;
}

const Columns<FittedRow<MillingRow>>& milling_row_columns() {
  using Fitted = FittedRow<MillingRow>;
  constexpr Together peak = Together::peak;
  static const Columns<Fitted> columns = row_columns<MillingRow>({
      {"rev_per_min", 1, Together::first,
       [](const Fitted& fitted) { return fitted.row.rev_per_min; }},
      {"removal_mm3_per_s", 3, peak,
       [](const Fitted& fitted) { return fitted.row.removal_mm3_per_s; }},
      {"rubbing_mm2_per_s", 3, peak,
       [](const Fitted& fitted) { return fitted.row.rubbing_mm2_per_s; }},
  });
  return columns;
}

const Columns<FittedRow<GrindRow>>& plunge_row_columns() {
  using Fitted = FittedRow<GrindRow>;
  static const Columns<Fitted> columns = row_columns<GrindRow>({
      {"x_mm", 5, Together::first, [](const Fitted& fitted) { return fitted.row.x_mm; }},
  });
  return columns;
}

}  // namespace stanok::jobs
