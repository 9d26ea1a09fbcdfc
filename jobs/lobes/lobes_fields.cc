#include "jobs/lobes/lobes_fields.h"

#include <cmath>

namespace stanok::jobs {
namespace {

using process::LimitAt;
using process::PlannedCut;

FieldValue depth_field(double depth_mm) {
  return std::isfinite(depth_mm) ? FieldValue(depth_mm) : FieldValue();
}

FieldValue limit_fields(const LimitAt& limit) {
  Fields fields{{"speed_rev_per_min", limit.speed_rev_per_min},
                {"depth_mm", depth_field(limit.depth_mm)}};
  if (limit.chatter_hz > 0.0) fields.push_back({"chatter_hz", limit.chatter_hz});
  return fields;
}

FieldValue planned_fields(const PlannedCut& cut) {
  Fields fields{{"speed_rev_per_min", cut.speed_rev_per_min},
                {"depth_mm", cut.depth_mm},
                {"limit_mm", depth_field(cut.limit_mm)},
                {"stable", cut.is_stable()}};
  if (cut.better_speed > 0.0) fields.push_back({"better_speed_rev_per_min", cut.better_speed});
  return fields;
}

}  // namespace

const Columns<LimitAt>& lobes_columns() {
  static const Columns<LimitAt> columns{
      {"speed_rev_per_min", 1, Together::first,
       [](const LimitAt& limit) { return limit.speed_rev_per_min; }},
      {"depth_mm", 4, Together::first, [](const LimitAt& limit) { return limit.depth_mm; }},
      {"chatter_hz", 1, Together::first, [](const LimitAt& limit) { return limit.chatter_hz; }},
  };
  return columns;
}

Fields lobes_fields(const process::LobesStudy& study) {
  return {{"always_stable_mm", depth_field(study.always_mm)},
          {"best", field_list(study.best, limit_fields)},
          {"cuts", field_list(study.cuts, planned_fields)},
          {"limits", field_list(study.limits, limit_fields)}};
}

}  // namespace stanok::jobs
