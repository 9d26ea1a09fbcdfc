// Where a tool stands over the workpiece, from the readings of the machine's axes.
//
// Frames (docs/integrator/kinematics.md): B base of a kinematic scheme, K blank. A workpiece stays
// on the table or bed on which it was announced: it belongs to the base of the scheme that was
// active then, its *home*. When another scheme drives the machine, the way goes over the *upright
// point*: where X, Y and Z would read with the heads upright and no tool, the tip at the same
// place. All schemes of a channel share it, since they share the slides. Tools count with the
// length of the tool table, so that it does not matter which length, offset or point mode the
// program has chosen.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "kinematics/scheme.h"
#include "simulation/milling_cut.h"

namespace stanok::simulation {

using Axes = kinematics::AxisVector<double>;

// What a channel is made of, as far as its tools and workpiece stand on it.
struct ChannelGeometry {
  std::map<int, std::shared_ptr<const kinematics::Scheme>> schemes;
  // The spindle that turns the workpiece as an axis of the channel (C of a lathe); -1: none.
  int turning_axis = -1;
};

// Where the tool hangs on the spindle nose, mm: from the nose to the tip with the head upright.
struct ToolMount {
  Vector nose_to_tip = Vector::Zero();
  // Upright, from the tip towards the spindle: along the longest part of the way to the nose.
  [[nodiscard]] Vector axis() const;
};

class MachineGeometry {
 public:
  explicit MachineGeometry(ChannelGeometry geometry) : geometry_(std::move(geometry)) {}

  [[nodiscard]] bool has_scheme(int id) const { return geometry_.schemes.contains(id); }

  // The place of the tool in the base of `home`, which does not turn with the spindle of a lathe.
  [[nodiscard]] ToolPlace place_in(int home, int active, const Axes& axes_M,
                                   const ToolMount& mount) const;
  // The same point or direction in the base that turns with the workpiece.
  [[nodiscard]] ToolPlace turned_with_workpiece(int home, const Axes& axes_M,
                                                const ToolPlace& place_B) const;
  // The frame of upright points, in the base of `home` with the axes standing so.
  [[nodiscard]] Pose machine_in(int home, const Axes& axes_M) const;
  // The frame of points that ride on the linear axes and do not turn with the table
  // (PointMode::axes), likewise.
  [[nodiscard]] Pose linear_axes_in(int home, const Axes& axes_M) const;

 private:
  [[nodiscard]] const kinematics::Scheme& scheme(int id) const { return *geometry_.schemes.at(id); }

  ChannelGeometry geometry_;
};

}  // namespace stanok::simulation
