// Rows of the command table: texts of programs, what is known of them beforehand, their path.
#include <array>

#include "protocol/contract/method_rows.h"

namespace stanok::protocol::rows {
namespace {

constexpr Parameter file_of_program =
    required_text("program", "program file under the program root");

// A request has at most 1 MiB, and a line end is two characters there.
constexpr double part_bytes_max = 900'000.0;

constexpr Parameter whole_text{
    .name = "text",
    .type = ParameterType::text,
    .presence = Presence::required,
    .spelling = Spelling::file,
    .minimum = 1,
    .maximum = part_bytes_max,
    .help = "text of the program; send a longer text in parts, with `more`"};

constexpr Parameter unsaved_text{.name = "text",
                                 .type = ParameterType::text,
                                 .spelling = Spelling::file,
                                 .minimum = 1,
                                 .maximum = part_bytes_max,
                                 .help = "text to check instead of the file"};

constexpr Parameter name_of_text{.name = "file",
                                 .type = ParameterType::text,
                                 .minimum = 1,
                                 .maximum = 4096,
                                 .help = "where the text comes from; information for people only"};

constexpr Parameter version{.name = "version",
                            .type = ParameterType::text,
                            .minimum = 1,
                            .maximum = 64,
                            .help =
                                "version of the existing text, as program.read returned it; "
                                "default: no text exists yet; any: whatever exists"};

constexpr Parameter more{.name = "more",
                         .type = ParameterType::integer,
                         .minimum = 0,
                         .maximum = 1,
                         .help = "1: the text continues in the next request; default 0"};

constexpr Parameter offset{.name = "offset",
                           .type = ParameterType::integer,
                           .minimum = 0,
                           .maximum = 1e9,
                           .help = "byte at which the answer begins; default 0"};

constexpr Parameter path{
    .name = "path",
    .type = ParameterType::integer,
    .minimum = 1,
    .maximum = 4e9,
    .help = "id of a path that was requested before; default: the newest path"};

constexpr Parameter page{.name = "page",
                         .type = ParameterType::integer,
                         .minimum = 0,
                         .maximum = 1e6,
                         .help = "page of the path, from 0; default: all pages, one by one"};

constexpr Parameter follow{
    .name = "follow",
    .type = ParameterType::integer,
    .minimum = 0,
    .maximum = 1,
    .help =
        "1: the answer names the request for the next page, as it does without `page`; default 0"};

constexpr std::array of_read{file_of_program, offset};
constexpr std::array of_write{file_of_program, whole_text, version, more, name_of_text};
constexpr std::array of_remove{file_of_program, version};
constexpr std::array of_check{file_of_program, unsaved_text, channel, name_of_text};
constexpr std::array of_estimate{file_of_program, channel};
constexpr std::array of_path{channel, path, page, follow, system_of_path};

constexpr auto text_rows = std::to_array<Method>({
    {.name = "program.read",
     .parameters = of_read,
     .help = "read the text of a program and its version, at most 512 KiB at a time",
     .result = R"({"program":"string","text":"string","version":"string","bytes":"integer",
      "offset":"integer","complete":"boolean","exact":"boolean"})"},
    {.name = "program.write",
     .role = programmer,
     .effect = Effect::changes,
     .parameters = of_write,
     .help = "write a program, completely or not at all, if nobody has changed it in the meantime",
     .result = R"({"program":"string","version":"string?","bytes":"integer"})"},
    {.name = "program.remove",
     .role = programmer,
     .effect = Effect::changes,
     .parameters = of_remove,
     .help = "remove a program, if nobody has changed it in the meantime",
     .result = R"({"program":"string"})"},
    {.name = "program.check",
     .course = Course::reads_program,
     .parameters = of_check,
     .help = "find errors and warnings of a program without running it, and the positions of the "
             "rotary axes in its tilted planes; another check on this connection cancels this one",
     .result = R"({"program":"string","ok":"boolean","blocks":"integer","version":"string?",
      "diagnostics":[{"code":"string","severity":"string","file":"string","line":"integer",
       "column":"integer","end_line":"integer","end_column":"integer","message":"string",
       "label":"string","notes":["any"],"help":["string"],"stack":["string"]}],
      "tilted_planes":[{"file":"string","line":"integer","tool":["number"],"axes":"$numbers",
       "other?":{"word":"string","axes":"$numbers","limit?":"number"}}]})"},
    {.name = "program.picture",
     .course = Course::reads_program,
     .parameters = of_estimate,
     .help = "draw the virtual workpiece as the program leaves it after a run on a virtual clock: "
             "`picture` is a PNG in base64, seen from the front, right and above, or null if the "
             "program declares no blank; a check on this connection cancels it",
     .result = R"({"program":"string","ok":"boolean","complete":"boolean","time_s":"number",
      "picture":"string?","removed_mm3":"number?","blank_mm3":"number?","findings":"integer?",
      "alarm":"$alarm?"})"},
    {.name = "program.estimate",
     .course = Course::reads_program,
     .parameters = of_estimate,
     .help = "find the time and path length of a program from a run on a virtual clock, with the "
             "present tables, schemes and positions and with overrides at 100 %; a check on this "
             "connection cancels it",
     .result = R"({"program":"string","ok":"boolean","complete":"boolean","time_s":"number",
      "alarm":"$alarm?","runs":[{"channel":"integer","program":"string","ok":"boolean",
       "blocks":"integer","time_s":"number","path_mm":"number"}]})"},
    {.name = "program.check_cancel",
     .help = "cancel the check or estimate of this connection, which then answers E9017"},
    {.name = "program.path",
     .parameters = of_path,
     .help = "read the planned path of the tool tip from the simulation of the loaded program: "
             "pages of points with the program lines that lead to them",
     .result = R"({"channel":"integer","program":"string?","id":"integer?","pages":"integer",
      "points":"integer","complete":"boolean","given_up":"string?","system":"string",
      "part":"$carried?","geometry":"any"})"},
});

}  // namespace

std::span<const Method> program_text_methods() {
  return text_rows;
}

}  // namespace stanok::protocol::rows
