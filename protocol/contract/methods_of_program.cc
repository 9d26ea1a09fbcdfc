// Rows of the command table: programs and overrides.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr Parameter program = required_text("program", "program file under the program root");

constexpr Parameter search_target =
    required_text("target", "line (120) or block number (N40); in another file: sub.nc:120");

constexpr Parameter search_pass{.name = "pass",
                                .type = ParameterType::integer,
                                .carries = Carries::value,
                                .minimum = 1,
                                .maximum = 1e6,
                                .help = "pass of the loop that contains the block; default 1"};

constexpr auto calculations = std::to_array<std::string_view>({"with", "without"});

constexpr Parameter search_calculation{
    .name = "calculation",
    .type = ParameterType::choice,
    .carries = Carries::number,
    .choices = calculations,
    .help =
        "with (default): begin in the state that the preceding blocks would leave; without: begin "
        "in the default state"};

constexpr Parameter skip_level{.name = "level",
                               .type = ParameterType::integer,
                               .presence = Presence::required,
                               .spelling = Spelling::positional,
                               .carries = Carries::number,
                               .minimum = 1,
                               .maximum = 9,
                               .help = "level of block skip: 1 for /, 2 to 9 for /2 to /9"};

constexpr Parameter percent(double minimum, double maximum) {
  return {.name = "percent",
          .type = ParameterType::number,
          .presence = Presence::required,
          .spelling = Spelling::positional,
          .carries = Carries::fraction_of_percent,
          .unit = "%",
          .minimum = minimum,
          .maximum = maximum,
          .help = "percent of the programmed value"};
}

constexpr std::array of_program{program, channel, wait};
constexpr std::array of_run{program, channel, wait, seen_cycle};
constexpr Parameter approach{.name = "approach",
                             .type = ParameterType::integer,
                             .minimum = 1,
                             .maximum = 4294967295.0,
                             .help = "number of the approach from the answer to the block search"};
constexpr Parameter restore{.name = "restore",
                            .type = ParameterType::integer,
                            .spelling = Spelling::flag,
                            .minimum = 0,
                            .maximum = 1,
                            .help =
                                "1: at the height of the approach, change tool, spindle and "
                                "coolant to what the block needs"};

constexpr std::array of_start{channel, wait, approach, restore, seen_situation, seen_cycle};
constexpr std::array of_switch{on_or_off, channel};
constexpr std::array of_work{on_or_off, channel, seen_cycle};
constexpr Parameter return_velocity{
    .name = "velocity",
    .type = ParameterType::number,
    .carries = Carries::value,
    .unit = "mm/s, deg/s",
    .minimum = 0,
    .maximum = velocity_limit,
    .help =
        "velocity along the way back; default: that with which the slowest axis searches its "
        "home switch"};
constexpr std::array of_return{return_velocity, channel, seen_cycle};
constexpr auto retrace_directions = std::to_array<std::string_view>({"back", "forward"});
constexpr Parameter retrace_direction{
    .name = "direction",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::number,
    .choices = retrace_directions,
    .help = "back along what was passed, or forward as far as where the program is held"};
constexpr Parameter retrace_increment{
    .name = "increment",
    .type = ParameterType::number,
    .carries = Carries::value,
    .unit = "mm",
    .minimum = 0,
    .maximum = velocity_limit,
    .help = "way along the path; without it the axes move as long as the command is repeated"};
constexpr std::array of_retrace{retrace_direction, retrace_increment, channel, seen_cycle};
constexpr std::array of_skip{skip_level, channel};
constexpr std::array of_search{search_target, search_pass, search_calculation, channel};
constexpr std::array of_feed{percent(0, 200), channel, seen_cycle};
constexpr std::array of_rapid{percent(0, 100), channel, seen_cycle};
constexpr std::array of_spindle{percent(50, 150), channel};

constexpr auto program_rows = std::to_array<Method>({
    {.name = "program.load",
     .role = machine_operator,
     .effect = Effect::changes,
     .course = Course::reads_program,
     .action = "program_load",
     .parameters = of_program,
     .help = "load and compile a program; errors are reported with file, line and column"},
    {.name = "program.run",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .course = Course::reads_program,
     .action = "program_run",
     .parameters = of_run,
     .help = "load a program and start it",
     .result = R"("$end of run")"},
    {.name = "program.start",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "program_start",
     .parameters = of_start,
     .help = "start the loaded program, or continue it if it is held",
     .result = R"("$end of run")"},
    {.name = "program.hold",
     .role = machine_operator,
     .effect = Effect::stops,
     .reach = Reach::every_channel,
     .action = "program_hold",
     .parameters = of_channel,
     .help = "feed hold: stop along the path"},
    {.name = "program.resume",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "program_resume",
     .parameters = of_motion,
     .help = "continue after a feed hold"},
    {.name = "program.return",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .course = Course::moves_axes,
     .action = "program_return",
     .parameters = of_return,
     .help = "move the axes of a held program back to where it was held, the way that they came, "
             "jogged or along the path; first spindles and coolant are as the program left them"},
    {.name = "program.retrace",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .course = Course::repeats,
     .action = "program_retrace",
     .parameters = of_retrace,
     .help = "move the axes of a held program back along its path, or forward again, at the "
             "programmed feed under the overrides: by an increment, or for 200 ms at a time"},
    {.name = "program.spindles",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "spindle_switch",
     .parameters = of_work,
     .help = "stop the spindles of a held program, or let them turn again; they turn before the "
             "program continues"},
    {.name = "program.coolant",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "coolant_switch",
     .parameters = of_work,
     .help = "switch the coolant of a held program off, or on again; it is on before the program "
             "continues"},
    {.name = "program.stop",
     .role = machine_operator,
     .effect = Effect::stops,
     .reach = Reach::every_channel,
     .action = "program_stop",
     .parameters = of_channel,
     .help = "hold the feed, then end the program without an alarm"},
    {.name = "program.reset",
     .role = machine_operator,
     .effect = Effect::stops,
     .reach = Reach::every_channel,
     .action = "program_reset",
     .parameters = of_channel,
     .help = "end the program and clear the alarms of the channel"},
    {.name = "program.optional_stop",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "optional_stop",
     .parameters = of_switch,
     .help = "optional stop: set whether M1 stops the program"},
    {.name = "program.first_part",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "first_part",
     .parameters = of_work,
     .help = "first part: rapid traverse keeps to 25 %, whatever the rapid override is"},
    {.name = "program.step",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "single_block",
     .parameters = of_switch,
     .help = "single block: stop after each block; `program start` begins the next one"},
    {.name = "program.skip",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "block_skip",
     .parameters = of_skip,
     .help = "skip the blocks of a level from the next sync point on"},
    {.name = "program.unskip",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "block_skip_off",
     .parameters = of_skip,
     .help = "execute the blocks of a level again"},
    {.name = "program.list",
     .help = "list the program files under the program root, with the times (Unix) of their last "
             "change, and of the last check and run since the daemon started",
     .result = R"({"root":"string","programs":[{"name":"string","bytes":"integer",
      "changed_s":"number","checked_s":"number?","check_ok":"boolean?","ran_s":"number?",
      "run_ok":"boolean?"}],
      "complete":"boolean"})"},
    {.name = "program.history",
     .parameters = of_channel,
     .help = "list the newest 500 program runs of each channel, with their times and how they "
             "ended; cycles count from the last start of the daemon",
     .result = R"({"runs":[{"channel":"integer","number":"integer","program":"string",
      "begun_cycle":"integer?","ended_cycle":"integer?","begun_at":"number?","ended_at":"number?","end":"string?",
      "blocks":"integer","time_s":"number","path_mm":"number",
      "lost_periods":"integer","longest_gap_ms":"number","ended":"boolean","ok":"boolean"}],"forgotten?":"integer"})"},
    {.name = "program.search",
     .role = machine_operator,
     .effect = Effect::changes,
     .course = Course::reads_program,
     .action = "program_search",
     .parameters = of_search,
     .help = "block search: make the loaded program begin at this block when it is started; the "
             "answer shows what precedes the block",
     .result = R"({"target":"string","calculated":"boolean",
      "approach?":{"number":"integer","changes":["string"],
                   "moves":[{"kind":"string","to":"$numbers","length_mm":"number",
                             "feed_mm_min":"number?"}]}})"},

    {.name = "override.feed",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "override_feed",
     .parameters = of_feed,
     .help = "set the feed override of a channel"},
    {.name = "override.rapid",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "override_rapid",
     .parameters = of_rapid,
     .help = "set the rapid override of a channel"},
    {.name = "override.spindle",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "override_spindle",
     .parameters = of_spindle,
     .help = "set the spindle override of a channel"},
});

}  // namespace

std::span<const Method> program_methods() {
  return program_rows;
}

}  // namespace stanok::protocol::rows
