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

#include <Eigen/Geometry>
#include <algorithm>
#include <initializer_list>
#include <span>

#include "base/assert.h"
#include "kinematics/angle_units.h"
#include "kinematics/scheme_interface.h"

namespace stanok::kinematics {

// R v about the unit vector `k`. Components along coordinate axes keep their bits: about Z, v.z()
// is returned as it is. Vectors of numbers (the drawing) and of jets (the motion) mix freely.
template <class Scalar, class Component>
[[nodiscard]] Vector3<Scalar> turned(const Vector3<double>& k, const SineCosine<Scalar>& angle,
                                     const Vector3<Component>& v) RT_SAFE {
  const Component along = dot(k, v);
  const auto component = [&](double k_i, const Component& v_i, const Component& across) RT_SAFE {
    const Component parallel = k_i * along;
    return parallel + ((v_i - parallel) * angle.cosine + across * angle.sine);
  };
  const Vector3<Component> across = k.cross(v);
  return {component(k.x(), v.x(), across.x()), component(k.y(), v.y(), across.y()),
          component(k.z(), v.z(), across.z())};
}

struct RotaryJoint {
  AxisIndex axis;
  Vector3<double> vector{};  // unit vector; a positive angle turns right-handed about it
  Vector3<double> offset{};  // from a point on this axis to the next joint or the end, mm
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
    for (std::size_t i = 0; i < count_; ++i) bits |= joints_[i].axis.bit();
    return bits;
  }

  // Outer joint first.
  [[nodiscard]] std::span<const RotaryJoint> joints() const RT_SAFE {
    return std::span(joints_).first(count_);
  }

  template <class Scalar, class Component>
  [[nodiscard]] Vector3<Scalar> reach(const AxisVector<Scalar>& angles_deg,
                                      const Vector3<Component>& end) const RT_SAFE {
    if (count_ == 0) return end.template cast<Scalar>();
    const RotaryJoint& last = joints_[count_ - 1];
    Vector3<Scalar> v =
        turned(last.vector, angle(last, angles_deg), Vector3<Component>(last.offset + end));
    for (std::size_t i = count_ - 1; i-- > 0;) {
      const RotaryJoint& joint = joints_[i];
      v = turned(joint.vector, angle(joint, angles_deg), Vector3<Scalar>(joint.offset + v));
    }
    return v;
  }

  [[nodiscard]] Vector3<double> reach_back(const AxisVector<double>& angles_deg,
                                           Vector3<double> point) const RT_SAFE {
    for (std::size_t i = 0; i < count_; ++i) {
      const RotaryJoint& joint = joints_[i];
      const auto [sine, cosine] = angle(joint, angles_deg);
      point = turned(joint.vector, SineCosine<double>{-sine, cosine}, point);
      point -= joint.offset;
    }
    return point;
  }

  // A direction at the end of the chain as it lies outside of it, and back.
  [[nodiscard]] Vector3<double> direction(const AxisVector<double>& angles_deg,
                                          Vector3<double> at_end) const RT_SAFE {
    for (std::size_t i = count_; i-- > 0;) {
      at_end = turned(joints_[i].vector, angle(joints_[i], angles_deg), at_end);
    }
    return at_end;
  }
  [[nodiscard]] Vector3<double> direction_back(const AxisVector<double>& angles_deg,
                                               Vector3<double> outside) const RT_SAFE {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto [sine, cosine] = angle(joints_[i], angles_deg);
      outside = turned(joints_[i].vector, SineCosine<double>{-sine, cosine}, outside);
    }
    return outside;
  }

 private:
  template <class Scalar>
  [[nodiscard]] static SineCosine<Scalar> angle(const RotaryJoint& joint,
                                                const AxisVector<Scalar>& angles_deg) RT_SAFE {
    return sine_cosine(rad_per_deg * angles_deg[joint.axis]);
  }

  std::array<RotaryJoint, 2> joints_{};
  std::size_t count_ = 0;
};

}  // namespace stanok::kinematics
