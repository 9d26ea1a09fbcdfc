#include "channels/axes/tap_in_hole.h"

#include <algorithm>
#include <cmath>

namespace stanok::channels {

bool TapInHole::follow(const motion::InterpolatorOutput& path, double rev_per_min) RT_SAFE {
  const bool was_on_path = is_on_path_;
  is_on_path_ = path.tap.place == motion::TapOnPath::Place::in_hole;
  if (motion::ends_tap(path.spindle_order)) is_in_ = false;
  if (path.tap.place == motion::TapOnPath::Place::before) stand_before(path, rev_per_min);
  if (is_on_path_) go_deeper(path);
  is_near_ = is_near(path);
  return is_in_ && was_on_path && !is_on_path_;
}

void TapInHole::stand_before(const motion::InterpolatorOutput& path, double rev_per_min) RT_SAFE {
  is_in_ = is_on_way_out_ = false;
  depth_ = 0.0;
  tap_ = {.spindle = path.tap.spindle, .lead_mm = path.tap.lead_mm, .rev_per_min = rev_per_min};
  for (std::size_t k = 0; k < tap_.start_M.size(); ++k) tap_.start_M[k] = path.axes[k].value;
  tap_.deepest_M = tap_.start_M;
}

void TapInHole::go_deeper(const motion::InterpolatorOutput& path) RT_SAFE {
  is_in_ = true;
  double squared = 0.0;
  for (std::size_t k = 0; k < tap_.start_M.size(); ++k) {
    const double way = path.axes[k].value - tap_.start_M[k];
    squared += way * way;
  }
  if (squared <= depth_ * depth_) return;
  depth_ = std::sqrt(squared);
  for (std::size_t k = 0; k < tap_.deepest_M.size(); ++k) tap_.deepest_M[k] = path.axes[k].value;
}

// Within a lead of the box around its way: what can be taken out is judged by the preparation, in
// the frame where the way is straight.
bool TapInHole::is_near(const motion::InterpolatorOutput& path) const RT_SAFE {
  for (std::size_t k = 0; k < tap_.start_M.size(); ++k) {
    const auto [low, high] = std::minmax(tap_.start_M[k], tap_.deepest_M[k]);
    const double at = path.axes[k].value;
    if (at < low - tap_.lead_mm || at > high + tap_.lead_mm) return false;
  }
  return true;
}

void TapInHole::begin_way_out() RT_SAFE {
  is_on_way_out_ = true;
  code_ = {};
  text_ = {};
}

void TapInHole::end_way_out(const FixedText<8>& code, const ShortText& text) RT_SAFE {
  is_on_way_out_ = false;
  if (code.view().empty()) is_in_ = false;
  code_ = code;
  text_ = text;
}

}  // namespace stanok::channels
