// A tilted plane: a system of coordinates that lies anywhere in the workpiece system (G68.2 to
// G68.4), and the five ways to say how it lies.
//
// Every way ends in Euler angles: the plane is turned about Z by the first, about the new X by the
// second, about the new Z by the third (z-x'-z''). Z is its normal, which points to the tool.
// Lengths mm, angles deg, all in the workpiece system without the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/rotation.h"
#include "base/vector3.h"

namespace stanok::lang {

using EulerAngles = std::array<double, 3>;

[[nodiscard]] Rotation rotation_of(const EulerAngles& angles_deg);
// Of the plane with these axes X and Z, unit vectors square to each other. Where both Z agree, the
// first angle is 0.
[[nodiscard]] EulerAngles euler_angles(const Vector3<double>& x, const Vector3<double>& z);
[[nodiscard]] EulerAngles euler_angles(const Rotation& rotation);

// G68.2 P1: turns about X, Y and Z of the workpiece system, which stay where they are. `order` has
// the digits 1 to 3, the first turn first; nothing for another number.
[[nodiscard]] std::optional<EulerAngles> roll_pitch_yaw(const std::array<double, 3>& angles_deg,
                                                        int order);
// G68.2 P2: X points from the first point to the second, the third lies on the side of +Y. Nothing
// when they lie on a line.
[[nodiscard]] std::optional<EulerAngles> through_points(
    const std::array<Vector3<double>, 3>& points);
// G68.2 P3: X as the first vector, Z as the second. Nothing unless they are square to each other
// within `square_tolerance_deg`; Z is kept then, X goes along.
inline constexpr double square_tolerance_deg = 5.0;
[[nodiscard]] std::optional<EulerAngles> along_vectors(const Vector3<double>& x,
                                                       const Vector3<double>& z);
// G68.2 P4: the X axis turned about Y by the first angle and the Y axis turned about X by the
// second span the plane, whose X is the former; it is turned in itself by the third. Nothing when
// they span none.
[[nodiscard]] std::optional<EulerAngles> projected(const std::array<double, 3>& angles_deg);

// The plane turned in itself, about its normal.
[[nodiscard]] EulerAngles turned_in_itself(EulerAngles angles_deg, double by_deg);

// The plane that is in force. A value, part of the modal state.
struct TiltedPlane {
  bool is_on = false;
  bool is_aligned = false;  // G53.1 or G53.6 has turned the tool to it: the tool tip is led
  std::array<double, 3> origin{};
  EulerAngles angles_deg{};
  std::array<double, 3> local_shift{};  // G52, along the axes of the plane
  Rotation rotation;                    // of the angles

  void set(const std::array<double, 3>& at, const EulerAngles& angles);
  [[nodiscard]] bool operator==(const TiltedPlane&) const = default;
};

// What the blocks of a plane given by points or vectors have said so far.
struct PlaneDefinition {
  int form = 0;        // P; 0: none is under way
  unsigned parts = 0;  // bit k: the block with Q = k + 1
  std::array<std::array<double, 3>, 3> values{};
  std::array<double, 3> origin{};
  double turn_deg = 0.0;  // R

  [[nodiscard]] bool is_open() const { return form != 0; }
  [[nodiscard]] unsigned all_parts() const { return form == 2 ? 0b111U : 0b11U; }
};

}  // namespace stanok::lang
