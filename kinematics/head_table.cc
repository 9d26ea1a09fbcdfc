// Head-table scheme: the formulas of head_table.h, written once over the scalar (Jet or double).
// Symbols as there: p tip in B, X pivot in M, t pivot to tip, c0 table centre.
#include "kinematics/head_table.h"

#include <algorithm>
#include <numbers>

namespace stanok::kinematics {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;

template <class Scalar>
using Vector = std::array<Scalar, 3>;

// Ry(angle) * v.
template <class Scalar>
Vector<Scalar> turned_about_y(const SineCosine<Scalar>& angle, const Vector<double>& v) RT_SAFE {
  const auto& [s, c] = angle;
  return {v[0] * c + v[2] * s, Scalar(v[1]), v[2] * c - v[0] * s};
}

// Rz(angle) * v.
template <class Scalar>
Vector<Scalar> turned_about_z(const SineCosine<Scalar>& angle, const Vector<Scalar>& v) RT_SAFE {
  const auto& [s, c] = angle;
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

template <class Scalar>
SineCosine<Scalar> opposite(const SineCosine<Scalar>& angle) RT_SAFE {
  return {-angle.sine, angle.cosine};
}

}  // namespace

HeadTable::HeadTable(const SchemeConfig& config)
    : Scheme(config),
      shift_(config),
      head_(static_cast<std::size_t>(config.head_axis)),
      table_(static_cast<std::size_t>(config.table_axis)),
      pivot_to_spindle_(config.pivot_to_spindle),
      table_centre_(config.table_centre) {
  for (std::size_t k = 0; k < 3; ++k) linear_[k] = static_cast<std::size_t>(config.linear[k]);
}

std::array<double, 3> HeadTable::pivot_to_tip(const ToolVector& tool) const RT_SAFE {
  return {pivot_to_spindle_[0] + tool.nose_to_tip_mm[0],
          pivot_to_spindle_[1] + tool.nose_to_tip_mm[1],
          pivot_to_spindle_[2] + tool.nose_to_tip_mm[2]};
}

template <class Scalar>
void HeadTable::lead_tip(const ToolVector& tool, const AxisVector<Scalar>& point_B,
                         AxisVector<Scalar>& axes_M) const RT_SAFE {
  const SineCosine<Scalar> B = sine_cosine(rad_per_deg * point_B[head_]);
  const SineCosine<Scalar> C = sine_cosine(rad_per_deg * point_B[table_]);
  const Vector<Scalar> p{point_B[linear_[0]], point_B[linear_[1]], point_B[linear_[2]]};
  const Vector<Scalar> tip = turned_about_z(C, p);
  const Vector<Scalar> arm = turned_about_y(B, pivot_to_tip(tool));
  shift_.inverse(ToolVector{}, point_B, axes_M);  // rotary axes; the linear ones follow the tip
  for (std::size_t k = 0; k < 3; ++k) axes_M[linear_[k]] = tip[k] + (table_centre_[k] - arm[k]);
}

void HeadTable::inverse(PointMode mode, const ToolVector& tool, const AxisVector<Jet>& point_B,
                        AxisVector<Jet>& axes_M) const RT_SAFE {
  if (mode == PointMode::tip) {
    lead_tip(tool, point_B, axes_M);
  } else {
    shift_.inverse(tool, point_B, axes_M);
  }
}

void HeadTable::inverse(PointMode mode, const ToolVector& tool, const AxisVector<double>& point_B,
                        AxisVector<double>& axes_M) const RT_SAFE {
  if (mode == PointMode::tip) {
    lead_tip(tool, point_B, axes_M);
  } else {
    shift_.inverse(tool, point_B, axes_M);
  }
}

void HeadTable::forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
                        AxisVector<double>& point_B) const RT_SAFE {
  if (mode == PointMode::axes) {
    shift_.forward(tool, axes_M, point_B);
    return;
  }
  const Vector<double> X{axes_M[linear_[0]], axes_M[linear_[1]], axes_M[linear_[2]]};
  shift_.forward(ToolVector{}, axes_M, point_B);  // rotary axes
  const SineCosine<double> B = sine_cosine(rad_per_deg * point_B[head_]);
  const SineCosine<double> C = sine_cosine(rad_per_deg * point_B[table_]);
  const Vector<double> arm = turned_about_y(B, pivot_to_tip(tool));
  const Vector<double> from_centre{X[0] + arm[0] - table_centre_[0],
                                   X[1] + arm[1] - table_centre_[1],
                                   X[2] + arm[2] - table_centre_[2]};
  const Vector<double> p = turned_about_z(opposite(C), from_centre);
  for (std::size_t k = 0; k < 3; ++k) point_B[linear_[k]] = p[k];
}

std::string head_table_defect(const SchemeConfig& config) {
  const auto takes_part = [&](int axis) {
    return axis >= 0 && std::ranges::find(config.axes, axis) != config.axes.end();
  };
  if (!std::ranges::all_of(config.linear, takes_part)) return "X, Y and Z must take part";
  if (!takes_part(config.head_axis)) return "the head axis (about Y) must take part";
  if (!takes_part(config.table_axis)) return "the table axis (about Z) must take part";
  if (config.head_axis == config.table_axis) return "head axis and table axis must differ";
  return "";
}

}  // namespace stanok::kinematics
