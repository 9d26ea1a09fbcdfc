// Estimates of feed laws: time of a block, cycle of modulation, spacing and duration of
// interruptions; for planning, the runtime runs the stretches themselves.
//
// Closed forms are those of the paper named in feed_law.h, in its numbering. It integrates sums of
// n terms from 1 to n; corrected, the terms 0 to n - 1 are integrated from -1/2 to n - 1/2, which
// is the midpoint rule (docs/programmer/feed-laws.md compares them).
#pragma once

#include <cstdint>
#include <optional>

#include "motion/feed_laws/feed_law.h"

namespace stanok::motion {

// Times of a sum over increments, in s. No value: the form has none for these parameters.
struct TimeForms {
  double exact = 0.0;             // the sum itself
  std::optional<double> printed;  // as the paper has it
  std::optional<double> corrected;
};

// Stretches of |dl| at S_n + k q, k = 0 to n - 1, in mm/min, mm/min and mm; q is signed.
// Exact: 60 sum |dl| / (S_n + k q). Printed, from (1): |dl|/q ln((S_n + n q - q) / S_n). Corrected:
// |dl|/q ln((S_n + (n - 1/2) q) / (S_n - q/2)).
[[nodiscard]] TimeForms linear_time(double feed_first, double feed_step, double path_step_mm,
                                    std::uint64_t stretches);

// A whole cycle of the modulated law, 2 n_s stretches. Printed, (10):
// dl/dS ln(Smax (Smax - dS) / (Smin (Smin + dS))). Corrected: 2 dl/dS ln(Smax / Smin).
[[nodiscard]] TimeForms modulation_cycle_time(double feed_min, double feed_step,
                                              double path_step_mm, std::uint64_t steps);

// Increments of the linear law after a time in s: n = S_n (e^(q t / |dl|) - 1) / q, t in min. The
// inverse of the corrected sum but for half an increment; (1) to (3) count from 1.
[[nodiscard]] double linear_increments_after(double feed_first, double feed_step,
                                             double path_step_mm, double time_s);

// A part of a law's path, and what the law does not know itself.
struct LawPart {
  double from_mm = 0.0;
  double to_mm = 0.0;
  double feed_per_s = 0.0;   // programmed, where the law has none: mm/s
  double rev_per_min = 0.0;  // of the spindle, where the law has none; 0: not known
};

struct LawEstimate {
  std::uint64_t increments = 0;  // that have a path behind them
  double feed_first = 0.0;       // in the unit of the law; interrupted: mm/min
  double feed_last = 0.0;
  double time_s = 0.0;                     // the sum over the stretches
  std::optional<double> closed_form_s;     // corrected
  std::optional<TimeForms> cycle;          // of modulation
  std::optional<double> duration_rev;      // K_A = L_A / S_0: of an interruption
  std::optional<double> spacing_rev;       // K_B = L_B / S_0: from one to the next
  std::optional<double> modulation_depth;  // K_M = S_0min / S_0max
};

// No value: a feed per revolution while the speed of the spindle is not known.
[[nodiscard]] std::optional<LawEstimate> estimate(const FeedLaw& law, const LawPart& part);

}  // namespace stanok::motion
