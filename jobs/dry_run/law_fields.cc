#include "jobs/dry_run/law_fields.h"

namespace stanok::jobs {
namespace {

void add_known(Fields& fields, const char* name, const std::optional<double>& value) {
  if (value) fields.push_back({name, *value});
}

}  // namespace

const char* law_name(const LawBlock& block) {
  switch (block.kind) {
    case motion::LawKind::none:
      break;
    case motion::LawKind::linear:
      if (block.units.speed == motion::LawSpeed::rev_per_min) return "spindle speed";
      return block.units.speed == motion::LawSpeed::m_per_min ? "cutting speed" : "linear";
    case motion::LawKind::modulated:
      return "modulated";
    case motion::LawKind::interrupted:
      return "interrupted";
    case motion::LawKind::curve:
      return "curve";
  }
  return "none";
}

const char* feed_unit(const LawBlock& block) {
  return block.units.per_revolution ? "mm/rev" : "mm/min";
}

std::optional<double> cycle_time_s(const motion::LawEstimate& estimate) {
  return estimate.cycle ? std::optional(estimate.cycle->exact) : std::nullopt;
}

Fields law_fields(const LawBlock& block) {
  const motion::LawEstimate& e = block.estimate;
  Fields fields{{"file", block.place.file},
                {"line", count_field(block.place.line)},
                {"law", law_name(block)},
                {"path_mm", block.path_mm},
                {"increments", count_field(e.increments)},
                {"feed_first", e.feed_first},
                {"feed_last", e.feed_last},
                {"feed_unit", feed_unit(block)},
                {"time_s", e.time_s},
                {"time_is_least", block.time_is_least}};
  add_known(fields, "closed_form_s", e.closed_form_s);
  add_known(fields, "cycle_s", cycle_time_s(e));
  if (e.cycle) add_known(fields, "cycle_closed_form_s", e.cycle->corrected);
  add_known(fields, "k_a", e.duration_rev);
  add_known(fields, "k_b", e.spacing_rev);
  add_known(fields, "k_m", e.modulation_depth);
  return fields;
}

}  // namespace stanok::jobs
