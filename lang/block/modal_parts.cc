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

WorkFrame FrameSettings::frame(const GeometryAxes& geometry) const {
  AxisValues shift = local_shift;
  for (std::size_t i = 0; axis_shift_active && i < shift.size(); ++i) shift[i] += axis_shift[i];
  const auto turned_centre = components(rotation.rotation.turned(vector3(rotation.centre)));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!geometry[k].exists() || rotation.rotation.is_identity()) continue;
    shift[geometry[k]] += rotation.centre[k] - turned_centre[k];
  }
  WorkFrame frame{turned(work_offset_rotation, geometry, shift),
                  work_offset_rotation * rotation.rotation, geometry};
  for (std::size_t i = 0; i < shift.size(); ++i) frame.offset[i] += work_offset[i];
  return frame;
}

}  // namespace stanok::lang
