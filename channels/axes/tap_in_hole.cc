#include "channels/axes/tap_in_hole.h"

#include <cmath>

namespace stanok::channels {

using motion::TapOnPath;

bool TapInHole::follow(const motion::InterpolatorOutput& path, double rev_per_min) RT_SAFE {
  const bool was_on_path = is_on_path_;
  is_on_path_ = path.tap.place == TapOnPath::Place::in_hole;
  if (motion::ends_tap(path.spindle_order)) is_in_ = false;
  if (path.tap.place == TapOnPath::Place::before) stand_before(path, rev_per_min);
  if (is_on_path_) go_deeper(path);
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

void TapInHole::begin_way_out() RT_SAFE {
  is_on_way_out_ = true;
  code_ = {};
  text_ = {};
}

void TapInHole::end_way_out(const FixedText<8>& code, const ReasonText& text) RT_SAFE {
  is_on_way_out_ = false;
  if (code.view().empty()) is_in_ = false;
  code_ = code;
  text_ = text;
}

}  // namespace stanok::channels
