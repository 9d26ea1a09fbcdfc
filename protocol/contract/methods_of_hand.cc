// Rows of the command table: single lines and axes moved by hand.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double turn_limit = 1000.0;

constexpr Parameter line = required_text("text", "one complete statement");

constexpr Parameter jogged_axis = required_text(
    "axis",
    "machine axis as named in the machine file; with another frame than machine: X, Y or Z");

constexpr auto frame_choices = std::to_array<std::string_view>({"machine", "tool", "plane"});
constexpr Parameter jog_frame{
    .name = "frame",
    .type = ParameterType::choice,
    .carries = Carries::number,
    .minimum = 1,
    .maximum = frame_choices.size(),
    .choices = frame_choices,
    .usual = "machine",
    .help =
        "directions of the jog: those of one machine axis, of the tool (Z points from its tip into "
        "the spindle), or of the workpiece as programs see it at present, including tilted planes; "
        "with `tool` and `plane` the tool moves in a straight line and the rotary axes do not "
        "move"};

constexpr Parameter jog_velocity{.name = "velocity",
                                 .type = ParameterType::number,
                                 .presence = Presence::required,
                                 .carries = Carries::value,
                                 .unit = "mm/s, deg/s",
                                 .minimum = -velocity_limit,
                                 .maximum = velocity_limit,
                                 .help = "velocity; its sign is the direction"};

constexpr Parameter jog_increment{
    .name = "increment",
    .type = ParameterType::number,
    .carries = Carries::value_2,
    .unit = "mm, deg",
    .minimum = 0,
    .maximum = velocity_limit,
    .help = "distance to move; without it the axis moves as long as the jog is repeated"};

constexpr Parameter homed_axis{.name = "axis",
                               .type = ParameterType::text,
                               .carries = Carries::text,
                               .minimum = 1,
                               .maximum = text_bytes_max,
                               .help = "home only this axis; default: all axes of the channel"};

// Who types a line wants to know what came of it.
constexpr Parameter wait_as_usual = [] {
  Parameter parameter = wait;
  parameter.usual = "done";
  return parameter;
}();
constexpr std::array of_line{line, channel, wait_as_usual, seen_situation, seen_cycle};
constexpr std::array of_jog{jogged_axis, jog_velocity, jog_increment,
                            jog_frame,   channel,      seen_cycle};
constexpr Parameter turned_axis = required_text(
    "axis",
    "machine axis as named in the machine file, or path: that of a held program, back "
    "or forward");
constexpr Parameter turned_way{
    .name = "way",
    .type = ParameterType::number,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::value,
    .unit = "mm, deg",
    .minimum = -turn_limit,
    .maximum = turn_limit,
    .help = "way by which the wheel was turned; its sign is the direction"};
constexpr std::array of_handwheel{turned_axis, turned_way, channel, seen_cycle};
constexpr std::array of_home{homed_axis, channel, seen_cycle};

constexpr auto hand_rows = std::to_array<Method>({
    {.name = "mdi",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "mdi",
     .parameters = of_line,
     .help = "execute one line of program text: a block or a statement",
     .result = R"("$end of run")"},

    {.name = "jog",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .course = Course::repeats,
     .action = "jog",
     .parameters = of_jog,
     .help = "jog an axis by an increment, or for 200 ms at a time; repeat the command to keep the "
             "axis moving"},

    {.name = "handwheel",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "handwheel",
     .parameters = of_handwheel,
     .help =
         "move an axis as a handwheel does: the way is added to where the axis goes, and "
         "followed as fast as the axis can; what it cannot follow is dropped, so that it stands "
         "soon after the wheel"},

    {.name = "home",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .course = Course::moves_axes,
     .action = "home",
     .parameters = of_home,
     .help = "home the axes of a channel in the order of the machine file; finds the home switches "
             "or index pulses, and answers when homing is done"},
});

}  // namespace

std::span<const Method> hand_methods() {
  return hand_rows;
}

}  // namespace stanok::protocol::rows
