// Blocks under a feed law by their names, as `stanok check --estimate` and Python give them.
#pragma once

#include <optional>

#include "base/fields.h"
#include "jobs/dry_run/dry_sink.h"

namespace stanok::jobs {

// "linear", "cutting speed", ...
[[nodiscard]] const char* law_name(const LawBlock& block);
// "mm/min" or "mm/rev".
[[nodiscard]] const char* feed_unit(const LawBlock& block);
// Of one cycle of modulation; none: the law has no cycles.
[[nodiscard]] std::optional<double> cycle_time_s(const motion::LawEstimate& estimate);

// "file", "line", "law", "path_mm", "increments", "feed_first", "feed_last", "feed_unit", "time_s",
// "time_is_least", "closed_form_s", "cycle_s", "cycle_closed_form_s", "k_a", "k_b", "k_m"; without
// those that have no value.
[[nodiscard]] Fields law_fields(const LawBlock& block);

}  // namespace stanok::jobs
