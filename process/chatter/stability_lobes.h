// StabilityLobes: the depth of cut up to which waves left in the surface do not grow, over the
// speed of the spindle.
//
// Zeroth-order solution: with the mean of the directional coefficients over a tooth period the
// border of stability is the set of real (speed, depth) at which
//   det(I + Lambda [A0] [G(i w)]) = 0,  1 - exp(-i w T) = z = -4 pi Lambda / (N K_t b)
// has a root: |z|^2 = 2 Re z gives the depth, its angle the speeds, one for each whole number of
// waves between two teeth. For turning it is exact (J. Tlusty 2000, ch. 9), for milling as good as
// the mean is (Altintas, Budak 1995); where a tooth cuts a small part of its turn,
// process/chatter/semi_discretisation.h is better.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "process/chatter/cutting_process.h"

namespace stanok::process {

// A point of the border of stability.
struct LobePoint {
  double speed_rev_per_min = 0.0;
  double depth_mm = 0.0;
  double chatter_hz = 0.0;
  int waves = 0;  // whole ones between two cuts: number of the lobe
};

class StabilityLobes {
 public:
  // `process` has at least one mode, and positive numbers where it needs them.
  explicit StabilityLobes(const CuttingProcess& process);

  // The least depth of cut that is not stable at a speed; nothing: every depth is stable.
  [[nodiscard]] std::optional<LobePoint> limit_at(double speed_rev_per_min) const;
  // Up to this depth every speed is stable; nothing: any depth.
  [[nodiscard]] std::optional<LobePoint> least_limit() const;

 private:
  // At one frequency: the depth, and the part of a wave between two cuts, 0 to 1.
  struct Border {
    double omega = 0.0;
    double depth_mm = 0.0;
    double part = 0.0;
  };
  // Borders of neighbouring frequencies that belong together.
  using Branch = std::vector<Border>;
  // z times the depth, for each root of the determinant; 0: there is no second one.
  using Roots = std::array<std::complex<double>, 2>;

  void add_branches();
  [[nodiscard]] Roots roots_at(double omega) const;
  [[nodiscard]] LobePoint point_of(const Border& border, int waves) const;

  CuttingProcess process_;
  std::vector<Branch> branches_;
};

}  // namespace stanok::process
