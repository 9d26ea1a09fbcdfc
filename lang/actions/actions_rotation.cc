// Actions of the rotation of the coordinate system: G68 in the plane or about an axis, G69.
//
// Symbols: c the centre, in the system that work offset, G52 and G92 make; R the rotation. A point
// p_W of the turned system stands at c + R*(p_W - c) of that system. A new G68 replaces the one
// before; words left out of the centre mean the point where the axes stand.
#include <cmath>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

using Vector = std::array<double, 3>;

bool is_about_axis(const ActiveBlock& block) {
  return block.has('I') || block.has('J') || block.has('K');
}

// What the system is turned about; fails the block when it is no direction.
Vector axis_of(ActiveBlock& block) {
  Vector axis{};
  if (!is_about_axis(block)) {
    axis[plane_coordinates[block.modal.plane()].normal] = 1.0;
    return axis;
  }
  static constexpr std::array letters{'I', 'J', 'K'};
  for (std::size_t k = 0; k < 3; ++k)
    axis[k] = block.has(letters[k]) ? block.value(letters[k]) : 0.0;
  if (axis == Vector{}) {
    block.fail("E4305", {'G', g(68), {}}, "the axis of `G68` has no direction",
               "I, J and K are zero");
  }
  return axis;
}

// Every axis that turns must be there, and the centre lie among them.
bool check_axes(ActiveBlock& block) {
  const bool about_axis = is_about_axis(block);
  AxisSet turning = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!about_axis && k == plane_coordinates[block.modal.plane()].normal) continue;
    const AxisIndex axis = block.modal.geometry[k];
    if (!axis.exists()) {
      block.fail("E4306", {'G', g(68), {}},
                 std::string("`G68` turns ") + "XYZ"[k] + ", which the channel does not have", "");
      return false;
    }
    turning = static_cast<AxisSet>(turning | axis_bit(axis));
  }
  return only_axes(block, g(68), turning);
}

Vector centre_of(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  const ProgrammedRotation& before = modal.frames.rotation;
  Vector from_centre{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!modal.geometry[k].exists()) continue;
    from_centre[k] = modal.position_W[modal.geometry[k]] - before.centre[k];
  }
  Vector centre = components(before.rotation.turned(vector3(from_centre)));
  for (std::size_t k = 0; k < 3; ++k) {
    centre[k] += before.centre[k];
    const AxisIndex axis = modal.geometry[k];
    if (axis.exists() && is_programmed(block, axis)) {
      centre[k] = modal.map.to_work(axis, block.values[axis]);
    }
  }
  return centre;
}

void change_rotation(ActiveBlock& block, const ProgrammedRotation& rotation) {
  const WorkFrame before = block.modal.frame();
  block.modal.frames.rotation = rotation;
  publish_frame(block, before);
}

}  // namespace

void rotate_system(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::transformation})) {
    return;
  }
  if (!block.has('R')) {
    block.fail("E4007", {'G', code, {}}, "`G68` needs R, the angle", "no R");
    return;
  }
  const Vector axis = axis_of(block);
  if (block.failed() || !check_axes(block)) return;
  const double angle_deg = block.value('R');
  change_rotation(block,
                  {Rotation::about(vector3(axis), angle_deg), axis, angle_deg, centre_of(block)});
}

void cancel_rotation(ActiveBlock& block, CodeNumber code) {
  if (block.modal.code(Group::rotation) == code) return;
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  change_rotation(block, {});
}

}  // namespace stanok::lang
