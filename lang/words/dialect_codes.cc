#include "lang/words/dialect_codes.h"

#include <algorithm>
#include <array>

#include "lang/words/channel_words.h"

namespace stanok::lang {
namespace {

// In words alone: code_table.cc has rows of these names.
constexpr CodeNumber g_code(int whole, int tenth = 0) {
  return lang::g(whole, tenth);
}
constexpr CodeNumber m_code(int whole) {
  return lang::m(whole);
}

constexpr Code dialect_row(CodeNumber number, Group group, EffectOrder order,
                           std::string_view words, CodeAction action, std::string_view title) {
  return {'G',
          number,
          group,
          group_bit(group),
          order,
          AxisWords::unused,
          letters_of(words),
          Availability::everywhere,
          action,
          title};
}

constexpr Code switch_of_look_ahead(CodeNumber number, std::string_view words) {
  return dialect_row(number, Group::none, EffectOrder::path_mode, words,
                     CodeAction::accept_high_speed, "look-ahead switch");
}

// G5 and G5.1 without axis words are no curves.
constexpr Code high_speed_by_p = switch_of_look_ahead(g_code(5), "P");
constexpr Code high_speed_by_q = switch_of_look_ahead(g_code(5, 1), "Q");
// With the level of smoothness. Source: Fanuc B-64304EN-2, "AI contour control".
constexpr Code high_speed_with_level = switch_of_look_ahead(g_code(5, 1), "QR");
// G8 P1 and G8 P0 of Fanuc, the look-ahead of older controls.
constexpr Code look_ahead_by_p = switch_of_look_ahead(g_code(8), "P");
// The protected zones of Fanuc are not there: they are off always. G22 wants them and stays
// unknown.
constexpr Code zones_off = dialect_row(g_code(23), Group::none, EffectOrder::settings, "",
                                       CodeAction::only_modal, "protected zones off");
// G54 P2 of Fanuc is G54.1 P2 (B-64304EN-2, 7.2.6).
constexpr Code extended_offset =
    dialect_row(g_code(54, 1), Group::work_offset, EffectOrder::work_offset, "P",
                CodeAction::select_work_offset, "work offset of the extended table");

// Patterns of holes. Source: Haas mill operator's manual, G70, G71, G72.
constexpr Code pattern(CodeNumber number, std::string_view words, std::string_view title) {
  return dialect_row(number, Group::none, EffectOrder::motion, words, CodeAction::drill_pattern,
                     title);
}
constexpr Code bolt_circle = pattern(g_code(70), "IJL", "holes on a circle");
constexpr Code bolt_arc = pattern(g_code(71), "IJKL", "holes on an arc");
constexpr Code bolt_line = pattern(g_code(72), "IJL", "holes on a line");

// Cycles along a profile in an O-subprogram. Source: LinuxCNC, G-Codes.
constexpr Code profile_cycle(CodeNumber number, std::string_view words, CodeAction action,
                             std::string_view title) {
  Code code = dialect_row(number, Group::none, EffectOrder::motion, words, action, title);
  code.axes = AxisWords::optional;
  code.availability = Availability::lathe_only;
  return code;
}
constexpr auto profile_cycles = std::to_array<Code>(
    {profile_cycle(g_code(70), "QDEP", CodeAction::finish_profile, "finishing of a profile"),
     profile_cycle(g_code(71), "QDIR", CodeAction::rough_profile, "roughing of a profile"),
     profile_cycle(g_code(71, 1), "QDIR", CodeAction::rough_profile,
                   "roughing of a profile without pockets"),
     profile_cycle(g_code(71, 2), "QDIR", CodeAction::rough_profile,
                   "roughing of the pockets of a profile"),
     profile_cycle(g_code(72), "QDIR", CodeAction::rough_profile, "facing of a profile"),
     profile_cycle(g_code(72, 1), "QDIR", CodeAction::rough_profile,
                   "facing of a profile without pockets"),
     profile_cycle(g_code(72, 2), "QDIR", CodeAction::rough_profile,
                   "facing of the pockets of a profile")});

constexpr std::size_t offsets_of_haas = 20;
constexpr auto offset_rows = [] {
  std::array<Code, offsets_of_haas> rows;
  CodeNumber number = first_offset_of_haas;
  for (Code& offset : rows) {
    offset = dialect_row(number, Group::work_offset, EffectOrder::work_offset, "",
                         CodeAction::select_work_offset, "work offset of the extended table");
    number = static_cast<CodeNumber>(number + 10);
  }
  return rows;
}();

// Dynamic work offsets: the table carries the work offset that is active. Source: Haas mill
// operator's manual, G254 and G255.
constexpr Code carried_offset =
    dialect_row(g_code(254), Group::work_offset, EffectOrder::work_offset, "",
                CodeAction::carry_work_offset, "work offset carried by the rotary table");
constexpr Code carried_offset_off =
    dialect_row(g_code(255), Group::work_offset, EffectOrder::work_offset, "",
                CodeAction::carry_work_offset, "end of G254");

// Cycles that lathes have as mills do, along Z. Sources: Haas lathe operator's manual; LinuxCNC,
// G-Codes.
constexpr auto cycles_along_z = std::to_array<CodeNumber>(
    {g_code(81), g_code(82), g_code(85), g_code(86), g_code(87), g_code(88), g_code(89)});
const Code* cycle_along_z(CodeNumber number) {
  static const auto rows = [] {
    std::array<Code, cycles_along_z.size()> made;
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = *find_code('G', cycles_along_z[i]);
      made[i].availability = Availability::not_master;
    }
    return made;
  }();
  const auto* const found = std::ranges::find(rows, number, &Code::number);
  return found == rows.end() ? nullptr : found;
}

// G43.1 of LinuxCNC without axis words leaves the offset as it is.
const Code* offset_by_words() {
  static const Code made = [] {
    Code code = *find_code('G', g_code(43, 1));
    code.axes = AxisWords::optional;
    return code;
  }();
  return &made;
}

// Lathes of LinuxCNC have no boring from behind and none into the side.
constexpr bool bores_on_linuxcnc(CodeNumber number) {
  return number != g_code(87) && number != g_code(88);
}
const Code* code_of_linuxcnc(CodeNumber number, const ChannelKind* kind) {
  if (number == g_code(43, 1)) return offset_by_words();
  if (kind == nullptr || *kind != ChannelKind::lathe) return nullptr;
  const auto* const found = std::ranges::find(profile_cycles, number, &Code::number);
  if (found != profile_cycles.end()) return found;
  return bores_on_linuxcnc(number) ? cycle_along_z(number) : nullptr;
}

// G77 of Haas mills bores from behind.
const Code* back_bore() {
  static const Code made = [] {
    Code code = *find_code('G', g_code(87));
    code.number = g_code(77);
    code.title = "back boring";
    return code;
  }();
  return &made;
}

// M59 and M69 of Haas switch an output by its number or that of its variable, M76 and M77 the
// display, M130 shows a file: the latter two say nothing here. M78 and M79 are alarms when the last
// skip had a signal, or had none. Source: Haas operator's manuals.
constexpr Code function_of_haas(CodeNumber number, std::string_view words, CodeAction action,
                                std::string_view title) {
  Code code = dialect_row(number, Group::none, EffectOrder::functions_before, words, action, title);
  code.letter = 'M';
  return code;
}
constexpr Code alarm_of_skip(CodeNumber number, std::string_view title) {
  Code code = function_of_haas(number, "", CodeAction::check_skip, title);
  code.order = EffectOrder::functions_after;
  return code;
}
constexpr auto functions_of_haas = std::to_array<Code>(
    {function_of_haas(m_code(59), "P", CodeAction::switch_output, "output on"),
     function_of_haas(m_code(69), "P", CodeAction::switch_output, "output off"),
     function_of_haas(m_code(76), "", CodeAction::only_modal, "display off"),
     function_of_haas(m_code(77), "", CodeAction::only_modal, "display on"),
     alarm_of_skip(m_code(78), "alarm if the skip signal was found"),
     alarm_of_skip(m_code(79), "alarm if the skip signal was not found"),
     function_of_haas(m_code(130), "", CodeAction::only_modal, "picture on the display")});

// M23 and M24 of Haas lathes: how threads end. On mills they are the builder's.
constexpr auto chamfers_of_threads = std::to_array<Code>(
    {function_of_haas(m_code(23), "", CodeAction::switch_thread_chamfer, "threads run out"),
     function_of_haas(m_code(24), "", CodeAction::switch_thread_chamfer, "threads end straight")});
const Code* chamfer_of_threads(CodeNumber number, const ChannelKind* kind) {
  if (kind == nullptr || *kind != ChannelKind::lathe) return nullptr;
  const auto* const found = std::ranges::find(chamfers_of_threads, number, &Code::number);
  return found == chamfers_of_threads.end() ? nullptr : found;
}

// Other numbers of codes: those of Fanuc lathes (B-64304EN-1, table 3.1), and a tool change of
// Haas.
const Code* called_otherwise(char letter, CodeNumber number, const TextRules& rules,
                             const ChannelKind* kind) {
  if (letter == 'M') {
    if (!rules.is_haas()) return nullptr;
    if (const Code* const chamfer = chamfer_of_threads(number, kind)) return chamfer;
    if (number == m_code(16)) return find_code('M', m_code(6));
    const auto* const found = std::ranges::find(functions_of_haas, number, &Code::number);
    return found == functions_of_haas.end() ? nullptr : found;
  }
  if (rules.is_haas()) return nullptr;
  switch (number) {
    case g_code(107):
      return find_code('G', g_code(7, 1));
    case g_code(112):
      return find_code('G', g_code(12, 1));
    case g_code(113):
      return find_code('G', g_code(13, 1));
    default:
      return nullptr;
  }
}

const Code* code_of_haas(CodeNumber number, const ChannelKind* kind) {
  if (is_offset_of_haas(number)) return &*std::ranges::find(offset_rows, number, &Code::number);
  if (kind == nullptr || *kind == ChannelKind::master) return nullptr;
  if (*kind == ChannelKind::lathe) return cycle_along_z(number);
  switch (number) {
    case g_code(70):
      return &bolt_circle;
    case g_code(71):
      return &bolt_arc;
    case g_code(72):
      return &bolt_line;
    case g_code(77):
      return back_bore();
    case g_code(234):
      return find_code('G', g_code(43, 4));
    case g_code(254):
      return &carried_offset;
    case g_code(255):
      return &carried_offset_off;
    default:
      return nullptr;
  }
}

}  // namespace

bool is_left_to_builders(char letter, CodeNumber number) {
  struct Range {
    CodeNumber first;
    CodeNumber last;
  };
  constexpr auto ranges = std::to_array<Range>(
      {{m_code(50), m_code(53)}, {m_code(61), m_code(68)}, {m_code(70), m_code(72)}});
  return letter == 'M' && std::ranges::any_of(ranges, [number](const Range& range) {
           return number >= range.first && number <= range.last;
         });
}

const Code* code_of_dialect(char letter, CodeNumber number, const BlockWords& words,
                            const ChannelKind* kind) {
  const TextRules& rules = words.rules;
  if (letter == 'G') {
    const bool switch_only =
        words.named.empty() && (words.letters & (customary_axis_letters | letters_of("IJ"))) == 0;
    if (number == g_code(5) && switch_only && !words.has('Q')) return &high_speed_by_p;
    if (number == g_code(5, 1) && switch_only)
      return rules.is_fanuc() ? &high_speed_with_level : &high_speed_by_q;
  }
  if (letter == 'G' && rules.is_linuxcnc()) return code_of_linuxcnc(number, kind);
  if (!rules.is_fanuc()) return nullptr;
  if (const Code* const other = called_otherwise(letter, number, rules, kind)) return other;
  if (letter != 'G') return nullptr;
  if (number == g_code(8) && words.has('P')) return &look_ahead_by_p;
  if (number == g_code(23)) return &zones_off;
  if (number == g_code(54) && words.has('P')) return &extended_offset;
  return rules.is_haas() ? code_of_haas(number, kind) : nullptr;
}

}  // namespace stanok::lang
