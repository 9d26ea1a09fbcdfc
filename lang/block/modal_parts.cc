#include "lang/block/modal_parts.h"

#include <utility>

namespace stanok::lang {

void ModalFeed::put_under(FeedLaw given) {
  const bool was_set = is_set();
  known = was_set && !given.gives_feed();
  behind_law = was_set && given.gives_feed();
  law = std::move(given);
}

void ModalSpindles::start(std::uint16_t which) {
  running = static_cast<std::uint16_t>(running | which);
  any_runs = running != 0;
}

void ModalSpindles::stop(std::uint16_t which) {
  running = static_cast<std::uint16_t>(running & ~which);
  any_runs = running != 0;
}

Rotation FrameSettings::base_rotation() const {
  return set_up.is_on ? work_offset_rotation * set_up.rotation : work_offset_rotation;
}

WorkFrame FrameSettings::frame(const GeometryAxes& geometry) const {
  AxisValues shift = local_shift;
  for (std::size_t i = 0; axis_shift_active && i < shift.size(); ++i) shift[i] += axis_shift[i];
  const auto add = [&](const Vector3<double>& vector) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (geometry[k].exists()) shift[geometry[k]] += components(vector)[k];
    }
  };
  Vector3<double> within = vector3(plane.local_shift);
  if (!rotation.rotation.is_identity()) {
    const Vector3<double> centre = vector3(rotation.centre);
    within += centre - rotation.rotation.turned(centre);
  }
  if (plane.is_on) {
    add(vector3(plane.origin) + plane.rotation.turned(within));
  } else if (!rotation.rotation.is_identity()) {
    add(within);
  }
  const Rotation base = base_rotation();
  WorkFrame frame{turned(base, geometry, shift), base * plane.rotation * rotation.rotation,
                  geometry};
  if (set_up.is_on) {
    const auto moved = components(work_offset_rotation.turned(vector3(set_up.shift)));
    for (std::size_t k = 0; k < 3; ++k) {
      if (geometry[k].exists()) frame.offset[geometry[k]] += moved[k];
    }
  }
  for (std::size_t i = 0; i < shift.size(); ++i) frame.offset[i] += work_offset[i];
  return frame;
}

}  // namespace stanok::lang
