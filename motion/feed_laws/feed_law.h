// FeedLaw: how the feed, and with it perhaps the speed of the spindle, steps along the path.
//
// A law divides its own path, counted in mm from where it begins, into stretches of constant feed;
// at the end of each stands an *increment*. Stretches have closed forms, so that any increment lies
// exactly where the law says, whatever came before. The laws are those of I. A. Kashtalyan,
// V. K. Sheleg, B. Orukari, "Discrete control of cutting processes on NC lathes"
// (docs/programmer/feed-laws.md).
#pragma once

#include <cstdint>

#include "motion/path/path.h"

namespace stanok::motion {

inline constexpr double s_per_min = 60.0;

// Units of the values of a law.
struct LawUnits {
  bool per_revolution = false;  // feeds in mm/rev, else mm/min
  LawSpeed speed = LawSpeed::unchanged;
};

// The path between two increments.
struct LawStretch {
  double end_mm = unlimited;  // path of the law at which it ends
  double feed = 0.0;          // 0: that of the block
  double speed = 0.0;         // of the spindle; 0: unchanged
  double stand_mm = 0.0;      // length of the equivalent dwell path at its end: the axes rest
};

class FeedLaw {
 public:
  explicit FeedLaw(const LawUnits& units) : units_(units) {}
  virtual ~FeedLaw() = default;
  FeedLaw(const FeedLaw&) = delete;
  FeedLaw& operator=(const FeedLaw&) = delete;

  [[nodiscard]] virtual LawKind kind() const RT_SAFE = 0;
  // The stretch behind so many increments.
  [[nodiscard]] virtual LawStretch stretch(std::uint64_t increments) const RT_SAFE = 0;
  // Increments that lie at `path_mm` of the law's path or before.
  [[nodiscard]] virtual std::uint64_t increments_at(double path_mm) const RT_SAFE = 0;

  // The highest feed up to there; 0: that of the block.
  [[nodiscard]] virtual double highest_feed(double path_mm) const = 0;

  [[nodiscard]] const LawUnits& units() const RT_SAFE { return units_; }

 private:
  LawUnits units_;
};

// Lengths of path that differ by less are the same place: far below an increment of the machine,
// far above rounding.
inline constexpr double same_path_mm = 1e-7;

// How many whole steps lie within a length of path.
[[nodiscard]] std::uint64_t whole_steps(double path_mm, double step_mm) RT_SAFE;

}  // namespace stanok::motion
