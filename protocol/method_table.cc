#include "protocol/method_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stanok::protocol {
namespace {

// ---- parameters
// -------------------------------------------------------------------------------------------------

constexpr double text_bytes_max = 255.0;  // of an OperatorEvent
constexpr double channel_max = 999.0;

constexpr auto wait_choices = std::to_array<std::string_view>({"accepted", "done"});
constexpr auto topic_choices =
    std::to_array<std::string_view>({"machine", "channels", "drives", "events"});
constexpr auto role_choices = std::to_array<std::string_view>({"observer", "operator"});

constexpr Parameter channel{.name = "channel",
                            .type = ParameterType::integer,
                            .carries = Carries::channel,
                            .minimum = 1,
                            .maximum = channel_max,
                            .help = "channel; default: the first one"};
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
constexpr Parameter program = required_text("program", "program file beneath the program root");
constexpr Parameter line = required_text("text", "one complete statement");
constexpr Parameter wait{.name = "wait",
                         .type = ParameterType::choice,
                         .choices = wait_choices,
                         .help = "when the answer comes: request accepted, or work done"};
constexpr Parameter scheme{.name = "scheme",
                           .type = ParameterType::integer,
                           .presence = Presence::required,
                           .spelling = Spelling::positional,
                           .carries = Carries::number,
                           .minimum = 0,
                           .maximum = 9999,
                           .help = "kinematic scheme of the channel"};
constexpr Parameter topics{.name = "topics",
                           .type = ParameterType::text_list,
                           .presence = Presence::required,
                           .spelling = Spelling::positional,
                           .maximum = topic_choices.size(),
                           .choices = topic_choices,
                           .help = "what to be told of; an empty list ends the subscription"};
constexpr Parameter rate{.name = "rate_hz",
                         .type = ParameterType::number,
                         .unit = "Hz",
                         .minimum = 0.1,
                         .maximum = 50,
                         .help = "most status messages per second; default 10"};
constexpr Parameter lower_role{.name = "role",
                               .type = ParameterType::choice,
                               .presence = Presence::required,
                               .spelling = Spelling::positional,
                               .choices = role_choices,
                               .help = "role to go down to; there is no way back up"};

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

constexpr Parameter skip_level{.name = "level",
                               .type = ParameterType::integer,
                               .presence = Presence::required,
                               .spelling = Spelling::positional,
                               .carries = Carries::number,
                               .minimum = 1,
                               .maximum = 9,
                               .help = "level of block skip: 1 for /, 2 to 9 for /2 to /9"};
constexpr Parameter on_or_off{.name = "on",
                              .type = ParameterType::integer,
                              .presence = Presence::required,
                              .spelling = Spelling::positional,
                              .carries = Carries::number,
                              .minimum = 0,
                              .maximum = 1,
                              .help = "1 on, 0 off"};

constexpr auto fault_choices = std::to_array<std::string_view>(
    {"none", "off", "stuck", "garbage", "slow", "intermittent", "trip", "elsewhere", "mangled",
     "hang_up", "jammed", "frozen"});
constexpr Parameter drive =
    required_text("drive", "name of the axis; S and its number for a spindle");
constexpr Parameter drive_fault{.name = "fault",
                                .type = ParameterType::choice,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .choices = fault_choices,
                                .help = "what it does from now on"};

constexpr std::array of_drive{drive};
constexpr std::array of_drive_fault{drive, drive_fault};

constexpr double interruption_mm_max = 10000.0;
constexpr Parameter fictitious_path{.name = "la",
                                    .type = ParameterType::number,
                                    .presence = Presence::required,
                                    .carries = Carries::value,
                                    .unit = "mm",
                                    .minimum = 0,
                                    .maximum = interruption_mm_max,
                                    .help =
                                        "fictitious path L_A along which the axes rest; 0 ends "
                                        "the interruption"};
constexpr Parameter real_path{.name = "lb",
                              .type = ParameterType::number,
                              .carries = Carries::value_2,
                              .unit = "mm",
                              .minimum = 0,
                              .maximum = interruption_mm_max,
                              .help = "path at feed L_B from one rest to the next"};

constexpr auto automatic_laws = std::to_array<std::string_view>({"modulated", "linear"});
constexpr Parameter automatic_law{
    .name = "law",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::text,
    .choices = automatic_laws,
    .help = "modulated: acts on the vibration; linear: on the power of the spindle"};

constexpr Parameter allowance{.name = "on",
                              .type = ParameterType::integer,
                              .spelling = Spelling::positional,
                              .minimum = 0,
                              .maximum = 1,
                              .help = "1 allow, the default; 0 no more"};
constexpr std::array of_allowance{allowance};
constexpr Parameter control{.name = "on",
                            .type = ParameterType::integer,
                            .spelling = Spelling::positional,
                            .minimum = 0,
                            .maximum = 1,
                            .help = "1 take it, the default; 0 give it back"};
constexpr std::array of_control{control, channel};

constexpr std::array of_automatic_law{automatic_law, on_or_off, channel};
// Their places are channels::ForceAction.
constexpr auto force_actions = std::to_array<std::string_view>({"off", "on", "set"});
constexpr Parameter force_action{
    .name = "action",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::number,
    .choices = force_actions,
    .help = "on: with the force given, or ordered last; set: change one value"};
constexpr auto force_quantities =
    std::to_array<std::string_view>({"force", "level", "mass", "frequency"});
constexpr Parameter force_quantity{
    .name = "quantity",
    .type = ParameterType::choice,
    .spelling = Spelling::positional,
    .carries = Carries::text,
    .choices = force_quantities,
    .help =
        "cutting force P_z; permissible vibration; reduced mass and frequency of the "
        "oscillation that is formed from the vibration"};
constexpr double force_value_max = 1e6;
constexpr Parameter force_value{.name = "value",
                                .type = ParameterType::number,
                                .spelling = Spelling::positional,
                                .carries = Carries::value,
                                .unit = "N, um, kg, Hz",
                                .minimum = 0,
                                .maximum = force_value_max,
                                .help = "of the quantity; above 0"};
constexpr std::array of_force_control{force_action, force_quantity, force_value, channel};
constexpr Parameter jogged_axis =
    required_text("axis", "axis of the machine, as in the machine file");
constexpr double velocity_limit = 100000.0;
constexpr Parameter jog_velocity{.name = "velocity",
                                 .type = ParameterType::number,
                                 .presence = Presence::required,
                                 .carries = Carries::value,
                                 .unit = "mm/s, deg/s",
                                 .minimum = -velocity_limit,
                                 .maximum = velocity_limit,
                                 .help = "its sign is the direction"};
constexpr Parameter jog_increment{.name = "increment",
                                  .type = ParameterType::number,
                                  .carries = Carries::value_2,
                                  .unit = "mm, deg",
                                  .minimum = 0,
                                  .maximum = velocity_limit,
                                  .help = "way to go; without it as long as the jog is renewed"};
constexpr Parameter homed_axis{.name = "axis",
                               .type = ParameterType::text,
                               .carries = Carries::text,
                               .minimum = 1,
                               .maximum = text_bytes_max,
                               .help = "one axis only; default: all of the channel"};

constexpr Parameter tool_number{.name = "number",
                                .type = ParameterType::integer,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::number,
                                .minimum = 0,
                                .maximum = 32000,
                                .help = "number of the tool"};
constexpr auto tool_value_choices = std::to_array<std::string_view>(
    {"length", "length_x", "length_y", "radius", "wear_length", "wear_radius", "overhang",
     "orientation", "angle_front", "angle_back"});
constexpr Parameter tool_value{.name = "key",
                               .type = ParameterType::choice,
                               .presence = Presence::required,
                               .spelling = Spelling::positional,
                               .carries = Carries::text,
                               .choices = tool_value_choices,
                               .help = "which value of it"};
constexpr Parameter table_value{.name = "value",
                                .type = ParameterType::number,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::value,
                                .unit = "mm, deg",
                                .minimum = -velocity_limit,
                                .maximum = velocity_limit,
                                .help = "its new value"};
constexpr Parameter tool_edge{.name = "edge",
                              .type = ParameterType::integer,
                              .carries = Carries::value_2,
                              .minimum = 1,
                              .maximum = 99,
                              .help = "edge of the tool; default 1"};
constexpr Parameter offset_name =
    required_text("offset", "work offset: G54 to G59, G59.1 to G59.3, \"G54.1 P1\"");
constexpr Parameter offset_axis{.name = "axis",
                                .type = ParameterType::text,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::more_text,
                                .minimum = 1,
                                .maximum = 16,
                                .help = "axis of the machine; R: rotation"};

constexpr Parameter search_target =
    required_text("target", "line, 120, or block number, N40; of another file: sub.nc:120");
constexpr Parameter search_pass{.name = "pass",
                                .type = ParameterType::integer,
                                .carries = Carries::value,
                                .minimum = 1,
                                .maximum = 1e6,
                                .help = "in a loop, the how-manieth time; default 1"};
constexpr auto calculations = std::to_array<std::string_view>({"with", "without"});
constexpr Parameter search_calculation{
    .name = "calculation",
    .type = ParameterType::choice,
    .carries = Carries::number,
    .choices = calculations,
    .help =
        "with (default): in the state that the blocks before leave behind; without: in the "
        "default state"};

constexpr double table_bytes_max = 1e6;
constexpr Parameter tables_text{.name = "tables",
                                .type = ParameterType::text,
                                .presence = Presence::required,
                                .spelling = Spelling::file,
                                .minimum = 1,
                                .maximum = table_bytes_max,
                                .help = "tools and work offsets, as in a tables file"};
constexpr Parameter tables_name{.name = "file",
                                .type = ParameterType::text,
                                .minimum = 1,
                                .maximum = 4096,
                                .help = "name of the text in messages; default: that of the file"};
constexpr std::array of_tables{tables_text, tables_name};
constexpr std::array of_search{search_target, search_pass, search_calculation, channel};
constexpr std::array of_tool{tool_number, tool_edge};
constexpr std::array of_tool_value{tool_number, tool_value, table_value, tool_edge};
constexpr std::array of_offset_value{offset_name, offset_axis, table_value};
constexpr std::array of_jog{jogged_axis, jog_velocity, jog_increment, channel};
constexpr std::array of_home{homed_axis, channel};
constexpr std::array of_interruption{fictitious_path, real_path, channel};
constexpr std::array of_skip{skip_level, channel};
constexpr std::array of_switch{on_or_off, channel};
constexpr std::array of_channel{channel};
constexpr std::array of_program{program, channel, wait};
constexpr std::array of_line{line, channel, wait};
constexpr std::array of_start{channel, wait};
constexpr std::array of_feed{percent(0, 200), channel};
constexpr std::array of_rapid{percent(0, 100), channel};
constexpr std::array of_spindle{percent(50, 150), channel};
constexpr std::array of_scheme{scheme, channel};
constexpr std::array of_subscription{topics, rate};
constexpr std::array of_watch{channel, rate};
constexpr std::array of_role{lower_role};

// ---- rows
// -------------------------------------------------------------------------------------------------------

constexpr auto observer = Role::observer;
constexpr auto machine_operator = Role::machine_operator;
constexpr auto integrator = Role::integrator;

constexpr auto table = std::to_array<Method>({
    {"machine.on",
     machine_operator,
     "switch on the drives of the axes that take part",
     {},
     "machine_on"},
    {"machine.off",
     machine_operator,
     "stop all channels and switch the drives off",
     {},
     "machine_off"},
    {"machine.estop",
     machine_operator,
     "stop along the path at once, then drives off; always accepted",
     {},
     "machine_estop"},
    {"machine.status", observer, "cycle, drives, real-time figures, state of every channel"},

    {"channel.list", observer, "channels with kind, axes, scheme and state"},
    {"channel.status", observer, "state, program, block, position, feed and overrides of a channel",
     of_channel},
    {"channel.control", machine_operator,
     "have a channel to oneself until the connection ends; stops are never refused to others",
     of_control},
    {"channel.watch", observer, "status of a channel as it changes", of_watch},

    {"program.load", machine_operator, "compile a program; errors come with file, line and column",
     of_program, "program_load"},
    {"program.run", machine_operator, "load a program and start it", of_program, "program_run"},
    {"program.start", machine_operator, "start the loaded program; go on when held", of_start,
     "program_start"},
    {"program.hold", machine_operator, "feed hold along the path", of_channel, "program_hold"},
    {"program.resume", machine_operator, "go on after a hold", of_channel, "program_resume"},
    {"program.stop", machine_operator, "hold, then end the program without an alarm", of_channel,
     "program_stop"},
    {"program.reset", machine_operator, "end the program and clear the channel's alarms",
     of_channel, "program_reset"},
    {"program.optional_stop", machine_operator, "whether M1 stops the program", of_switch,
     "optional_stop"},
    {"program.step", machine_operator,
     "single block: stop after each block; program start lets the next one begin", of_switch,
     "single_block"},
    {"program.skip", machine_operator, "skip the blocks of a level from the next sync point on",
     of_skip, "block_skip"},
    {"program.unskip", machine_operator, "execute the blocks of a level again", of_skip,
     "block_skip_off"},
    {"program.list", observer, "program files beneath the program root"},
    {"program.history", observer, "program runs since the daemon started, with blocks and times",
     of_channel},
    {"program.search", machine_operator,
     "where the loaded program begins when it is started; tells what lies before that block",
     of_search, "program_search"},

    {"override.feed", machine_operator, "feed override of a channel", of_feed, "override_feed"},
    {"override.rapid", machine_operator, "rapid override of a channel", of_rapid, "override_rapid"},
    {"override.spindle", machine_operator, "spindle override of a channel", of_spindle,
     "override_spindle"},

    {"kinematics.list", observer, "kinematic schemes of a channel", of_channel},
    {"kinematics.select", machine_operator,
     "switch the channel to another scheme; the channel must be idle", of_scheme,
     "kinematics_select"},
    {"kinematics.status", observer, "active scheme, its axes, their drives and brakes", of_channel},

    {"drive.list", observer, "drives of the machine file with bus address, kind and requests"},
    {"drive.status", observer,
     "every drive: state, fault, position, switches, errors; the bus: exchanges, latency"},
    {"drive.reset", machine_operator, "clear the fault of a drive", of_drive},
    {"drive.fault", integrator, "make a simulated drive fail, or work again", of_drive_fault},

    {"alarm.list", observer, "alarms that stand", of_channel},
    {"alarm.ack", machine_operator, "acknowledge the alarms of a channel", of_channel,
     "alarm_acknowledge"},
    {"alarm.history", observer, "all alarms since the daemon started", of_channel},

    {"tool.list", observer, "tool table"},
    {"tool.get", observer, "one edge of a tool", of_tool},
    {"tool.set", machine_operator, "change a value of a tool; not while a program runs",
     of_tool_value, "tool_set"},
    {"tool.load", machine_operator,
     "set the tools and work offsets that a text names; not while a program runs", of_tables},
    {"tool.save", observer, "tools and work offsets as a text that tool load takes"},

    {"offset.list", observer, "work offsets"},
    {"offset.set", machine_operator, "change a work offset; not while a program runs",
     of_offset_value, "offset_set"},

    {"mdi", machine_operator, "execute one line of program text: a block or a statement", of_line,
     "mdi"},
    {"jog", machine_operator,
     "move an axis by hand: by an increment, or for 200 ms, to be asked again while it shall go on",
     of_jog, "jog"},
    {"home", machine_operator,
     "find the reference marks of the axes of a channel, in their order; answers when it is done",
     of_home, "home"},
    {"process.status", observer, "feed law, feed, spindle, cutting speed and force control",
     of_channel},
    {"process.interrupt", machine_operator,
     "interrupt the feed: at once, then after each L_B of path, for the time of L_A",
     of_interruption, "process_interrupt"},
    {"process.automatic", machine_operator,
     "whether the channel forms a feed law of its own from a sensor", of_automatic_law,
     "process_automatic"},
    {"process.adaptive", machine_operator,
     "adaptive control of the cutting force: on, off, or change one of its values",
     of_force_control, "process_adaptive"},
    {"workpiece.status", observer,
     "whether announcements of workpieces are published, and the latest of every channel"},
    {"workpiece.allow", machine_operator,
     "publish what programs announce with #workpiece, for viewers that follow the cut",
     of_allowance},

    {"log.status", observer, "recorder and LCM publisher: file, bytes, what was lost"},
    {"log.start", machine_operator, "begin a new log file"},
    {"log.stop", machine_operator, "end the log file"},

    {"subscribe", observer, "a snapshot, then what changes, as notifications", of_subscription},
    {"session.role", observer, "give up rights of this connection", of_role},
    {"system.info", observer, "version, build, process, files, clients"},
    {"system.shutdown", integrator, "feed hold, drives off, orderly end of the daemon"},
    {"rpc.discover", observer, "this table as an OpenRPC document"},
});

constexpr auto nouns = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"machine", "the machine as a whole"},
    {"channel", "channels: state and position"},
    {"program", "programs: load, run, hold, stop"},
    {"override", "feed, rapid and spindle overrides"},
    {"kinematics", "kinematic schemes of a channel"},
    {"drive", "drives and their bus"},
    {"alarm", "alarms: list, acknowledge, history"},
    {"tool", "tool table"},
    {"offset", "work offsets"},
    {"process", "cutting process and adaptive control"},
    {"workpiece", "virtual workpiece"},
    {"log", "log files and recorder"},
    {"session", "this connection"},
    {"system", "the daemon itself"},
    {"rpc", "the protocol itself"},
});

}  // namespace

std::span<const Method> methods() {
  return table;
}

const Method* find_method(std::string_view name) {
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const Method& m) { return m.name == name; });
  return row == table.end() ? nullptr : &*row;
}

std::string_view noun(const Method& method) {
  return method.name.substr(0, method.name.find('.'));
}

std::string_view verb(const Method& method) {
  const std::size_t dot = method.name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : method.name.substr(dot + 1);
}

std::string_view noun_help(std::string_view noun) {
  const auto row =
      std::find_if(nouns.begin(), nouns.end(), [&](const auto& n) { return n.first == noun; });
  return row == nouns.end() ? std::string_view{} : row->second;
}

std::string_view role_name(Role role) {
  switch (role) {
    case Role::observer:
      return "observer";
    case Role::machine_operator:
      return "operator";
    case Role::integrator:
      return "integrator";
  }
  return "";
}

std::string_view type_name(ParameterType type) {
  switch (type) {
    case ParameterType::integer:
      return "integer";
    case ParameterType::number:
      return "number";
    case ParameterType::text:
      return "string";
    case ParameterType::choice:
      return "choice";
    case ParameterType::text_list:
      return "list";
  }
  return "";
}

}  // namespace stanok::protocol
