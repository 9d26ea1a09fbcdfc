#include "channels/axes/scheme_table.h"

namespace stanok::channels {

SchemeTable::SchemeTable(const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes,
                         int active)
    : active_(active) {
  for (const auto& [id, made] : schemes) schemes_.at(count_++) = {id, made.get()};
}

const kinematics::Scheme* SchemeTable::find(int scheme) const RT_SAFE {
  for (std::size_t k = 0; k < count_; ++k) {
    if (schemes_[k].first == scheme) return schemes_[k].second;
  }
  return nullptr;
}

lang::AxisSet SchemeTable::participants() const RT_SAFE {
  const kinematics::Scheme* const scheme = active();
  return scheme == nullptr ? lang::AxisSet{0} : static_cast<lang::AxisSet>(scheme->participants());
}

lang::AxisSet SchemeTable::axes_of(int id) const RT_SAFE {
  const kinematics::Scheme* const scheme = find(id);
  if (scheme == nullptr) return 0;
  unsigned axes = scheme->participants();
  for (const kinematics::Parking& parking : scheme->config().parking) axes |= 1U << parking.axis;
  for (const auto& [axis, position] : scheme->config().retract) axes |= 1U << axis;
  return static_cast<lang::AxisSet>(axes);
}

bool SchemeTable::parks(int axis) const RT_SAFE {
  return active() != nullptr && (participants() >> axis & 1U) == 0;
}

}  // namespace stanok::channels
