// Rows of the command table: the cutting process and the virtual workpiece.
#include <array>

#include "protocol/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double interruption_mm_max = 10000.0;

constexpr Parameter dwell_path{
    .name = "la",
    .type = ParameterType::number,
    .presence = Presence::required,
    .carries = Carries::value,
    .unit = "mm",
    .minimum = 0,
    .maximum = interruption_mm_max,
    .help =
        "equivalent dwell path L_A: the axes rest as long as it would take at the feed; 0 ends "
        "the interruption"};

constexpr Parameter real_path{.name = "lb",
                              .type = ParameterType::number,
                              .carries = Carries::value_2,
                              .unit = "mm",
                              .minimum = 0,
                              .maximum = interruption_mm_max,
                              .help = "path L_B at feed from one rest to the next"};

constexpr auto automatic_laws = std::to_array<std::string_view>({"modulated", "linear"});

constexpr Parameter automatic_law{
    .name = "law",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::text,
    .choices = automatic_laws,
    .help = "modulated: acts on the vibration; linear: on the power of the spindle"};

// Their places are channels::ForceAction.
constexpr auto force_actions = std::to_array<std::string_view>({"off", "on", "set"});

constexpr Parameter force_action{
    .name = "action",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::number,
    .choices = force_actions,
    .help = "on: control to the force given, or to the last one; set: change one value"};

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
                                .help = "new value of the quantity; above 0"};

constexpr Parameter allowance{.name = "on",
                              .type = ParameterType::integer,
                              .spelling = Spelling::positional,
                              .minimum = 0,
                              .maximum = 1,
                              .help = "1 (default): allow them; 0: no longer"};

constexpr Parameter workpiece{.name = "workpiece",
                              .type = ParameterType::integer,
                              .minimum = 0,
                              .maximum = 4e9,
                              .help =
                                  "the one that `since` and `from` are of; of another one all is "
                                  "told, from its beginning"};

constexpr Parameter since{.name = "since",
                          .type = ParameterType::integer,
                          .minimum = 0,
                          .maximum = 4e9,
                          .help =
                              "version that is known already: only what has changed later is told; "
                              "default 0: all"};

constexpr Parameter from{.name = "from",
                         .type = ParameterType::integer,
                         .minimum = 0,
                         .maximum = 1e9,
                         .help =
                             "brick with which the page begins, as `next` of the one before "
                             "told; default 0"};

constexpr Parameter grinding_file =
    required_text("program", "process file (.toml) or control file beneath the program root");

constexpr std::array of_grinding{grinding_file};
constexpr std::array of_interruption{dwell_path, real_path, channel};
constexpr std::array of_automatic_law{automatic_law, on_or_off, channel};
constexpr std::array of_force_control{force_action, force_quantity, force_value, channel};
constexpr std::array of_allowance{allowance};
constexpr std::array of_surface{channel, workpiece, since, from};

constexpr auto process_rows = std::to_array<Method>({
    {.name = "process.status",
     .parameters = of_channel,
     .help = "feed law, feed, spindle, cutting speed and force control",
     .result = R"({"channel":"integer","law":"string?","increments":"integer",
      "stands":"boolean","interruption":"any","automatic":["any"],"adaptive":"any",
      "feed_mm_min":"number","feed_mm_rev":"number","spindle_rev_min":"number",
      "cutting_speed_m_min":"number"})"},
    {.name = "process.interrupt",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_interrupt",
     .parameters = of_interruption,
     .help = "interrupt the feed: at once, then after each L_B of path, for the time of L_A"},
    {.name = "process.automatic",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_automatic",
     .parameters = of_automatic_law,
     .help = "automatic feed law: the channel forms the feed from a sensor"},
    {.name = "process.adaptive",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_adaptive",
     .parameters = of_force_control,
     .help =
         "adaptive control of the cutting force: switch it on or off, or change one of its values"},
    {.name = "process.grinding",
     .course = Course::reads_program,
     .parameters = of_grinding,
     .help =
         "plunge grinding cycle: designed from a process file, or verified from a control file; "
         "samples are time s, X mm, allowance left mm, infeed mm/s, removal mm2/rad, and the "
         "removal over its boundary; a check of this connection ends it",
     .result = R"({"program":"string","ok":"boolean",
      "findings":[{"code":"string","text":"string"}],"time_s?":"number",
      "least_time_s?":"number","constant_time_s?":"number?","three_step_time_s?":"number?",
      "continuous_time_s?":"number?","ratio_max?":"number","burn_ratio_max?":"number",
      "residual_um?":"number","roundness_um?":"number","force_max_n?":"number",
      "spark_out_rev?":"number","boundary?":[["number"]],"law?":[["number"]],
      "samples?":[["number"]]})"},

    {.name = "workpiece.status",
     .help = "whether announcements of workpieces are published, and the latest of every channel",
     .result = R"({"allowed":"boolean","workpieces":[{"channel":"integer",
      "tool":"integer"}]})"},
    {.name = "workpiece.surface",
     .parameters = of_surface,
     .help = "surface of the workpiece that is being cut, by pages; or what has changed of it",
     .result = R"({"channel":"integer","workpiece":"integer?","version":"integer",
      "next":"integer?","blank":"any","cycles_left_out":"integer","geometry":"any"})"},
    {.name = "workpiece.allow",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_allowance,
     .help = "publish the workpieces that programs announce with #workpiece, for viewers that "
             "follow the cut",
     .result = R"({"allowed":"boolean"})"},
});

}  // namespace

std::span<const Method> process_methods() {
  return process_rows;
}

}  // namespace stanok::protocol::rows
