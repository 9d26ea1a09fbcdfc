// The catalogue of all diagnostic and alarm codes: one row each, data only.
//
// E program errors, U user errors (terminate), W warnings, A machine alarms. `stanok explain`,
// docs/reference/alarms.md and the operator protocol are made from these rows (base/catalogue.cc).
// A code never changes its meaning.
#pragma once

#include <span>
#include <string_view>

namespace stanok {

// What the runtime does when the code is raised (docs/reference/alarms.md).
enum class Reaction {
  warning = 1,        // nothing stops
  program_end = 2,    // the program ends after the prepared blocks
  program_abort = 3,  // the program ends at once
  feed_hold = 4,      // feed hold of the channel
  axis_stop = 5,      // the faulty axis stops, the others hold
  all_axes_off = 6,   // all axes off
};

struct CatalogueRow {
  std::string_view code;
  std::string_view title;  // a short sentence, no parameters
  Reaction reaction = Reaction::warning;
  std::string_view remedy;  // what the reader should do
  std::string_view go_on;   // how to continue afterwards
};

[[nodiscard]] std::span<const CatalogueRow> catalogue();

// The row of a code, or nullptr.
[[nodiscard]] const CatalogueRow* find_in_catalogue(std::string_view code);

}  // namespace stanok
