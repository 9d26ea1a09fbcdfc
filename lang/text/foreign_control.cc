#include "lang/text/foreign_control.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr std::string_view post_process =
    "stanok reads ISO programs; post-process the part for Fanuc, Haas or LinuxCNC";
constexpr ForeignText siemens{"a program for a Siemens control", post_process};
constexpr ForeignText heidenhain{"a program for a Heidenhain control", post_process};
constexpr ForeignText okuma{"a program for an Okuma control", post_process};
constexpr ForeignText isg{"a program for an ISG control", post_process};
constexpr ForeignText eding{"a program for an Eding control", post_process};
constexpr ForeignText printer{
    "a program for a 3-D printer",
    "stanok has no extruder: make the program with CAM software for machine tools, not a slicer"};
constexpr ForeignText cl_data{
    "CL data (APT), the input of a post-processor",
    "run it through a post-processor for Fanuc, Haas or LinuxCNC and load what that writes"};

struct Mark {
  std::string_view begins;  // upper case; where it ends with a letter, no letter follows it
  const ForeignText* of;
};

constexpr auto marks = std::to_array<Mark>({
    {"CYCLE", &siemens},
    {"POCKET", &siemens},
    {"HOLES", &siemens},
    {"SLOT", &siemens},
    {"LONGHOLE", &siemens},
    {"MCALL", &siemens},
    {"TRANS", &siemens},
    {"ATRANS", &siemens},
    {"ROT", &siemens},
    {"AROT", &siemens},
    {"AMIRROR", &siemens},
    {"GOTOF", &siemens},
    {"GOTOB", &siemens},
    {"DEF REAL", &siemens},
    {"DEF INT", &siemens},
    {"MSG(", &siemens},
    {"WORKPIECE", &siemens},
    {"LIMS", &siemens},
    {"DIAMON", &siemens},
    {"DIAMOF", &siemens},
    {"DIAM90", &siemens},
    {"T=\"", &siemens},
    {"PROC ", &siemens},
    {"EXTERN ", &siemens},
    {"TRAORI", &siemens},
    {"STOPRE", &siemens},
    {"TOOL CALL", &heidenhain},
    {"TOOL DEF", &heidenhain},
    {"CYCL ", &heidenhain},
    {"BLK FORM", &heidenhain},
    {"LBL ", &heidenhain},
    {"CALL LBL", &heidenhain},
    {"L X+", &heidenhain},
    {"L X-", &heidenhain},
    {"L Y+", &heidenhain},
    {"L Y-", &heidenhain},
    {"L Z+", &heidenhain},
    {"L Z-", &heidenhain},
    {"END PGM", &heidenhain},
    {"VC", &okuma},
    {"NOEX", &okuma},
    {"CALL O", &okuma},
    {"MODIN", &okuma},
    {"MODOUT", &okuma},
    {"VZOF", &okuma},
    {"LVC", &okuma},
    {"#SET ", &isg},
    {"#TRAFO", &isg},
    {"#CS ", &isg},
    {"#HSC", &isg},
    {"#CONTOUR", &isg},
    {"#SLOPE", &isg},
    {"#ACS", &isg},
    {"#MCS", &isg},
    {"$IF", &isg},
    {"$ELSE", &isg},
    {"$ENDIF", &isg},
    {"$FOR", &isg},
    {"$WHILE", &isg},
    {"V.G.", &isg},
    {"V.P.", &isg},
    {"V.L.", &isg},
    {"V.E.", &isg},
    {"MSG \"", &eding},
    {"DLGMSG", &eding},
    {"WARNMSG", &eding},
    {"ERRMSG", &eding},
    {"GOSUB", &eding},
    {"LOGMSG", &eding},
    {"M104 S", &printer},
    {"M109 S", &printer},
    {"M140 S", &printer},
    {"M190 S", &printer},
    {"PARTNO", &cl_data},
    {"PPRINT", &cl_data},
    {"CUTTER/", &cl_data},
    {"FEDRAT/", &cl_data},
    {"LOADTL/", &cl_data},
    {"SPINDL/", &cl_data},
    {"COOLNT/", &cl_data},
    {"GOTO/", &cl_data},
    {"FROM/", &cl_data},
    {"MULTAX", &cl_data},
    {"UNITS/", &cl_data},
    {"TOOL PATH/", &cl_data},
    {"TLDATA/", &cl_data},
});

// Words of Siemens that stand anywhere in a line: absolute and incremental values.
constexpr auto siemens_values =
    std::to_array<std::string_view>({"=AC(", "=IC(", "=DC(", "=ACP(", "=ACN("});

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), upper_case);
  return result;
}

// Without blanks and the block number before the words.
std::string_view words_of_line(std::string_view line) {
  std::size_t at = 0;
  const auto skip = [&](bool (*is)(char)) {
    while (at < line.size() && is(line[at])) ++at;
  };
  skip(is_blank);
  const bool numbered =
      at + 1 < line.size() && upper_case(line[at]) == 'N' && is_digit(line[at + 1]);
  if (numbered) ++at;
  skip(is_digit);  // Heidenhain numbers its blocks without a letter
  skip(is_blank);
  return line.substr(at);
}

// `LABEL1: G1 X10`: a name of at least two letters, then a colon.
bool begins_with_label(std::string_view words) {
  std::size_t at = 0;
  while (at < words.size() && is_name_part(words[at])) ++at;
  constexpr std::size_t letters_min = 2;
  return at >= letters_min && words.substr(0, at) != "DEFAULT" && is_name_start(words[0]) &&
         is_name_start(words[1]) && at < words.size() && words[at] == ':';
}

}  // namespace

const ForeignText* foreign_by_header(std::string_view text) {
  if (text.starts_with("%_N_") || text.starts_with(";$PATH=")) return &siemens;
  const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
  const std::string line = upper(words_of_line(first));
  if (line.starts_with("BEGIN PGM")) return &heidenhain;
  if (line.starts_with('$') && line.find(".MIN%") != std::string::npos) return &okuma;
  return nullptr;
}

const ForeignText* foreign_by_line(std::string_view line) {
  const std::string words = upper(words_of_line(line));
  for (const Mark& mark : marks) {
    if (!words.starts_with(mark.begins)) continue;
    const char next = words.size() > mark.begins.size() ? words[mark.begins.size()] : ' ';
    if (!is_name_start(mark.begins.back()) || !is_name_start(next)) return mark.of;
  }
  const bool has_value = std::ranges::any_of(siemens_values, [&](std::string_view value) {
    return words.find(value) != std::string::npos;
  });
  return has_value || begins_with_label(words) ? &siemens : nullptr;
}

}  // namespace stanok::lang
