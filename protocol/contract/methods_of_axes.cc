// Rows of the command table: kinematics, drives and alarms.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr Parameter scheme{.name = "scheme",
                           .type = ParameterType::integer,
                           .presence = Presence::required,
                           .spelling = Spelling::positional,
                           .carries = Carries::number,
                           .minimum = 0,
                           .maximum = 9999,
                           .help = "number of the kinematic scheme"};

constexpr auto fault_choices = std::to_array<std::string_view>(
    {"none", "off", "stuck", "garbage", "slow", "intermittent", "trip", "elsewhere", "mangled",
     "hang_up", "jammed", "frozen"});

constexpr Parameter drive =
    required_text("drive", "name of the axis; for a spindle, S and its number");

constexpr Parameter drive_fault{
    .name = "fault",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .choices = fault_choices,
    .help = "fault that the drive has from now on, or none: the drive works again"};

constexpr std::array of_scheme{scheme, channel, seen_cycle};
constexpr std::array of_drive{drive};
constexpr std::array of_drive_fault{drive, drive_fault};

constexpr auto axes_rows = std::to_array<Method>({
    {.name = "kinematics.list",
     .parameters = of_channel,
     .help = "list the kinematic schemes of a channel",
     .result = R"({"channel":"integer","schemes":[{"id":"integer","type":"string",
      "file":"string?","axes":["string"],"active":"boolean"}]})"},
    {.name = "kinematics.select",
     .role = machine_operator,
     .effect = Effect::begins_motion,
     .action = "kinematics_select",
     .parameters = of_scheme,
     .help = "switch a channel to another kinematic scheme; the channel must be idle"},
    {.name = "kinematics.status",
     .parameters = of_channel,
     .help = "show the active scheme, its axes, and their drives and brakes",
     .result = R"({"channel":"integer","scheme":"integer","type":"string?",
      "axes":[{"name":"string","takes_part":"boolean","enabled":"boolean","brake":"boolean"}]})"},

    {.name = "drive.list",
     .help = "list the drives of the machine file with bus address, kind and requests per exchange",
     .result = R"({"bus":"string","poll_ms":"number","timeout_ms":"number",
      "drives":[{"axis":"string","unit":"integer","kind":"string","requests":"integer",
                 "watchdog_ms":"integer?","absolute_encoder":"boolean","position_scale":"number",
                 "velocity_scale":"number"}]})"},
    {.name = "drive.status",
     .help = "show state, fault, position, switches and errors of every drive, and exchanges and "
             "latency of the bus",
     .result = R"({"choice":"string","endpoint":"string?","connected":"boolean",
      "connections":"integer","exchanges":"integer","errors":"$counts",
      "round_trip_us":"$percentiles",
      "vibration":[{"sensor":"string","amplitude_um":"number","frequency_hz":"number",
                    "synchronous_um":"number","samples":"integer","lost":"integer","errors":"integer"}],
      "axes":["$drive"]})"},
    {.name = "drive.reset",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_drive,
     .help = "clear the fault of a drive"},
    {.name = "drive.fault",
     .role = integrator,
     .effect = Effect::changes,
     .parameters = of_drive_fault,
     .help = "make a simulated drive fail or work again"},

    {.name = "alarm.list",
     .parameters = of_channel,
     .help = "list the active alarms",
     .result = R"({"alarms":["$alarm"],"forgotten?":"integer"})"},
    {.name = "alarm.ack",
     .role = machine_operator,
     .effect = Effect::changes,
     .reach = Reach::every_channel,
     .action = "alarm_acknowledge",
     .parameters = of_channel,
     .help = "acknowledge the alarms of a channel"},
    {.name = "alarm.history",
     .parameters = of_channel,
     .help = "list the newest 500 alarms of each channel",
     .result = R"({"alarms":["$alarm"],"forgotten?":"integer"})"},
    {.name = "measurement.history",
     .parameters = of_channel,
     .help = "list what programs have measured since the daemon started: the newest 500 results of "
             "each channel",
     .result = R"({"measurements":[{"channel":"integer","number":"integer","cycle":"integer",
      "feature":"string","values":{"*":"number"},"text":"string"}],"forgotten?":"integer"})"},
});

}  // namespace

std::span<const Method> axes_methods() {
  return axes_rows;
}

}  // namespace stanok::protocol::rows
