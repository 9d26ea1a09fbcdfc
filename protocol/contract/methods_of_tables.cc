// Rows of the command table: tools and work offsets.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr Parameter tool_number{.name = "number",
                                .type = ParameterType::integer,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::number,
                                .minimum = 0,
                                .maximum = 32000,
                                .help = "number of the tool"};

constexpr auto tool_value_choices = std::to_array<std::string_view>(
    {"length", "length_x", "length_y", "radius", "wear_length", "wear_length_x", "wear_radius",
     "overhang", "orientation", "angle_front", "angle_back"});

constexpr Parameter tool_value{.name = "key",
                               .type = ParameterType::choice,
                               .presence = Presence::required,
                               .spelling = Spelling::positional,
                               .carries = Carries::text,
                               .choices = tool_value_choices,
                               .help = "name of the value"};

constexpr Parameter table_value{.name = "value",
                                .type = ParameterType::number,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::value,
                                .unit = "mm, deg",
                                .minimum = -velocity_limit,
                                .maximum = velocity_limit,
                                .help = "new value"};

constexpr Parameter tool_edge{.name = "edge",
                              .type = ParameterType::integer,
                              .carries = Carries::value_2,
                              .minimum = 1,
                              .maximum = 99,
                              .help = "edge of the tool; default 1"};

constexpr Parameter offset_name =
    required_text("offset", "work offset: G54 to G59, G59.1 to G59.3, \"G54.1 P1\"");

constexpr Parameter offset_name_only{
    .name = "offset",
    .type = ParameterType::text,
    .presence = Presence::required,
    .spelling = Spelling::positional,
    .minimum = 1,
    .maximum = 16,
    .help = "work offset: G54 to G59, G59.1 to G59.3, \"G54.1 P1\""};

constexpr Parameter offset_axis{.name = "axis",
                                .type = ParameterType::text,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .carries = Carries::more_text,
                                .minimum = 1,
                                .maximum = 16,
                                .help = "axis of the machine, or R for the rotation"};

constexpr Parameter confirmed{
    .name = "confirmed",
    .type = ParameterType::integer,
    .minimum = 0,
    .maximum = 1,
    .help = "1: set the value even if the value or the change exceeds entry_limits"};

constexpr double table_bytes_max = 1e6;

constexpr Parameter tables_text{.name = "tables",
                                .type = ParameterType::text,
                                .presence = Presence::required,
                                .spelling = Spelling::file,
                                .minimum = 1,
                                .maximum = table_bytes_max,
                                .help = "tools and work offsets, as in a tables file"};

constexpr Parameter tables_name{
    .name = "file",
    .type = ParameterType::text,
    .minimum = 1,
    .maximum = 4096,
    .help = "name of the text in messages; default: the name of the file"};

constexpr Parameter touched_axis{.name = "axis",
                                 .type = ParameterType::text,
                                 .presence = Presence::required,
                                 .spelling = Spelling::positional,
                                 .minimum = 1,
                                 .maximum = 16,
                                 .help = "axis, by its word or its name"};

constexpr Parameter touched_value{.name = "value",
                                  .type = ParameterType::number,
                                  .presence = Presence::required,
                                  .spelling = Spelling::positional,
                                  .unit = "mm, deg",
                                  .minimum = -velocity_limit,
                                  .maximum = velocity_limit,
                                  .help = "position that the axis is to have in the work system"};

constexpr auto touch_choices = std::to_array<std::string_view>({"radius", "diameter"});

constexpr Parameter touched_as{
    .name = "as",
    .type = ParameterType::choice,
    .choices = touch_choices,
    .help = "whether the value is a radius or a diameter; required if X is shown as a diameter"};

constexpr Parameter touched_tool{.name = "number",
                                 .type = ParameterType::integer,
                                 .presence = Presence::required,
                                 .spelling = Spelling::positional,
                                 .minimum = 1,
                                 .maximum = 32000,
                                 .help = "number of the tool"};

constexpr Parameter touched_edge{.name = "edge",
                                 .type = ParameterType::integer,
                                 .minimum = 1,
                                 .maximum = 99,
                                 .help = "edge of the tool; default 1"};

constexpr Parameter undo_number{.name = "undo",
                                .type = ParameterType::integer,
                                .presence = Presence::required,
                                .spelling = Spelling::positional,
                                .minimum = 1,
                                .maximum = 1e9,
                                .help = "number from the answer to the touch-off"};

constexpr std::string_view touch_result = R"({"old":"number","new":"number","undo":"integer"})";

constexpr std::array of_tool{tool_number, tool_edge};
constexpr std::array of_touched_offset{offset_name_only, touched_axis, touched_value, touched_as,
                                       seen_situation,   confirmed,    channel};
constexpr std::array of_touched_tool{touched_tool,   touched_axis, touched_value, touched_as,
                                     seen_situation, touched_edge, confirmed,     channel};
constexpr std::array of_undo{undo_number};
constexpr std::array of_tool_value{tool_number, tool_value, table_value, tool_edge, confirmed};
constexpr std::array of_tables{tables_text, tables_name, confirmed};
constexpr std::array of_offset_value{offset_name, offset_axis, table_value, confirmed};

constexpr auto tables_rows = std::to_array<Method>({
    {.name = "tool.list", .help = "list the tool table", .result = R"({"tools":["$tool"]})"},
    {.name = "tool.get",
     .parameters = of_tool,
     .help = "show the values of one edge of a tool",
     .result = R"("$tool")"},
    {.name = "tool.set",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "tool_set",
     .parameters = of_tool_value,
     .help = "change a value of a tool; not while a program runs"},
    {.name = "tool.touch",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_touched_tool,
     .help = "touch off: set the length of a tool so that an axis is at a given value; at rest, or "
             "in a "
             "hold",
     .result = touch_result},
    {.name = "tool.load",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_tables,
     .help = "set the tools and work offsets listed in a text; not while a program is running",
     .result = R"({"values":"integer"})"},
    {.name = "tool.save",
     .help = "print tools and work offsets as a text for `tool load`",
     .result = R"({"tables":"string"})"},
    {.name = "tool.history",
     .help = "list the newest 500 changes of tools and work offsets since the daemon started, "
             "newest first: by an operator, or by the program that ran last",
     .result = R"({"changes":[{"time_s":"number","by":"string","what":"string","from":"number",
      "to":"number"}]})"},

    {.name = "offset.list",
     .help = "list the work offsets",
     .result = R"({"axes":["string"],"offsets":{"*":"$numbers"}})"},
    {.name = "offset.set",
     .role = machine_operator,
     .effect = Effect::changes,
     .action = "offset_set",
     .parameters = of_offset_value,
     .help = "change a work offset; not while a program runs"},
    {.name = "offset.touch",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_touched_offset,
     .help = "touch off: set a work offset so that an axis is at a given value; only at rest",
     .result = touch_result},
    {.name = "offset.undo",
     .role = machine_operator,
     .effect = Effect::changes,
     .parameters = of_undo,
     .help = "undo a touch-off of an offset or a tool, if nobody has changed the value since",
     .result = R"({"old":"number","new":"number"})"},
});

}  // namespace

std::span<const Method> tables_methods() {
  return tables_rows;
}

}  // namespace stanok::protocol::rows
