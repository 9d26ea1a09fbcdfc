// What all kinematic schemes have in common: the map between programmed point and machine axes.
//
// A type of scheme derives from FormulaScheme (formula_scheme.h) and stands in the list of
// scheme_types.h; who uses schemes includes scheme.h. Frames: B base of the scheme (zero at the
// scheme's `zero`, turning with the table), M machine axes. Axis values stand in the order of the
// channel's axes, mm and deg.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "base/axis_index.h"
#include "base/rt_safe.h"
#include "base/vector3.h"
#include "kinematics/jet.h"
#include "kinematics/tool_direction.h"

namespace stanok::kinematics {

using stanok::axes_max;

template <class Scalar>
using AxisVector = AxisArray<Scalar>;

// Geometry of the tool as the transformation needs it: vector from the spindle nose to the tip when
// the head stands at 0, mm.
struct ToolVector {
  Vector3<double> nose_to_tip_mm{};
};

// Whether the programmed point is the tool tip led through the rotary axes (RTCP, G43.4) or rides
// on the linear axes (G43, G49).
enum class PointMode : unsigned char { axes, tip };

// Who asks for a scheme of a type: a scheme file, or the channel on a word of the program.
enum class ChosenBy : unsigned char { file, program };

struct SchemeConfig;  // scheme.h

// Immutable after construction; used by preparation and cycle at the same time.
class Scheme {
 public:
  virtual ~Scheme();
  [[nodiscard]] const SchemeConfig& config() const RT_SAFE { return *config_; }
  // Axes that take part, as bits.
  [[nodiscard]] unsigned participants() const RT_SAFE { return participants_; }
  // Whether axis `index` takes part; the others stand parked and are left as they are.
  [[nodiscard]] bool takes_part(int index) const RT_SAFE {
    return (participants_ >> index & 1U) != 0;
  }

  // M from B. Components of axes that do not take part pass through unchanged.
  virtual void inverse(PointMode mode, const ToolVector& tool, const AxisVector<Jet>& point_B,
                       AxisVector<Jet>& axes_M) const RT_SAFE = 0;
  virtual void inverse(PointMode mode, const ToolVector& tool, const AxisVector<double>& point_B,
                       AxisVector<double>& axes_M) const RT_SAFE = 0;
  // B from M.
  virtual void forward(PointMode mode, const ToolVector& tool, const AxisVector<double>& axes_M,
                       AxisVector<double>& point_B) const RT_SAFE = 0;

  // Whether lines of B stay lines of M, one parameter for all: second derivatives then come from
  // the path alone.
  [[nodiscard]] virtual bool is_affine(PointMode mode) const RT_SAFE {
    return mode == PointMode::axes;
  }
  // Axes whose position the inverse gives only up to whole turns of 360 deg: bit k for axis k. The
  // caller unwinds them.
  [[nodiscard]] virtual unsigned winding_axes() const RT_SAFE { return 0; }
  // Rotary axes that turn the tool, as bits.
  [[nodiscard]] virtual unsigned head_axes() const RT_SAFE { return 0; }
  // Rotary axes through which it leads the tip in PointMode::tip, as bits; 0: that mode is the same
  // as PointMode::axes.
  [[nodiscard]] virtual unsigned leading_axes() const RT_SAFE { return 0; }
  // How far the point is from where axes would have to jump, mm; infinite where they never do.
  [[nodiscard]] virtual double distance_to_singularity(const AxisVector<double>&) const RT_SAFE {
    return std::numeric_limits<double>::infinity();
  }

  // The positions of the rotary axes in which the tool points to `tool_B`, a unit vector from the
  // tip into the spindle.
  [[nodiscard]] virtual DirectionSolution directions(const Vector3<double>& tool_B) const RT_SAFE {
    static_cast<void>(tool_B);
    return {};
  }
  // X, Y and Z of the spindle as they lie in B: along the axes of B where no head and no table
  // turns. Z is the direction of the tool.
  [[nodiscard]] virtual std::array<Vector3<double>, 3> spindle_axes(
      const AxisVector<double>& point_B) const RT_SAFE;

  // What most types say; a type that says something else declares the same name.
  static constexpr ChosenBy chosen_by = ChosenBy::file;
  // The zero that follows from the geometry when a file gives none.
  [[nodiscard]] static AxisVector<double> zero_default(const SchemeConfig&) { return {}; }

 protected:
  explicit Scheme(const SchemeConfig& config);
  Scheme(const Scheme&) = delete;
  Scheme& operator=(const Scheme&) = delete;

 private:
  std::unique_ptr<const SchemeConfig> config_;
  unsigned participants_ = 0;
};

}  // namespace stanok::kinematics
