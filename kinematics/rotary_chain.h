// A chain of rotary axes: where a vector stands that hangs at the end of it.
//
// Every joint turns about a unit vector k and carries an offset o, behind which the next joint or
// the end of the chain hangs. From the outer joint (nearest to the bed) to the end v:
//   reach(v)      = R1 (o1 + R2 (o2 + v))
//   reach_back(w) = R2^T (R1^T w - o1) - o2
// with Rodrigues' rotation R v = k (k.v) + cos(angle) (v - k (k.v)) + sin(angle) k x v. Unit vector
// and offset of a joint are given as they lie when all angles are 0. Lengths mm; angles deg, taken
// out of an axis vector by the index of the joint's axis. Written once over the scalar: double,
// Jet.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "base/assert.h"
#include "kinematics/angle_units.h"
#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

// Vectors of numbers (the drawing) and vectors of jets (the motion) mix freely; a sum with a jet in
// it is a jet.
template <class A, class B>
[[nodiscard]] auto sum(const Vector<A>& a, const Vector<B>& b) RT_SAFE {
  return Vector<decltype(a[0] + b[0])>{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// R v about the unit vector `k`. Components along coordinate axes keep their bits: about Z, v[2] is
// returned as it is.
template <class Scalar, class Component>
[[nodiscard]] Vector<Scalar> turned(const Vector<double>& k, const SineCosine<Scalar>& angle,
                                    const Vector<Component>& v) RT_SAFE {
  const Component along = k[0] * v[0] + k[1] * v[1] + k[2] * v[2];
  const Vector<Component> parallel{k[0] * along, k[1] * along, k[2] * along};
  const Vector<Component> across{k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2],
                                 k[0] * v[1] - k[1] * v[0]};
  Vector<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = parallel[i] + ((v[i] - parallel[i]) * angle.cosine + across[i] * angle.sine);
  }
  return result;
}

struct RotaryJoint {
  int axis = -1;            // index in the channel
  Vector<double> vector{};  // unit vector; a positive angle turns right-handed about it
  Vector<double> offset{};  // from a point on this axis to the next joint or the end, mm
};

class RotaryChain {
 public:
  // Outer joint first. Without joints the chain stands still and reach(v) = v.
  RotaryChain(std::initializer_list<RotaryJoint> joints) : count_(joints.size()) {
    STANOK_ASSERT(joints.size() <= joints_.size());
    std::ranges::copy(joints, joints_.begin());
  }

  // The axes of the joints, as bits.
  [[nodiscard]] unsigned axes() const RT_SAFE {
    unsigned bits = 0;
    for (std::size_t i = 0; i < count_; ++i) bits |= 1U << joints_[i].axis;
    return bits;
  }

  template <class Scalar, class Component>
  [[nodiscard]] Vector<Scalar> reach(const AxisVector<Scalar>& angles_deg,
                                     const Vector<Component>& end) const RT_SAFE {
    if (count_ == 0) return {Scalar(end[0]), Scalar(end[1]), Scalar(end[2])};
    const RotaryJoint& last = joints_[count_ - 1];
    Vector<Scalar> v = turned(last.vector, angle(last, angles_deg), sum(last.offset, end));
    for (std::size_t i = count_ - 1; i-- > 0;) {
      const RotaryJoint& joint = joints_[i];
      v = turned(joint.vector, angle(joint, angles_deg), sum(joint.offset, v));
    }
    return v;
  }

  [[nodiscard]] Vector<double> reach_back(const AxisVector<double>& angles_deg,
                                          Vector<double> point) const RT_SAFE {
    for (std::size_t i = 0; i < count_; ++i) {
      const RotaryJoint& joint = joints_[i];
      const auto [sine, cosine] = angle(joint, angles_deg);
      point = turned(joint.vector, SineCosine<double>{-sine, cosine}, point);
      for (std::size_t k = 0; k < 3; ++k) point[k] -= joint.offset[k];
    }
    return point;
  }

 private:
  template <class Scalar>
  [[nodiscard]] static SineCosine<Scalar> angle(const RotaryJoint& joint,
                                                const AxisVector<Scalar>& angles_deg) RT_SAFE {
    return sine_cosine(rad_per_deg * angles_deg[static_cast<std::size_t>(joint.axis)]);
  }

  std::array<RotaryJoint, 2> joints_{};
  std::size_t count_ = 0;
};

}  // namespace stanok::kinematics
