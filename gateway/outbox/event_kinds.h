// Kinds of events: what may stand in an outbox, and the last level of its topic.
#pragma once

#include <string_view>

namespace stanok::gateway {

namespace event {
inline constexpr std::string_view run_begun = "run_begun";
inline constexpr std::string_view run_ended = "run_ended";
inline constexpr std::string_view alarm = "alarm";
inline constexpr std::string_view tool_use = "tool_use";
inline constexpr std::string_view measurement = "measurement";
inline constexpr std::string_view lost = "lost";
}  // namespace event

}  // namespace stanok::gateway
