// Jogs of the axes of a channel: what must hold before one begins. Real-time.
#pragma once

#include <string_view>

#include "base/rt_safe.h"
#include "channels/axes/manual_motion.h"
#include "channels/axes/retrace_by_hand.h"
#include "channels/contract/operator_command.h"

namespace stanok::channels {

class Channel;

// Both return why not: a code of the catalogue; empty: it goes.
[[nodiscard]] std::string_view jog(Channel& channel, const Jog& jog) RT_SAFE;
// As a handwheel was turned, by a way in mm or deg.
[[nodiscard]] std::string_view turn(Channel& channel, int axis, double way) RT_SAFE;
// Along the path that lies behind a held one, as RetraceByHand::go.
[[nodiscard]] std::string_view retrace(Channel& channel, const RetraceOrder& order) RT_SAFE;
// Along X, Y or Z (`coordinate` 0, 1, 2) of the tool or of the plane; the direction of `line` is
// found here.
[[nodiscard]] std::string_view jog(Channel& channel, JogFrame frame, int coordinate, JogLine line)
    RT_SAFE;

}  // namespace stanok::channels
