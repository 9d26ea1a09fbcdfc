#include "channels/axes/retrace_by_hand.h"

#include <algorithm>
#include <cmath>

#include "channels/axes/manual_axis.h"

namespace stanok::channels {

std::string_view RetraceByHand::go(const RetraceOrder& order) RT_SAFE {
  constexpr double lag_s = 0.15;  // by which a wheel is followed
  const motion::RetraceWay way = way_of(order.direction);
  const bool is_lease = order.length == 0.0;
  if (is_moving() && is_lease != is_leased()) return "E6056";
  if (retrace_.is_stopping() && !is_lease) return "E6056";
  if (is_moving() && is_lease && way != retrace_.way()) {
    stop();
    return {};
  }
  if (retrace_.is_at_end(way)) return "E6102";
  cycles_left_ = is_lease ? std::llround(jog_lease_s / cycle_s_) : -1;
  if (!is_lease) {
    retrace_.go(way, order.length);
  } else if (!is_moving()) {
    retrace_.go(way);
  }
  if (order.surplus == RetraceOrder::Surplus::dropped)
    retrace_.keep_to(std::max(order.length, lag_s * retrace_.speed()));
  return {};
}

void RetraceByHand::return_to_path() RT_SAFE {
  if (is_moving()) return;
  cycles_left_ = -1;
  retrace_.go(motion::RetraceWay::forward);
}

void RetraceByHand::lead(const motion::FeedControl& control, motion::InterpolatorOutput& path)
    RT_SAFE {
  if (cycles_left_ >= 0 && cycles_left_-- == 0) stop();
  motion::RetraceOutput out;
  retrace_.advance(control, out);
  line_ = out.tag.line;
  if (is_back()) return;
  path.axes = out.axes;
  path.point = out.point;
  path.s_speed = out.s_speed;
}

RetraceState RetraceByHand::state(const motion::BlockTag* current) const RT_SAFE {
  RetraceState state;
  if (!history_.is_empty()) state.oldest_line = history_.line_at(history_.oldest());
  if (retrace_.is_on()) {
    state.blocks_back = retrace_.blocks_left();
    state.line = line_;
    return state;
  }
  state.blocks_back = history_.blocks_between(history_.oldest(), history_.newest());
  if (current == nullptr) return state;
  if (history_.is_empty()) state.oldest_line = current->line;
  if (history_.is_empty() || !history_.is_of_newest_block(*current)) ++state.blocks_back;
  return state;
}

}  // namespace stanok::channels
