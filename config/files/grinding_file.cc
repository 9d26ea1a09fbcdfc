// Keys and checks of the process file of a plunge grinding cycle.
#include "config/files/grinding_file.h"

#include <algorithm>
#include <cmath>

#include "config/text/flat_file.h"
#include "process/grinding/number_text.h"

namespace stanok::config {
namespace {

using process::allowance_max_mm;
using process::DesignRequest;
using process::feed_max_mm_per_s;
using process::FeedRange;
using process::GrindingProcess;
using process::PlungeOptions;
using process::ProcessQuantity;
using process::VerificationLimits;

struct GrindingFile {
  DesignRequest request;
  std::string removal = "triangle";
  double wear_factor = 0.0;
  double wear_exponent = 1.0;
  Subtables burn = nullptr;
};

// One of the sheet's quantities; its range comes from the table of process quantities, which the
// control file obeys too.
template <double GrindingProcess::* Member>
double& sheet(GrindingFile& file) {
  return file.request.process.*Member;
}

const Keys<GrindingFile>& grinding_keys() {
  using F = GrindingFile;
  using P = GrindingProcess;
  using R = DesignRequest;
  static const Keys<GrindingFile> keys = {
      {"part_radius", &sheet<&P::part_radius_mm>, required, "mm", "radius R of the finished part"},
      {"width", &sheet<&P::width_mm>, required, "mm", "width B of the ground surface"},
      {"wheel_radius", &sheet<&P::wheel_radius_mm>, required, "mm", "radius R_w of the wheel"},
      {"stiffness", &sheet<&P::stiffness_n_per_m>, required, "N/m",
       "stiffness C of machine, wheel and part in the direction of infeed"},
      {"mass", &sheet<&P::mass_kg>, required, "kg", "moving mass m, referred to the wheel"},
      {"damping", &sheet<&P::damping_n_s_per_m>, required, "N s/m", "viscous friction b"},
      {"part_speed", &sheet<&P::part_speed_rpm>, required, "rev/min", "speed n of the part"},
      {"force_factor", &sheet<&P::force_factor>, required, "N/mm",
       "C_p of the force law C_p B (Q V)^alpha"},
      {"force_exponent", &sheet<&P::force_exponent>, required, "", "alpha of the force law"},
      {"deflection_max", &sheet<&P::deflection_max_mm>, required, "mm",
       "permitted deflection of the elastic system"},
      {"critical_allowance", &sheet<&P::critical_allowance_mm>, required, "mm",
       "H_crit, the allowance from which the surface can burn"},
      {"removal_end", &sheet<&P::removal_end_mm2_per_rad>, required, "mm2/rad",
       "Q_end, permitted removal at finished size"},
      {"allowance", at<&F::request, &R::allowance_mm>, required, "mm",
       "allowance h to be removed per side", from(1e-9, allowance_max_mm)},
      {"removal_form", at<&F::removal>, optional, "",
       "Q of a layer a: triangle, a R R_w/(R + R_w), as in the paper; exact, a R",
       one_of({"triangle", "exact"})},
      {"feed_min", at<&F::request, &R::feeds, &FeedRange::min_mm_per_s>, optional, "mm/s",
       "smallest infeed", from(1e-9, feed_max_mm_per_s),
       "a tenth of the steady feed at removal_end"},
      {"feed_max", at<&F::request, &R::feeds, &FeedRange::max_mm_per_s>, optional, "mm/s",
       "largest infeed", from(1e-9, feed_max_mm_per_s),
       "1.3 times the steady feed at deflection_max"},
      {"spark_out", at<&F::request, &R::simulation, &PlungeOptions::spark_out_revolutions>,
       optional, "rev", "revolutions of the part after the last X", from(0.0, 1000.0),
       "0; with roundness_max, as many as it needs"},
      {"wear_factor", at<&F::wear_factor>, optional, "mm/s",
       "factor w of the wear of the wheel, w Q^p", from(0.0, 1.0)},
      {"wear_exponent", at<&F::wear_exponent>, optional, "", "exponent p of the wear of the wheel",
       from(0.0, 5.0)},
      {"burn_margin", at<&F::request, &R::limits, &VerificationLimits::burn_margin>, optional, "",
       "fraction by which the removal may exceed the burn line", from(0.0, 1.0)},
      {"residual_max", at<&F::request, &R::limits, &VerificationLimits::residual_max_mm>, optional,
       "mm", "allowance that may remain", from(0.0, 0.1)},
      {"undersize_max", at<&F::request, &R::limits, &VerificationLimits::undersize_max_mm>,
       optional, "mm", "how far the highest place may be below size", from(0.0, 0.1)},
      {"roundness_max", at<&F::request, &R::limits, &VerificationLimits::roundness_max_mm>,
       optional, "mm", "permitted out-of-roundness of the part at the end; 0: no limit",
       from(0.0, 0.1)},
      {"burn", at<&F::burn>, optional, "",
       "points of a curved burn line, between 0 and critical_allowance"},
      {"time_step", at<&F::request, &R::simulation, &PlungeOptions::time_step_max_s>, optional, "s",
       "largest step of the simulation", from(1e-6, 0.0005)},
      {"time_max", at<&F::request, &R::simulation, &PlungeOptions::time_max_s>, optional, "s",
       "longest permitted cycle; a longer one is refused", from(1.0, 3600.0)},
  };
  return keys;
}

const Keys<process::BurnPoint>& burn_keys() {
  using B = process::BurnPoint;
  static const Keys<B> keys = {
      {"allowance", at<&B::allowance_mm>, required, "mm", "remaining allowance per side",
       from(1e-6, allowance_max_mm)},
      {"removal", at<&B::removal_mm2_per_rad>, required, "mm2/rad",
       "permitted removal at this allowance", from(1e-5, 100.0)},
  };
  return keys;
}

std::vector<process::BurnPoint> read_burn_curve(Subtables tables, const Scope& scope) {
  std::vector<process::BurnPoint> curve;
  if (tables == nullptr) return curve;
  for (const toml::node& node : *tables) {
    process::BurnPoint point;
    read_table(*node.as_table(), burn_keys(), point, scope);
    curve.push_back(point);
  }
  return curve;
}

// Ranges of the quantities that the file has as numbers; what is absent or no number is a fault
// already.
void check_ranges(const toml::table& table, const GrindingProcess& process, const Scope& scope) {
  for (const process::ProcessFault& fault : process::range_faults(process)) {
    const toml::node* node = table.get(fault.key);
    if (node == nullptr || !node->is_number()) continue;
    if (!std::isfinite(node->value_or(0.0))) continue;
    scope.fault(node->source(), fault.text);
  }
}

void check_together(const toml::table& table, const DesignRequest& request, const Scope& scope) {
  for (const auto& fault : process::boundary_faults(request.process, request.allowance_mm)) {
    scope.fault(place_of(table, fault.key), fault.text);
  }
  const FeedRange& feeds = request.feeds;
  if (feeds.max_mm_per_s > 0.0 && feeds.min_mm_per_s >= feeds.max_mm_per_s) {
    scope.fault(place_of(table, "feed_min"), "feed_min is " + number_text(feeds.min_mm_per_s) +
                                                 "; it must be below feed_max, " +
                                                 number_text(feeds.max_mm_per_s) + " mm/s");
  }
}

}  // namespace

DesignRequest read_grinding_file(const std::filesystem::path& file) {
  GrindingFile content;
  DesignRequest& request = content.request;
  read_flat_file(
      file, grinding_keys(), "process", content, [&](const toml::table& table, const Scope& scope) {
        request.process.removal = content.removal == "exact" ? process::RemovalForm::exact
                                                             : process::RemovalForm::triangle;
        request.process.burn_curve = read_burn_curve(content.burn, scope.inner("[[burn]]"));
        check_ranges(table, request.process, scope);
        scope.faults.throw_if_any();
        check_together(table, request, scope);
        if (request.limits.roundness_max_mm > 0.0 && !table.contains("spark_out"))
          request.spark_out = process::SparkOut::found;
      });
  if (content.wear_factor > 0.0) {
    request.simulation.wear_rate_mm_per_s = [w = content.wear_factor,
                                             p = content.wear_exponent](double removal) {
      return removal > 0.0 ? w * std::pow(removal, p) : 0.0;
    };
  }
  return std::move(request);
}

std::vector<KeyRow> burn_key_rows() {
  return describe(burn_keys());
}

std::vector<KeyRow> grinding_key_rows() {
  std::vector<KeyRow> rows = describe(grinding_keys());
  for (const ProcessQuantity& quantity : process::process_quantities()) {
    const auto row = std::ranges::find(rows, quantity.key, &KeyRow::name);
    row->allowed = process::number_text(quantity.min) + " to " + process::number_text(quantity.max);
  }
  return rows;
}

}  // namespace stanok::config
