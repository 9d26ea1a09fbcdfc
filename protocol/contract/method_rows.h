// What the files of the command table's rows (methods_of_*.cc) have in common.
//
// A row says all there is to say about a method of the operator: who reads the table makes of it
// the schema, the subcommand, completion, manual page, documents and the check of roles. The files
// are put together in method_table.cc, in the order of the documentation.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "protocol/contract/method_table.h"

namespace stanok::protocol::rows {

[[nodiscard]] std::span<const Method> machine_methods();
[[nodiscard]] std::span<const Method> program_text_methods();
[[nodiscard]] std::span<const Method> program_methods();
[[nodiscard]] std::span<const Method> queue_methods();
[[nodiscard]] std::span<const Method> axes_methods();
[[nodiscard]] std::span<const Method> tables_methods();
[[nodiscard]] std::span<const Method> hand_methods();
[[nodiscard]] std::span<const Method> process_methods();
[[nodiscard]] std::span<const Method> scope_methods();
[[nodiscard]] std::span<const Method> daemon_methods();

inline constexpr auto machine_operator = Role::machine_operator;
inline constexpr auto programmer = Role::programmer;
inline constexpr auto integrator = Role::integrator;

inline constexpr double text_bytes_max = 255.0;  // of an OperatorEvent

inline constexpr double channel_max = 999.0;

inline constexpr Parameter channel{.name = "channel",
                                   .type = ParameterType::integer,
                                   .carries = Carries::channel,
                                   .minimum = 1,
                                   .maximum = channel_max,
                                   .help = "channel; default: the first one"};

inline constexpr auto system_choices = std::to_array<std::string_view>({"work", "part"});

inline constexpr Parameter system_of_path{
    .name = "system",
    .type = ParameterType::choice,
    .choices = system_choices,
    .help =
        "coordinate system of the points: work, the workpiece system that is active at each point, "
        "or part, a system that is fixed to the part; default: work"};

constexpr Parameter required_text(std::string_view name, std::string_view help) {
  return {.name = name,
          .type = ParameterType::text,
          .presence = Presence::required,
          .spelling = Spelling::positional,
          .carries = Carries::text,
          .minimum = 1,
          .maximum = text_bytes_max,
          .help = help};
}

inline constexpr Parameter rate{.name = "rate_hz",
                                .type = ParameterType::number,
                                .unit = "Hz",
                                .minimum = 0.1,
                                .maximum = 50,
                                .help = "maximum number of status messages per second; default 10"};

inline constexpr auto wait_choices = std::to_array<std::string_view>({"accepted", "done"});

inline constexpr Parameter wait{
    .name = "wait",
    .type = ParameterType::choice,
    .choices = wait_choices,
    .help = "whether to answer when the request is accepted, or when the work is done"};

inline constexpr double velocity_limit = 100000.0;

inline constexpr Parameter on_or_off{.name = "on",
                                     .type = ParameterType::integer,
                                     .presence = Presence::required,
                                     .spelling = Spelling::positional,
                                     .carries = Carries::number,
                                     .minimum = 0,
                                     .maximum = 1,
                                     .help = "1: on; 0: off"};

// What gives words their meaning may change between a look and a command.
inline constexpr Parameter seen_situation{
    .name = "situation",
    .type = ParameterType::integer,
    .minimum = 1,
    .maximum = 2147483647.0,
    .help =
        "situation of the channel in the status that the request is based on; the request is "
        "refused if the situation has changed since"};
// Of what begins motion.
inline constexpr Parameter seen_cycle{
    .name = "seen_cycle",
    .type = ParameterType::integer,
    .minimum = 0,
    .maximum = 9007199254740991.0,
    .help =
        "cycle of the newest status that was seen; the request is refused if that is too long ago"};
inline constexpr std::array of_channel{channel};
inline constexpr std::array of_motion{channel, seen_cycle};

}  // namespace stanok::protocol::rows
