// Rows of the command table: the cutting process and the virtual workpiece.
#include <array>

#include "protocol/contract/method_rows.h"

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

constexpr Parameter cut_file =
    required_text("program", "file of cut, tool and vibrations (.toml) beneath the program root");

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
                                 .help = "speeds in the range; default 400"};

constexpr auto lobes_methods =
    std::to_array<std::string_view>({"zeroth-order", "semi-discretisation"});

constexpr Parameter lobes_method{
    .name = "method",
    .type = ParameterType::choice,
    .choices = lobes_methods,
    .help =
        "zeroth-order (default): the mean over a tooth; semi-discretisation: each tooth, for "
        "small widths of cut"};

constexpr auto log_kinds = std::to_array<std::string_view>({"turning", "milling", "grinding"});

constexpr Parameter log_kind{.name = "kind",
                             .type = ParameterType::choice,
                             .choices = log_kinds,
                             .help = "what the log is of; default turning"};

constexpr Parameter stock{.name = "stock",
                          .minimum = 1,
                          .maximum = 1000,
                          .help =
                              "turning: the bar before the cut in the frame of the program, as "
                              "0:32,-20:33: from this Z on this radius, mm"};

constexpr Parameter sheet{
    .name = "program",
    .minimum = 1,
    .maximum = text_bytes_max,
    .help =
        "beneath the program root; milling: tool and material (.toml); grinding: "
        "process file (.toml)"};

constexpr Parameter spindle_of_cut{.name = "spindle",
                                   .type = ParameterType::integer,
                                   .minimum = 1,
                                   .maximum = 16,
                                   .help =
                                       "spindle of the machine, from 1 on; grinding: that of "
                                       "the wheel; default 1"};

constexpr Parameter coefficient{.name = "coefficient",
                                .type = ParameterType::number,
                                .unit = "N",
                                .minimum = 1,
                                .maximum = 1e6,
                                .help =
                                    "turning: C of the material, where it is known: tells the "
                                    "efficiency"};

constexpr Parameter touch{.name = "touch",
                          .type = ParameterType::number,
                          .unit = "mm",
                          .minimum = -1e4,
                          .maximum = 1e4,
                          .help =
                              "grinding: X of the program at which the wheel touches; default: "
                              "the allowance"};

constexpr Parameter wheel_speed{.name = "wheel_speed",
                                .type = ParameterType::number,
                                .unit = "m/s",
                                .minimum = 1,
                                .maximum = 200,
                                .help = "grinding: surface speed of the wheel; default 35"};

constexpr Parameter force_kept{.name = "force",
                               .type = ParameterType::number,
                               .unit = "N",
                               .minimum = 1e-3,
                               .maximum = 1e6,
                               .help =
                                   "cutting force to be kept; without it the forces as "
                                   "programmed are told"};

constexpr Parameter stiffness{.name = "stiffness",
                              .type = ParameterType::number,
                              .unit = "N/um",
                              .minimum = 1e-3,
                              .maximum = 1e6,
                              .help =
                                  "turning: of tool and part across the cut; tells the "
                                  "deflection"};

constexpr Parameter tool_of_cut{.name = "tool",
                                .type = ParameterType::integer,
                                .minimum = 1,
                                .maximum = 1e6,
                                .help = "milling: whose cuts are looked at; default: all"};

constexpr Parameter milling_tool{.name = "cut",
                                 .minimum = 1,
                                 .maximum = text_bytes_max,
                                 .help =
                                     "of a milling program: tool and material (.toml) beneath "
                                     "the program root; without it the program is a turning "
                                     "one"};

constexpr std::array of_stability{
    cut_file,
    named_speed("from", "least speed; default 1000"),
    named_speed("to", "greatest speed; default 20000"),
    speeds_count,
    lobes_method,
    named_speed("speed", "of a planned cut, which is judged"),
    named_length("depth", 1e4, "of the planned cut; grinding: its width")};
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
               "grinding: tangential over normal force of the wheel; default 0.4"),
    wheel_speed,
    tool_of_cut,
    named_part("efficiency", 0.1, 1.0,
               "grinding: of the wheel's drive, default 0.85; milling: makes forces of the cut of "
               "those that "
               "the drive saw, default 1")};
constexpr std::array of_forces{
    required_text("program", "part program beneath the program root"),
    milling_tool,
    tool_of_cut,
    named_length("step", 100.0,
                 "milling: between two places that are looked at; default: twice the "
                 "resolution of the workpiece"),
    force_kept,
    named_length("feed_min", 1e3, "least feed, a turn; default: a twentieth of the programmed one"),
    named_length("feed_max", 1e3, "greatest feed, a turn; default: the programmed one"),
    stiffness,
    channel};
constexpr std::array of_grinding{grinding_file};
constexpr std::array of_interruption{dwell_path, real_path, channel};
constexpr std::array of_automatic_law{automatic_law, on_or_off, channel};
constexpr std::array of_force_control{force_action, force_quantity, force_value, channel};
constexpr std::array of_allowance{allowance};
constexpr Parameter reference{.name = "reference",
                              .minimum = 1,
                              .maximum = text_bytes_max,
                              .help =
                                  "STL file beneath the program root, in the workpiece system "
                                  "of the announcement: the numbers of corners are how far they "
                                  "are off it, Int32 in 0.1 um, above 0 outside, instead of "
                                  "tools"};
constexpr std::array of_surface{channel, workpiece, since, from, reference};

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
    {.name = "process.stability",
     .course = Course::reads_program,
     .parameters = of_stability,
     .help =
         "stability lobes, as `stanok process lobes`: depths up to which a cut does not chatter; "
         "limits are speed rev/min, depth mm (null: any), chatter Hz (0: not known)",
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
         "to write into a file",
     .result = R"({"file":"string","kind":"string","figures":[{"name":"string",
      "value":"number","low":"number","high":"number","si":{"name":"string","value":"number",
      "low":"number","high":"number"}}],"noise":"number","residual_w":"number",
      "readings":"integer","power":[["number"]],"text":"string"})"},
    {.name = "process.forces",
     .course = Course::reads_program,
     .parameters = of_forces,
     .help =
         "forces along a program, and feeds that hold one, as `stanok process optimise`; places "
         "are path mm, force as programmed N, as planned N, feed as programmed mm/min, as planned, "
         "power W, depth mm or area mm2, deflection um; text is the program with the feeds",
     .result = R"({"program":"string","kind":"string","blocks":"integer",
      "force_programmed_max_n":"number","force_max_n":"number","power_max_w":"number",
      "deflection_max_um":"number","time_programmed_s":"number","time_s":"number",
      "places":[["number"]],"text":"string?"})"},
    {.name = "process.cancel",
     .help = "end what this connection has calculated of the process, which answers E9017"},

    {.name = "workpiece.status",
     .help = "whether announcements of workpieces are published, and the latest of every channel",
     .result = R"({"allowed":"boolean","workpieces":[{"channel":"integer",
      "tool":"integer"}]})"},
    {.name = "workpiece.surface",
     .parameters = of_surface,
     .help = "surface of the workpiece that is being cut, by pages; or what has changed of it",
     .result = R"({"channel":"integer","workpiece":"integer?","version":"integer",
      "next":"integer?","blank":"any","base":"$carried?","cycles_left_out":"integer",
      "geometry":"any"})"},
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
