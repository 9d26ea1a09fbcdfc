// The topics of a cell: the one table from which the gateway publishes, and from which a test
// compares docs/integrator/cell.md.
//
// A topic is PREFIX/MACHINE/NAME for a state, PREFIX/MACHINE/event/NAME for an event,
// PREFIX/gateway for the gateway itself. A state is replaced by the next one, retained by the
// broker, and carries the number of its sending. An event is stored first, sent until the broker
// has it (QoS 1), never retained, and carries the number of the outbox.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "gateway/outbox/event_kinds.h"

namespace stanok::gateway {

enum class TopicKind : std::uint8_t { state, event };

struct Topic {
  std::string_view name;
  TopicKind kind;
  std::string_view sent;     // when
  std::string_view members;  // of its payload, besides source, seq and time
};

namespace topic {
inline constexpr std::string_view gateway = "gateway";
inline constexpr std::string_view state = "state";
inline constexpr std::string_view alarms = "alarms";
inline constexpr std::string_view program = "program";
inline constexpr std::string_view positions = "positions";
inline constexpr std::string_view parts = "parts";
inline constexpr std::string_view tools = "tools";
}  // namespace topic

inline constexpr std::array topics{
    Topic{topic::gateway, TopicKind::state, "by the broker as the last will; on connecting",
          "online"},
    Topic{topic::state, TopicKind::state, "when it changes",
          "connected, on, idle, channels: state, program_status, held_by"},
    Topic{topic::alarms, TopicKind::state, "when they change",
          "alarms: channel, code, text, file, line, reaction, remedy"},
    Topic{topic::program, TopicKind::state, "when it changes, at most at the rate",
          "channels: program, file, line, block, situation, g_codes, m_codes, work_offset, "
          "coolant, tool, spindles: id, direction, commanded_rev_min, remaining_s, override"},
    Topic{topic::positions, TopicKind::state, "when they change, at most at the rate",
          "channels: position, to_go, situation, units, diameter, feed_mm_min"},
    Topic{topic::parts, TopicKind::state, "when a run has ended",
          "programs: runs that ended without error since the outbox was created"},
    Topic{topic::tools, TopicKind::state, "when a run has ended",
          "tools: seconds in running programs since the outbox was created"},
    Topic{event::run_begun, TopicKind::event, "once", "channel, number, program, version"},
    Topic{event::run_ended, TopicKind::event, "once",
          "channel, number, program, version, begun_s, ended_s, time_s, path_mm, blocks, ok, end, "
          "parts"},
    Topic{event::alarm, TopicKind::event, "once",
          "channel, number, code, text, file, line, reaction"},
    Topic{event::tool_use, TopicKind::event, "once, with the end of a run", "tool, use_s, total_s"},
    Topic{event::measurement, TopicKind::event, "once", "channel, number, cycle, text"},
    Topic{event::lost, TopicKind::event, "once",
          "first, last: numbers that the outbox discarded; or channel, what, count: entries that "
          "the daemon had discarded"},
};

// "cell/mill3/state", "cell/mill3/event/alarm", "cell/gateway".
[[nodiscard]] std::string topic_of(std::string_view prefix, std::string_view machine,
                                   std::string_view state);
[[nodiscard]] std::string event_topic_of(std::string_view prefix, std::string_view machine,
                                         std::string_view kind);

// Whether it may be a level of a topic: not empty, without wildcards and slashes.
[[nodiscard]] bool is_level(std::string_view name);

}  // namespace stanok::gateway
