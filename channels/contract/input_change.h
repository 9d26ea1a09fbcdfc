// InputChange: what the cycle was given beside commands and digital signals, where it changes: how
// much prepared work it looked at, what drives and sensors told. There may be some in every cycle;
// without them no recorded run can be repeated. Plain data.
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "channels/contract/input_record.h"
#include "channels/contract/output.h"

namespace stanok::channels {

// Of an axis of the channel.
struct FeedbackInput {
  std::int32_t axis = 0;
  AxisFeedback value;
};

struct InputChange {
  std::int64_t cycle = 0;
  std::int32_t channel = 0;  // 0: the machine
  std::variant<Arrivals, FeedbackInput, AnalogInput, SpindleInput> content;
};
static_assert(std::is_trivially_copyable_v<InputChange>);

}  // namespace stanok::channels
