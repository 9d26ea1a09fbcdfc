// The infeed of a plunge cycle over the position of the wheel head, and the way along it in time.
//
// X is the allowance that a rigid machine would have left, mm per side: it begins at the whole
// allowance, where the wheel touches the part, and falls; below 0 lies the overrun that takes up
// the deflection of the elastic machine. The feed V(X), mm/s, is linear between two rows; two rows
// with one X are a jump. This is the table of the control file.
#pragma once

#include <cstddef>
#include <vector>

namespace stanok::process {

struct InfeedRow {
  double x_mm = 0.0;
  double feed_mm_per_s = 0.0;  // > 0

  bool operator==(const InfeedRow&) const = default;
};

// At least two rows; X never rises, feeds are above 0.
using InfeedLaw = std::vector<InfeedRow>;

// One feed from `begin_mm` down to `end_mm`.
[[nodiscard]] InfeedLaw constant_law(double begin_mm, double end_mm, double feed_mm_per_s);

// Time that the law takes from its first row to its last, s.
[[nodiscard]] double law_time_s(const InfeedLaw& law);

// Where a wheel head that follows a law is; the time steps need not fit its rows.
class InfeedTravel {
 public:
  enum class AtEnd { stands, goes_on };  // behind the last row, with its feed

  InfeedTravel(const InfeedLaw& law, AtEnd at_end);

  void advance(double time_s);
  [[nodiscard]] double x_mm() const { return x_mm_; }
  [[nodiscard]] double feed_mm_per_s() const;
  [[nodiscard]] const InfeedLaw& law() const { return law_; }
  [[nodiscard]] bool is_at_end() const { return segment_ + 1 >= law_.size(); }

 private:
  // Time from here to the end of the current segment, s.
  [[nodiscard]] double rest_s() const;
  [[nodiscard]] double slope_per_s() const;  // dV/dX

  const InfeedLaw& law_;
  AtEnd at_end_;
  std::size_t segment_ = 0;  // between row `segment_` and the next
  double x_mm_;
};

}  // namespace stanok::process
