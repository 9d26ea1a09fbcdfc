// Rows of the command table: the scope, signals at the full cycle rate; and logs, what was.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double longest_s = 120.0;

constexpr Parameter signals =
    required_text("signals", "up to 8 names from scope.signals, separated by blanks or commas");

constexpr auto triggers =
    std::to_array<std::string_view>({"none", "level", "event", "block", "alarm"});

constexpr Parameter trigger{
    .name = "trigger",
    .type = ParameterType::choice,
    .choices = triggers,
    .help = "what the recording waits for; default none: it starts immediately"};

constexpr Parameter signal{
    .name = "signal",
    .minimum = 1,
    .maximum = 64,
    .help = "signal that is compared with the level; default: the first one"};

constexpr Parameter level{.name = "level",
                          .type = ParameterType::number,
                          .minimum = -1e9,
                          .maximum = 1e9,
                          .help = "value that the signal must cross, in its unit"};

constexpr auto edges = std::to_array<std::string_view>({"rising", "falling"});

constexpr Parameter edge{.name = "edge",
                         .type = ParameterType::choice,
                         .choices = edges,
                         .help = "direction of the crossing; default rising"};

constexpr Parameter event{.name = "event",
                          .minimum = 1,
                          .maximum = 8,
                          .help = "code of the event, such as E6010; default: any"};

constexpr Parameter begun_line{.name = "line",
                               .type = ParameterType::integer,
                               .minimum = 1,
                               .maximum = 4e9,
                               .help = "line of the block whose beginning is the trigger"};

constexpr Parameter before{
    .name = "before_s",
    .type = ParameterType::number,
    .unit = "s",
    .minimum = 0,
    .maximum = longest_s,
    .help = "time recorded before the trigger; default: a quarter of length_s"};

constexpr Parameter length{
    .name = "length_s",
    .type = ParameterType::number,
    .unit = "s",
    .minimum = 0.001,
    .maximum = longest_s,
    .help = "duration of the whole recording, at most 120,000 cycles; default 2"};

constexpr Parameter first{.name = "from",
                          .type = ParameterType::integer,
                          .minimum = 0,
                          .maximum = 1e9,
                          .help = "cycle of the recording at which the answer begins; default 0"};

constexpr std::array of_scope_start{signals, trigger,    signal,  level,  edge,
                                    event,   begun_line, channel, before, length};
constexpr std::array of_scope_read{first};

constexpr Parameter log_name = required_text("file", "name of a log, as history.logs lists it");

constexpr Parameter page_of_log{
    .name = "page",
    .type = ParameterType::integer,
    .minimum = 0,
    .maximum = 1e6,
    .help = "page of the path, from 0; default 0, which reads the log again"};

constexpr std::array of_log{log_name};
constexpr std::array of_logged_path{log_name, channel, page_of_log, system_of_path};

constexpr auto scope_rows = std::to_array<Method>({
    {.name = "scope.signals",
     .help =
         "list the signals of axes, channels and cycle that can be recorded, with units and limits",
     .result = R"({"signals":[{"name":"string","unit":"string","limit":"number?"}]})"},
    {.name = "scope.start",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_scope_start,
     .help =
         "record signals in every cycle, starting before a trigger; ends the previous recording",
     .result = R"({"id":"integer"})"},
    {.name = "scope.stop",
     .role = machine_operator,
     .effect = Effect::changes,
     .help = "end the recording; what has been recorded can be read"},
    {.name = "scope.read",
     .parameters = of_scope_read,
     .help = "read the recording, at most 4096 cycles at a time: Float32, little endian, in "
             "base64, one value of each signal, cycle by cycle",
     .result = R"({"id":"integer","state":"string","signals":[{"name":"string","unit":"string",
      "limit":"number?"}],"cycle_us":"integer","first_cycle":"integer","cycles":"integer",
      "trigger":"integer?","from":"integer","count":"integer","values":"string"})"},

    {.name = "history.logs",
     .help = "list the log files of the machine, newest first",
     .result = R"({"folder":"string","logs":[{"file":"string","bytes":"integer",
      "changed_s":"number","is_open":"boolean"}]})"},
    {.name = "history.verify",
     .course = Course::reads_program,
     .parameters = of_log,
     .help = "repeat the run of a log from its inputs and compare every setpoint; the verdict is "
             "same, part (the log is cut off, damaged or lacks inputs, but is the same as far as "
             "it goes), or differs",
     .result = R"({"file":"string","verdict":"string","cycles":"integer","setpoints":"integer",
      "difference":"any","lost_from_cycle":"integer?","remarks":["string"]})"},
    {.name = "history.path",
     .course = Course::reads_program,
     .parameters = of_logged_path,
     .help =
         "read the path of the tool tip of a channel from a log: pages of points with their times",
     .result = R"({"file":"string","channel":"integer","system":"string",
      "first_cycle":"integer","time_s":"number","left_out_s":"number","points":"integer",
      "pages":"integer","geometry":"any"})"},
});

}  // namespace

std::span<const Method> scope_methods() {
  return scope_rows;
}

}  // namespace stanok::protocol::rows
