#include "channels/axes/way_aside.h"

#include <algorithm>

namespace stanok::channels {
namespace {

// The only axis that differs; none or several: -1.
int only_axis(const motion::Point& a, const motion::Point& b) RT_SAFE {
  int found = -1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == b[k]) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(k);
  }
  return found;
}

}  // namespace

void WayAside::begin(const motion::Point& axes_M) RT_SAFE {
  places_[0] = now_ = axes_M;
  count_ = 1;
  goes_back_ = false;
}

void WayAside::shift(const motion::Point& path_M, const motion::MotionConfig& config) RT_SAFE {
  motion::Point by{};
  for (std::size_t k = 0; k < by.size(); ++k) by[k] = path_M[k] - places_[0][k];
  for (std::size_t n = 1; n < count_; ++n) {
    for (std::size_t k = 0; k < by.size(); ++k) {
      const motion::AxisLimits& limits = config.axes[k];
      if (by[k] == 0.0) continue;
      places_[n][k] = std::clamp(places_[n][k] + by[k], limits.position_min, limits.position_max);
    }
  }
  places_[0] = path_M;
  if (now_ != last()) places_[count_++] = now_;
}

void WayAside::note_path(const motion::JetPoint& axes_M) RT_SAFE {
  for (std::size_t k = 0; k < now_.size(); ++k) places_[0][k] = axes_M[k].value;
}

void WayAside::follow(const motion::JetPoint& axes_M) RT_SAFE {
  for (std::size_t k = 0; k < now_.size(); ++k) now_[k] = axes_M[k].value;
}

void WayAside::place(motion::JetPoint& axes_M) const RT_SAFE {
  for (std::size_t k = 0; k < now_.size(); ++k) axes_M[k] = kinematics::Jet(now_[k]);
}

const motion::Point& WayAside::turn_back() RT_SAFE {
  goes_back_ = true;
  return places_[count_ - 2];
}

void WayAside::come_to_rest() RT_SAFE {
  const bool is_back = goes_back_ && now_ == places_[count_ - 2];
  const bool is_on_last_part = goes_back_ || goes_on_along_axis();
  goes_back_ = false;
  if (is_back) {
    --count_;
  } else if (is_on_last_part) {
    places_[count_ - 1] = now_;
  } else if (now_ != last() && !is_full()) {
    places_[count_++] = now_;
  }
}

// Both parts lie on one line that was passed: from where they end back to where they begin nothing
// else is met.
bool WayAside::goes_on_along_axis() const RT_SAFE {
  if (count_ < 2) return false;
  const int axis = only_axis(places_[count_ - 2], last());
  return axis >= 0 && axis == only_axis(last(), now_);
}

}  // namespace stanok::channels
