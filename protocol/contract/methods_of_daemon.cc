// Rows of the command table: records, sessions and the daemon itself.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr auto topic_choices =
    std::to_array<std::string_view>({"machine", "channels", "drives", "events"});

constexpr auto role_choices =
    std::to_array<std::string_view>({"observer", "operator", "programmer", "integrator"});

constexpr Parameter topics{.name = "topics",
                           .type = ParameterType::text_list,
                           .presence = Presence::required,
                           .spelling = Spelling::positional,
                           .maximum = topic_choices.size(),
                           .choices = topic_choices,
                           .help = "topics to subscribe to; an empty list ends the subscription"};

constexpr Parameter lower_role{
    .name = "role",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .choices = role_choices,
    .help = "highest role of the connection from now on; a connection cannot raise its role again"};

constexpr Parameter person{
    .name = "name",
    .minimum = 1,
    .maximum = 64,
    .help =
        "name of the person who works here, for the log and for others who see who controls a "
        "channel; once given, the name cannot be changed"};

constexpr std::array of_subscription{topics, rate};
constexpr std::array of_role{lower_role, person};

constexpr auto daemon_rows = std::to_array<Method>({
    {.name = "log.status",
     .help = "show file, bytes and losses of the recorder and the LCM publisher",
     .result = R"({"lcm":{"url":"string?","open":"boolean","sent":"integer","lost":"integer"},
      "file":{"path":"string?","bytes":"integer","events":"integer","error":"string?",
              "rests":"boolean"},
      "kept":{"files":"integer","bytes":"integer","bytes_max":"integer?","hours_max":"integer?",
              "free_bytes":"integer?","free_bytes_min":"integer?"},
      "flight":"string?","outputs_lost":"integer","inputs_lost":"integer"})"},
    {.name = "log.start",
     .role = machine_operator,
     .effect = Effect::changes,
     .help = "start a new log file",
     .result = R"({"path":"string"})"},
    {.name = "log.stop",
     .role = machine_operator,
     .effect = Effect::changes,
     .help = "close the log file",
     .result = R"({"path":"string"})"},

    {.name = "subscribe",
     .course = Course::reports,
     .parameters = of_subscription,
     .help = "send a snapshot of these topics, then their changes as notifications",
     .result = R"({"topics":["string"],"rate_hz":"number"})"},

    {.name = "session.role",
     .parameters = of_role,
     .help = "lower the role of this connection, and name the person who works there",
     .result = R"({"role":"string"})"},

    {.name = "system.info",
     .help = "show version, build, process, files and clients of the daemon",
     .result = R"({"server":"string","version":"string","api":"integer","build":"string",
      "pid":"integer","uptime_s":"number","history":"string?"})"},
    {.name = "system.shutdown",
     .role = integrator,
     .effect = Effect::changes,
     .help = "hold the feed, then switch the drives off, then end the daemon"},

    {.name = "rpc.discover",
     .help = "show this table of methods as an OpenRPC document",
     .result = R"({"openrpc":"string","info":{"title":"string","version":"string"},
      "methods":["any"]})"},
});

}  // namespace

std::span<const Method> daemon_methods() {
  return daemon_rows;
}

}  // namespace stanok::protocol::rows
