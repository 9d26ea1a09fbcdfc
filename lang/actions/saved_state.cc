#include "lang/actions/saved_state.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <variant>
#include <vector>

#include "lang/feed_law/feed_law_numbers.h"
#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr std::string_view version = "GV1";

// Where a value stands in the modal state.
using Member = std::variant<
    bool ModalFeed::*, double ModalFeed::*, FeedLaw ModalFeed::*, bool ModalSpindles::*,
    int ModalSpindles::*, double ModalSpindles::*, bool ModalSwitches::*, int ModalTool::*,
    double ModalTool::*, TurningWay ModalTool::*, int ToolLength::*,
    std::array<double, 3> ToolLength::*, ToolLength::Row ToolLength::*, bool FrameSettings::*,
    int FrameSettings::*, AxisValues FrameSettings::*, double ProgrammedRotation::*,
    std::array<double, 3> ProgrammedRotation::*, bool TiltedPlane::*,
    std::array<double, 3> TiltedPlane::*, bool SetUpError::*, std::array<double, 3> SetUpError::*,
    double PathControl::*, CoordinateMap ModalState::*>;

struct Field {
  StateParts part;
  std::string_view name;
  Member member;
};

const auto fields = std::to_array<Field>({
    {state_modal, "work_offset", &FrameSettings::work_offset_number},
    {state_modal, "carried", &FrameSettings::is_carried},
    {state_modal, "tolerance", &PathControl::tolerance_mm},
    {state_modal, "straightening", &PathControl::straightening_mm},
    {state_modal, "orientation", &ModalTool::turning},
    {state_modal, "feed_override", &ModalSwitches::feed_override},
    {state_modal, "spindle_override", &ModalSwitches::spindle_override},
    {state_feed, "known", &ModalFeed::known},
    {state_feed, "F", &ModalFeed::programmed},
    {state_feed, "mm", &ModalFeed::mm},
    {state_feed, "law", &ModalFeed::law},
    {state_feed, "behind_law", &ModalFeed::behind_law},
    {state_spindle, "S", &ModalSpindles::speed_rev_per_min},
    {state_spindle, "turns", &ModalSpindles::any_runs},
    {state_spindle, "cutting_spindle", &ModalSpindles::cutting_spindle},
    {state_spindle, "cutting_speed", &ModalSpindles::cutting_speed_m_per_min},
    {state_spindle, "speed_limit", &ModalSpindles::speed_limit_rev_per_min},
    {state_tool, "T", &ModalTool::active},
    {state_tool, "H", &ToolLength::tool},
    {state_tool, "length", &ToolLength::offset_mm},
    {state_tool, "edge", &ToolLength::edge},
    {state_tool, "row", &ToolLength::row},
    {state_tool, "base", &ToolLength::base_mm},
    {state_tool, "overhang_axis", &ModalTool::overhang_axis},
    {state_tool, "overhang_shift", &ModalTool::overhang_shift_mm},
    {state_frames, "G52", &FrameSettings::local_shift},
    {state_frames, "G92", &FrameSettings::axis_shift},
    {state_frames, "shifted", &FrameSettings::axis_shift_active},
    {state_frames, "turned_about", &ProgrammedRotation::axis},
    {state_frames, "turned_by", &ProgrammedRotation::angle_deg},
    {state_frames, "centre", &ProgrammedRotation::centre},
    {state_frames, "tilted", &TiltedPlane::is_on},
    {state_frames, "aligned", &TiltedPlane::is_aligned},
    {state_frames, "plane", &TiltedPlane::angles_deg},
    {state_frames, "plane_origin", &TiltedPlane::origin},
    {state_frames, "plane_G52", &TiltedPlane::local_shift},
    {state_frames, "set_up", &SetUpError::is_on},
    {state_frames, "set_up_shift", &SetUpError::shift},
    {state_frames, "set_up_angles", &SetUpError::angles_deg},
    {state_frames, "map", &ModalState::map},
    {state_coolant, "mist", &ModalSwitches::mist},
    {state_coolant, "flood", &ModalSwitches::flood},
});

struct Section {
  StateParts part;
  std::string_view name;
};
constexpr auto sections = std::to_array<Section>({{state_modal, "modal"},
                                                  {state_feed, "feed"},
                                                  {state_spindle, "spindle"},
                                                  {state_tool, "tool"},
                                                  {state_frames, "frames"},
                                                  {state_coolant, "coolant"}});

// The part to which the code of a group belongs; 0: not saved.
StateParts part_of_group(Group group) {
  switch (group) {
    case Group::spindle_mode:
    case Group::spindle:
      return state_spindle;
    case Group::length:
      return state_tool;
    case Group::rotation:
    case Group::scaling:
    case Group::mirror:
      return state_frames;
    default:
      return group < Group::stop || group == Group::override_control ? state_modal : 0;
  }
}

std::uint32_t check_sum(std::string_view text) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char c : text) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1U ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

std::string check_sum_text(std::string_view text) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", check_sum(text));
  return digits;
}

std::string number_text(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

std::string list_text(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + number_text(number);
  return text;
}

template <class Type>
constexpr bool is_number = std::is_arithmetic_v<Type> || std::is_enum_v<Type>;

template <class Owner>
Owner& owner(ModalState& state) {
  return std::get<Owner&>(std::tie(state, state.feed, state.spindles, state.switches, state.tool,
                                   state.tool.length, state.frames, state.frames.rotation,
                                   state.frames.plane, state.frames.set_up, state.path));
}

std::string value_text(ModalState& state, const Member& member) {
  return std::visit(
      [&]<class Owner, class Type>(Type Owner::* at) -> std::string {
        const Type& value = owner<Owner>(state).*at;
        if constexpr (is_number<Type>) {
          return number_text(static_cast<double>(value));
        } else if constexpr (std::is_same_v<Type, CoordinateMap>) {
          return list_text(value.numbers());
        } else if constexpr (std::is_same_v<Type, FeedLaw>) {
          return list_text(numbers_of(value));
        } else {
          return list_text(value);
        }
      },
      member);
}

// Exactly as many finite numbers as there are places, separated by commas.
bool read_list(std::string_view text, std::span<double> numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i != 0) {
      if (at == end || *at != ',') return false;
      ++at;
    }
    const auto [next, error] = fast_float::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !std::isfinite(numbers[i])) return false;
    at = next;
  }
  return at == end;
}

bool read_value(std::string_view text, ModalState& state, const Member& member) {
  return std::visit(
      [&]<class Owner, class Type>(Type Owner::* at) {
        Type& value = owner<Owner>(state).*at;
        if constexpr (is_number<Type>) {
          double number = 0.0;
          if (!read_list(text, {&number, 1}) || std::abs(number) > 1e12) return false;
          value = static_cast<Type>(number);
          return static_cast<double>(value) == number;
        } else if constexpr (std::is_same_v<Type, CoordinateMap>) {
          CoordinateMap::Numbers numbers{};
          return read_list(text, numbers) && value.take(numbers);
        } else if constexpr (std::is_same_v<Type, FeedLaw>) {
          std::vector<double> numbers(
              static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1);
          const auto law = read_list(text, numbers) ? law_of_numbers(numbers) : std::nullopt;
          if (law) value = *law;
          return law.has_value();
        } else {
          return read_list(text, value);
        }
      },
      member);
}

// "G43.4" into its group.
bool read_code(std::string_view word, StateParts part, ModalState& state) {
  double number = 0.0;
  if (!read_list(word.substr(1), {&number, 1}) || number < 0.0 || number > 999.0) return false;
  const auto tenths = static_cast<CodeNumber>(std::lround(number * 10.0));
  const Code* const code = find_code(word[0], tenths);
  if (code == nullptr) return false;
  bool taken = false;
  for (const Group group : all_groups) {
    if ((code->groups & group_bit(group)) == 0 || part_of_group(group) != part) continue;
    state.set(group, tenths, 0);
    taken = true;
  }
  return taken;
}

// "F=200" or "G17"
bool read_saved_word(std::string_view word, StateParts part, ModalState& state) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) return word.size() > 1 && read_code(word, part, state);
  for (const Field& field : fields) {
    if (field.part != part || field.name != word.substr(0, equals)) continue;
    return read_value(word.substr(equals + 1), state, field.member);
  }
  return false;
}

// "feed F=200 mm=200"
bool read_section(std::string_view text, SavedState& saved) {
  const std::size_t name_end = text.find(' ');
  const std::string_view name = text.substr(0, name_end);
  for (const Section& section : sections) {
    if (section.name != name || (saved.parts & section.part) != 0) continue;
    saved.parts |= section.part;
    for (std::size_t at = name_end; at < text.size();) {
      const std::size_t end = std::min(text.find(' ', at + 1), text.size());
      if (!read_saved_word(text.substr(at + 1, end - at - 1), section.part, saved.state))
        return false;
      at = end;
    }
    return true;
  }
  return false;
}

// By G68, also within a tilted plane, whose code is the active one then.
bool is_turned(const ModalState& state) {
  return state.frames.rotation.axis != std::array<double, 3>{};
}

// Modes follow from codes, codes of coolant from its state.
void complete_state(ModalState& state) {
  state.set(Group::mist, state.switches.mist ? m(7) : m(9), 0);
  state.set(Group::flood, state.switches.flood ? m(8) : m(9), 0);
  const CodeNumber path = state.code(Group::path_mode);
  state.path.mode = path == g(64)      ? PathMode::continuous
                    : path == g(61, 1) ? PathMode::exact_stop
                                       : PathMode::exact_path;
  const CodeNumber length = state.code(Group::length);
  state.tool.length.mode = length == g(49)     ? LengthMode::off
                           : leads_tip(length) ? LengthMode::tip
                                               : LengthMode::length;
  if (state.frames.plane.is_aligned) state.tool.length.mode = LengthMode::tip;
  state.frames.plane.rotation = rotation_of(state.frames.plane.angles_deg);
  SetUpError& set_up = state.frames.set_up;
  if (set_up.is_on) set_up.set(set_up.shift, set_up.angles_deg);
  if (is_turned(state)) {
    state.frames.rotation.rotation =
        Rotation::about(vector3(state.frames.rotation.axis), state.frames.rotation.angle_deg);
  }
}

bool is_plausible_state(const ModalState& state) {
  const bool turned = state.code(Group::rotation) == g(68);
  if (turned && state.frames.rotation.axis == std::array<double, 3>{}) return false;
  if (state.tool.turning > TurningWay::axis) return false;
  if (state.tool.length.row > ToolLength::Row::subtracted) return false;
  return state.tool.overhang_axis >= -1 && state.tool.overhang_axis < axes_max;
}

}  // namespace

std::string saved_state_text(const ModalState& state, StateParts parts) {
  ModalState values = state;
  std::string text(version);
  for (const Section& section : sections) {
    if ((parts & section.part) == 0) continue;
    text += ";" + std::string(section.name);
    for (const Group group : all_groups) {
      const bool named = find_code(letter_of(group), state.code(group)) != nullptr;
      if (part_of_group(group) == section.part && named) {
        text += " " + code_text(letter_of(group), state.code(group));
      }
    }
    for (const Field& field : fields) {
      if (field.part != section.part) continue;
      text += " " + std::string(field.name) + "=" + value_text(values, field.member);
    }
  }
  return text + ";crc=" + check_sum_text(text);
}

std::optional<SavedState> read_saved_state(std::string_view text) {
  const std::size_t tail = text.rfind(";crc=");
  if (tail == std::string_view::npos || !text.starts_with(version)) return std::nullopt;
  const std::string_view body = text.substr(0, tail);
  if (text.substr(tail + 5) != check_sum_text(body)) return std::nullopt;
  SavedState saved{0, default_modal_state(ChannelKind::mill)};
  for (std::size_t at = version.size(); at < body.size();) {
    if (body[at] != ';') return std::nullopt;
    const std::size_t end = std::min(body.find(';', at + 1), body.size());
    if (!read_section(body.substr(at + 1, end - at - 1), saved)) return std::nullopt;
    at = end;
  }
  if (!is_plausible_state(saved.state)) return std::nullopt;
  complete_state(saved.state);
  return saved;
}

}  // namespace stanok::lang
