// Rows of the command table: the machine as a whole and its channels.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr Parameter control{.name = "on",
                            .type = ParameterType::integer,
                            .spelling = Spelling::positional,
                            .minimum = 0,
                            .maximum = 1,
                            .help = "1 (default): take control; 0: release it"};

constexpr Parameter position_why{.name = "why",
                                 .type = ParameterType::integer,
                                 .spelling = Spelling::flag,
                                 .minimum = 0,
                                 .maximum = 1,
                                 .help =
                                     "1: also show everything between the machine position and "
                                     "each word: zero of the scheme, offsets, lengths, rotations"};

constexpr std::array of_power{seen_cycle};
constexpr std::array of_position{position_why, channel};
constexpr std::array of_control{control, channel};
constexpr std::array of_watch{channel, rate};

constexpr auto machine_rows = std::to_array<Method>({
    {.name = "machine.on",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "machine_on",
     .parameters = of_power,
     .help = "switch on the drives of all axes that are not parked"},
    {.name = "machine.off",
     .role = machine_operator,
     .effect = Effect::stops,
     .action = "machine_off",
     .help = "stop all channels and switch the drives off"},
    {.name = "machine.estop",
     .role = machine_operator,
     .effect = Effect::stops,
     .action = "machine_estop",
     .help = "STOP ALL (not the E-stop): stop immediately along the path, then switch the drives "
             "off; always accepted"},
    {.name = "machine.journal",
     .help = "list the commands of operators and the starts and ends of the daemon: the newest "
             "2000 entries, including those from before the last start",
     .result = R"({"records":[{"kind":"string","at":"number","session?":"integer","by?":"string",
      "method?":"string","parameters?":"any","outcome?":"string","text?":"string","version?":"string"}],
      "error":"string?"})"},
    {.name = "machine.status",
     .help = "show cycle, drives, real-time figures, and the state of every channel",
     .result = R"({"name":"string","cycle_us":"integer","cycle":"integer","age_ms":"integer",
      "machine_time_s":"number","on":"boolean","idle":"boolean","drives":"string",
      "rt":{"cycle_us":"$percentiles","latency_us":"$percentiles","overruns":"integer",
            "periods_skipped":"integer"},
      "real_time":{"scheduling":"string","memory_locked":"boolean","notes":["string"]},
      "outputs_lost":"integer","replies_lost":"integer","log_lines_lost":"integer",
      "channels":[{"id":"integer","name":"string","state":"string","program_status":"string"}]})"},

    {.name = "channel.list",
     .help = "list the channels with kind, axes, scheme and state",
     .result = R"({"channels":[{"id":"integer","name":"string","kind":"string",
      "axes":["string"],"words":["string"],"travel":["any"],"scheme":"integer",
      "state":"string",
      "program_status":"string"}]})"},
    {.name = "channel.status",
     .parameters = of_channel,
     .help = "show state, program, block, position, feed and overrides of a channel",
     .result = R"("$channel")"},
    {.name = "channel.position",
     .parameters = of_position,
     .help = "show the words that would lead to the present position of a channel, and how they "
             "are derived",
     .result = R"({"channel":"integer","situation":"integer","scheme":"integer",
      "units":"string","diameter":["string"],"position":"$numbers","point_W":"$numbers",
      "axes":[{"word":"string","axis":"string","unit":"string","machine":"number",
        "shown":"number","terms?":[{"term":"string","name":"string","of":"string","amount":"number",
          "value":"number","fixed":"boolean"}]}]})"},
    {.name = "channel.control",
     .role = machine_operator,
     .effect = Effect::changes,
     .course = Course::holds,
     .parameters = of_control,
     .help = "take sole control of a channel until the connection ends; others can still stop it",
     .result = R"({"channel":"integer","controlled_by":"string?"})"},
    {.name = "channel.watch",
     .course = Course::reports,
     .parameters = of_watch,
     .help = "show the status of a channel as it changes",
     .result = R"({"topics":["string"],"rate_hz":"number"})"},
});

}  // namespace

std::span<const Method> machine_methods() {
  return machine_rows;
}

}  // namespace stanok::protocol::rows
