// Strong types for physical quantities at the seams between folders.
//
// Written `300 * mm / minute`, read `feed / (mm / second)`; adding a speed to a distance does not
// compile. Inside: mm, s, deg. Kernels take plain doubles out with `quantity / unit` and carry the
// unit in the name.
#pragma once

#include <compare>

namespace stanok {

// A value of dimension length^L time^T angle^A, held in mm, s, deg.
template <int L, int T, int A>
class Quantity {
 public:
  constexpr Quantity() = default;
  constexpr explicit Quantity(double value) : value_(value) {}

  [[nodiscard]] constexpr double in_base_units() const { return value_; }

  constexpr auto operator<=>(const Quantity&) const = default;
  constexpr Quantity operator-() const { return Quantity(-value_); }
  constexpr Quantity operator+(Quantity other) const { return Quantity(value_ + other.value_); }
  constexpr Quantity operator-(Quantity other) const { return Quantity(value_ - other.value_); }
  constexpr Quantity operator*(double factor) const { return Quantity(value_ * factor); }
  constexpr Quantity operator/(double divisor) const { return Quantity(value_ / divisor); }
  friend constexpr Quantity operator*(double factor, Quantity q) { return q * factor; }

 private:
  double value_ = 0.0;
};

template <int L1, int T1, int A1, int L2, int T2, int A2>
constexpr auto operator*(Quantity<L1, T1, A1> a, Quantity<L2, T2, A2> b) {
  return Quantity<L1 + L2, T1 + T2, A1 + A2>(a.in_base_units() * b.in_base_units());
}

template <int L1, int T1, int A1, int L2, int T2, int A2>
constexpr auto operator/(Quantity<L1, T1, A1> a, Quantity<L2, T2, A2> b) {
  if constexpr (L1 == L2 && T1 == T2 && A1 == A2) {
    return a.in_base_units() / b.in_base_units();
  } else {
    return Quantity<L1 - L2, T1 - T2, A1 - A2>(a.in_base_units() / b.in_base_units());
  }
}

using Distance = Quantity<1, 0, 0>;
using Duration = Quantity<0, 1, 0>;
using Angle = Quantity<0, 0, 1>;
using Speed = Quantity<1, -1, 0>;
using Acceleration = Quantity<1, -2, 0>;
using Jerk = Quantity<1, -3, 0>;
using AngularSpeed = Quantity<0, -1, 1>;

inline constexpr Distance mm{1.0};
inline constexpr Distance inch{25.4};
inline constexpr Duration second{1.0};
inline constexpr Duration millisecond{1e-3};
inline constexpr Duration minute{60.0};
inline constexpr Angle degree{1.0};
inline constexpr Angle radian{57.295779513082320876798154814105};
inline constexpr Angle turn{360.0};

// For plain doubles that carry their unit in the name.
inline constexpr double full_turn_deg = 360.0;
inline constexpr double seconds_per_minute = 60.0;
inline constexpr double deg_per_s_of_rev_per_min = full_turn_deg / seconds_per_minute;

}  // namespace stanok
