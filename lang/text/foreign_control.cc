#include "lang/text/foreign_control.h"

#include <algorithm>
#include <array>
#include <string>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr std::string_view siemens = "Siemens";
constexpr std::string_view heidenhain = "Heidenhain";
constexpr std::string_view okuma = "Okuma";

struct Mark {
  std::string_view begins;  // upper case; where it ends with a letter, no letter follows it
  std::string_view control;
};

constexpr auto marks = std::to_array<Mark>({
    {"CYCLE", siemens},       {"POCKET", siemens},       {"HOLES", siemens},
    {"SLOT", siemens},        {"LONGHOLE", siemens},     {"MCALL", siemens},
    {"TRANS", siemens},       {"ATRANS", siemens},       {"ROT", siemens},
    {"AROT", siemens},        {"AMIRROR", siemens},      {"GOTOF", siemens},
    {"GOTOB", siemens},       {"DEF REAL", siemens},     {"DEF INT", siemens},
    {"MSG(", siemens},        {"WORKPIECE", siemens},    {"LIMS", siemens},
    {"DIAMON", siemens},      {"DIAMOF", siemens},       {"T=\"", siemens},
    {"PROC ", siemens},       {"EXTERN ", siemens},      {"TRAORI", siemens},
    {"STOPRE", siemens},      {"TOOL CALL", heidenhain}, {"TOOL DEF", heidenhain},
    {"CYCL ", heidenhain},    {"BLK FORM", heidenhain},  {"LBL ", heidenhain},
    {"CALL LBL", heidenhain}, {"L X+", heidenhain},      {"L X-", heidenhain},
    {"L Y+", heidenhain},     {"L Y-", heidenhain},      {"L Z+", heidenhain},
    {"L Z-", heidenhain},     {"END PGM", heidenhain},   {"VC", okuma},
    {"NOEX", okuma},          {"CALL O", okuma},         {"MODIN", okuma},
    {"MODOUT", okuma},        {"VZOF", okuma},           {"LVC", okuma},
});

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

}  // namespace

std::string_view control_of_header(std::string_view text) {
  if (text.starts_with("%_N_") || text.starts_with(";$PATH=")) return siemens;
  const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
  const std::string line = upper(words_of_line(first));
  if (line.starts_with("BEGIN PGM")) return heidenhain;
  if (line.starts_with('$') && line.find(".MIN%") != std::string::npos) return okuma;
  return {};
}

std::string_view control_of_line(std::string_view line) {
  const std::string words = upper(words_of_line(line));
  for (const Mark& mark : marks) {
    if (!words.starts_with(mark.begins)) continue;
    const char next = words.size() > mark.begins.size() ? words[mark.begins.size()] : ' ';
    if (!is_name_start(mark.begins.back()) || !is_name_start(next)) return mark.control;
  }
  return {};
}

}  // namespace stanok::lang
