// Rows of the command table: the cutting process and the virtual workpiece.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr double interruption_mm_max = 10000.0;

constexpr Parameter dwell_path{.name = "la",
                               .type = ParameterType::number,
                               .presence = Presence::required,
                               .carries = Carries::value,
                               .unit = "mm",
                               .minimum = 0,
                               .maximum = interruption_mm_max,
                               .help =
                                   "equivalent dwell path L_A: the axes dwell for the time that "
                                   "this path would take at the feed; 0 ends the interruption"};

constexpr Parameter real_path{.name = "lb",
                              .type = ParameterType::number,
                              .carries = Carries::value_2,
                              .unit = "mm",
                              .minimum = 0,
                              .maximum = interruption_mm_max,
                              .help = "path L_B at feed from one dwell to the next"};

constexpr auto automatic_laws = std::to_array<std::string_view>({"modulated", "linear"});

constexpr Parameter automatic_law{
    .name = "law",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::text,
    .choices = automatic_laws,
    .help = "modulated: acts on the vibration; linear: acts on the spindle power"};

// Their places are channels::ForceAction.
constexpr auto force_actions = std::to_array<std::string_view>({"off", "on", "set"});

constexpr Parameter force_action{
    .name = "action",
    .type = ParameterType::choice,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .carries = Carries::number,
    .choices = force_actions,
    .help = "on: control to the given force, or to the last one; set: change one value"};

constexpr auto force_quantities =
    std::to_array<std::string_view>({"force", "level", "mass", "frequency"});

constexpr Parameter force_quantity{
    .name = "quantity",
    .type = ParameterType::choice,
    .spelling = Spelling::positional,
    .carries = Carries::text,
    .choices = force_quantities,
    .help =
        "force: cutting force P_z; level: permissible vibration; mass, frequency: reduced mass and "
        "frequency of the oscillation that is formed from the vibration"};

constexpr double force_value_max = 1e6;

constexpr Parameter force_value{.name = "value",
                                .type = ParameterType::number,
                                .spelling = Spelling::positional,
                                .carries = Carries::value,
                                .unit = "N, um, kg, Hz",
                                .minimum = 0,
                                .maximum = force_value_max,
                                .help = "new value of the quantity, greater than 0"};

constexpr Parameter allowance{.name = "on",
                              .type = ParameterType::integer,
                              .spelling = Spelling::positional,
                              .minimum = 0,
                              .maximum = 1,
                              .help = "1 (default): publish them; 0: stop publishing them"};

constexpr Parameter workpiece{.name = "workpiece",
                              .type = ParameterType::integer,
                              .minimum = 0,
                              .maximum = 4e9,
                              .help =
                                  "workpiece that `since` and `from` refer to; if the channel has "
                                  "another one, the answer contains all of it, from its beginning"};

constexpr Parameter since{.name = "since",
                          .type = ParameterType::integer,
                          .minimum = 0,
                          .maximum = 4e9,
                          .help =
                              "version that you already have: the answer contains only what has "
                              "changed since; default 0: everything"};

constexpr Parameter from{
    .name = "from",
    .type = ParameterType::integer,
    .minimum = 0,
    .maximum = 1e9,
    .help = "brick at which the page begins: `next` of the previous page; default 0"};

constexpr Parameter grinding_file =
    required_text("program", "process file (.toml) or control file under the program root");

constexpr Parameter cut_file =
    required_text("program", "file with cut, tool and vibrations (.toml) under the program root");

constexpr Parameter named_speed(std::string_view name, std::string_view help) {
  return {.name = name,
          .type = ParameterType::number,
          .unit = "rev/min",
          .minimum = 1,
          .maximum = 1e6,
          .help = help};
}

constexpr Parameter named_length(std::string_view name, double maximum, std::string_view help) {
  return {.name = name,
          .type = ParameterType::number,
          .unit = "mm",
          .minimum = 1e-4,
          .maximum = maximum,
          .help = help};
}

constexpr Parameter named_part(std::string_view name, double minimum, double maximum,
                               std::string_view help) {
  return {.name = name,
          .type = ParameterType::number,
          .minimum = minimum,
          .maximum = maximum,
          .help = help};
}

constexpr Parameter speeds_count{.name = "count",
                                 .type = ParameterType::integer,
                                 .minimum = 2,
                                 .maximum = 1200,
                                 .help = "number of speeds in the range; default 400"};

constexpr auto lobes_methods =
    std::to_array<std::string_view>({"zeroth-order", "semi-discretisation"});

constexpr Parameter lobes_method{
    .name = "method",
    .type = ParameterType::choice,
    .choices = lobes_methods,
    .help =
        "zeroth-order (default): uses the mean over a tooth; semi-discretisation: follows each "
        "tooth, for small widths of cut"};

constexpr auto log_kinds = std::to_array<std::string_view>({"turning", "milling", "grinding"});

constexpr Parameter log_kind{.name = "kind",
                             .type = ParameterType::choice,
                             .choices = log_kinds,
                             .help = "kind of cut in the log; default turning"};

constexpr Parameter stock{.name = "stock",
                          .minimum = 1,
                          .maximum = 1000,
                          .help =
                              "turning: bar before the cut in program coordinates, as Z:RADIUS or "
                              "Z:RADIUS:HARDNESS in mm and HB, from each Z on: 0:32,-20:33"};

constexpr Parameter sheet{.name = "program",
                          .minimum = 1,
                          .maximum = text_bytes_max,
                          .help =
                              "file under the program root; milling: tool and material (.toml); "
                              "grinding: process file (.toml)"};

constexpr Parameter spindle_of_cut{
    .name = "spindle",
    .type = ParameterType::integer,
    .minimum = 1,
    .maximum = 16,
    .help = "number of the machine spindle, from 1; grinding: the wheel spindle; default 1"};

constexpr Parameter coefficient{
    .name = "coefficient",
    .type = ParameterType::number,
    .unit = "N",
    .minimum = 1,
    .maximum = 1e6,
    .help = "turning: C of the material; set it if you know it to get the efficiency"};

constexpr Parameter touch{
    .name = "touch",
    .type = ParameterType::number,
    .unit = "mm",
    .minimum = -1e4,
    .maximum = 1e4,
    .help = "grinding: program X at which the wheel touches the part; default: the allowance"};

constexpr Parameter wheel_speed{.name = "wheel_speed",
                                .type = ParameterType::number,
                                .unit = "m/s",
                                .minimum = 1,
                                .maximum = 200,
                                .help = "grinding: surface speed of the wheel; default 35"};

constexpr Parameter force_kept{
    .name = "force",
    .type = ParameterType::number,
    .unit = "N",
    .minimum = 1e-3,
    .maximum = 1e6,
    .help = "cutting force to hold; without it only the forces as programmed are calculated"};

constexpr Parameter stiffness{
    .name = "stiffness",
    .type = ParameterType::number,
    .unit = "N/um",
    .minimum = 1e-3,
    .maximum = 1e6,
    .help = "turning: stiffness of tool and part across the cut; set it to get the deflection"};

constexpr Parameter tool_of_cut{
    .name = "tool",
    .type = ParameterType::integer,
    .minimum = 1,
    .maximum = 1e6,
    .help = "milling: number of the tool whose cuts are evaluated; default: all tools"};

constexpr Parameter milling_tool{.name = "cut",
                                 .minimum = 1,
                                 .maximum = text_bytes_max,
                                 .help =
                                     "milling: file with tool and material (.toml) under the "
                                     "program root; without it the program is a turning program"};

constexpr std::array of_stability{
    cut_file,
    named_speed("from", "lowest speed; default 1000"),
    named_speed("to", "highest speed; default 20000"),
    speeds_count,
    lobes_method,
    named_speed("speed", "speed of a planned cut to be checked"),
    named_length("depth", 1e4, "depth of the planned cut; grinding: its width")};
constexpr std::array of_figures{
    required_text("file", "log, as history.logs lists them"),
    log_kind,
    stock,
    sheet,
    channel,
    spindle_of_cut,
    coefficient,
    touch,
    named_part("force_ratio", 0.05, 2.0,
               "grinding: ratio of tangential to normal force of the wheel; default 0.4"),
    wheel_speed,
    tool_of_cut,
    named_part("efficiency", 0.1, 1.0,
               "grinding: efficiency of the wheel drive, default 0.85; milling: converts the "
               "forces at the drive into those of the cut, default 1")};
constexpr std::array of_forces{
    required_text("program", "part program under the program root"),
    milling_tool,
    tool_of_cut,
    named_length("step", 100.0,
                 "milling: distance between two evaluated positions; default: twice the resolution "
                 "of the workpiece"),
    force_kept,
    named_length("feed_min", 1e3,
                 "lowest feed per revolution; default: a twentieth of the programmed feed"),
    named_length("feed_max", 1e3, "highest feed per revolution; default: the programmed feed"),
    stiffness,
    channel};
constexpr std::array of_grinding{grinding_file};
constexpr std::array of_interruption{dwell_path, real_path, channel};
constexpr std::array of_automatic_law{automatic_law, on_or_off, channel};
constexpr std::array of_force_control{force_action, force_quantity, force_value, channel};
constexpr std::array of_allowance{allowance};
constexpr Parameter reference{
    .name = "reference",
    .minimum = 1,
    .maximum = text_bytes_max,
    .help =
        "STL file under the program root, in the workpiece system of the announcement: the numbers "
        "of the corners are then their distances from its surface, Int32 in 0.1 um, positive "
        "outside, instead of tools"};
constexpr std::array of_surface{channel, workpiece, since, from, reference};

constexpr auto process_rows = std::to_array<Method>({
    {.name = "process.status",
     .parameters = of_channel,
     .help = "show feed law, feed, spindle, cutting speed and force control",
     .result = R"({"channel":"integer","law":"string?","increments":"integer",
      "stands":"boolean","interruption":"any","automatic":["any"],"adaptive":"any",
      "feed_mm_min":"number","feed_mm_rev":"number","spindle_rev_min":"number",
      "cutting_speed_m_min":"number"})"},
    {.name = "process.interrupt",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_interrupt",
     .parameters = of_interruption,
     .help = "interrupt the feed for the time of L_A, immediately and then after each L_B of path"},
    {.name = "process.automatic",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_automatic",
     .parameters = of_automatic_law,
     .help = "switch an automatic feed law on or off: the channel derives the feed from a sensor"},
    {.name = "process.adaptive",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "process_adaptive",
     .parameters = of_force_control,
     .help =
         "switch the adaptive control of the cutting force on or off, or change one of its values"},
    {.name = "process.grinding",
     .course = Course::reads_program,
     .parameters = of_grinding,
     .help =
         "design a plunge grinding cycle from a process file, or verify one from a control file; "
         "samples are time s, X mm, remaining allowance mm, infeed mm/s, removal mm2/rad, and the "
         "ratio of the removal to its boundary; a check on this connection cancels it",
     .result = R"({"program":"string","ok":"boolean",
      "findings":[{"code":"string","text":"string"}],"time_s?":"number",
      "least_time_s?":"number","constant_time_s?":"number?","three_step_time_s?":"number?",
      "continuous_time_s?":"number?","ratio_max?":"number","burn_ratio_max?":"number",
      "residual_um?":"number","roundness_um?":"number","force_max_n?":"number",
      "spark_out_rev?":"number","boundary?":[["number"]],"law?":[["number"]],
      "samples?":[["number"]]})"},
    {.name = "process.stability",
     .course = Course::reads_program,
     .parameters = of_stability,
     .help =
         "calculate stability lobes like `stanok process lobes`: the depths up to which a cut does "
         "not chatter; limits are speed rev/min, depth mm (null: any), chatter Hz (0: not known)",
     .result = R"({"program":"string","kind":"string","always_stable_mm":"number?",
      "limits":[["any"]],"best":[{"speed_rev_per_min":"number","depth_mm":"number?",
      "chatter_hz":"number"}],"cuts":[{"speed_rev_per_min":"number","depth_mm":"number",
      "limit_mm":"number?","stable":"boolean","better_speed_rev_per_min":"number?"}]})"},
    {.name = "process.figures",
     .course = Course::reads_program,
     .parameters = of_figures,
     .help =
         "figures of a cut from its log, as `stanok process identify`, with intervals of 95 %; "
         "si is the same in SI units; power is time s, as recorded W, as fitted W; text is what "
         "to write into a file; fit says whether the model fits: if ok is false, the figures are "
         "not those of the cut; if it is true and there is a reason, their intervals are widened",
     .result = R"({"file":"string","kind":"string","figures":[{"name":"string",
      "value":"number","low":"number","high":"number","si":{"name":"string","value":"number",
      "low":"number","high":"number"}}],"noise":"number","residual_w":"number",
      "readings":"integer","fit":{"ok":"boolean","kind":"string","reason":"string",
      "remedy":"string"},"power":[["number"]],"text":"string"})"},
    {.name = "process.forces",
     .course = Course::reads_program,
     .parameters = of_forces,
     .help = "calculate forces along a program, and feeds that hold a force, like `stanok process "
             "optimise`; places are path mm, force as programmed N, force as planned N, feed as "
             "programmed mm/min, feed as planned mm/min, power W, depth mm or area mm2, deflection "
             "um; text is the program with the planned feeds",
     .result = R"({"program":"string","kind":"string","blocks":"integer",
      "force_programmed_max_n":"number","force_max_n":"number","power_max_w":"number",
      "deflection_max_um":"number","time_programmed_s":"number","time_s":"number",
      "places":[["number"]],"text":"string?"})"},
    {.name = "process.cancel",
     .help = "cancel the process calculation of this connection, which then answers E9017"},

    {.name = "workpiece.status",
     .help = "show whether announcements of workpieces are published, and the latest one of every "
             "channel",
     .result = R"({"allowed":"boolean","workpieces":[{"channel":"integer",
      "tool":"integer"}]})"},
    {.name = "workpiece.surface",
     .parameters = of_surface,
     .help = "read the surface of the workpiece that is being cut, page by page, or only what has "
             "changed",
     .result = R"({"channel":"integer","workpiece":"integer?","version":"integer",
      "next":"integer?","blank":"any","base":"$carried?","cycles_left_out":"integer",
      "geometry":"any"})"},
    {.name = "workpiece.allow",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_allowance,
     .help = "publish the workpieces that programs announce with #workpiece, so that viewers can "
             "follow the cut",
     .result = R"({"allowed":"boolean"})"},
});

}  // namespace

std::span<const Method> process_methods() {
  return process_rows;
}

}  // namespace stanok::protocol::rows
