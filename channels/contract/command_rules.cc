#include "channels/contract/command_rules.h"

#include "base/enum_array.h"
#include "channels/contract/operator_action.h"

namespace stanok::channels {
namespace {

// Empty: admitted.
using Codes = EnumArray<Situation, std::string_view>;

constexpr std::string_view yes;
constexpr std::string_view runs = "E6003";
constexpr std::string_view alarm = "E6004";
constexpr std::string_view no_program = "E6005";
constexpr std::string_view off = "E6006";
constexpr std::string_view nothing_ran = "E6007";
constexpr std::string_view by_hand = "E6056";
constexpr std::string_view stops = "E6070";
constexpr std::string_view switches = "E6071";
constexpr std::string_view scheme_in_use = "E5202";
constexpr std::string_view not_held = "E6096";
constexpr std::string_view is_aside = "E6097";
constexpr std::string_view on_path = "E6098";

constexpr Codes always{};
// The columns: off, idle, ready | by hand, switching | running, held, aside | alarm, fault |
// ending.
constexpr Codes power_on{yes, yes, yes, yes, yes, yes, yes, yes, alarm, alarm, stops};
constexpr Codes load{yes, yes, yes, yes, yes, runs, runs, runs, alarm, alarm, stops};
constexpr Codes search{yes,  no_program, yes,   by_hand, switches, runs,
                       runs, runs,       alarm, alarm,   stops};
constexpr Codes run{off, yes, yes, by_hand, switches, runs, runs, runs, alarm, alarm, stops};
constexpr Codes start{off, no_program, yes,   by_hand, switches, runs,
                      yes, is_aside,   alarm, alarm,   stops};
constexpr Codes resume{nothing_ran, nothing_ran, nothing_ran, nothing_ran, nothing_ran, yes,
                       yes,         is_aside,    alarm,       alarm,       stops};
constexpr Codes select{off,           yes,           yes,   by_hand, switches, scheme_in_use,
                       scheme_in_use, scheme_in_use, alarm, alarm,   stops};
constexpr Codes jog_codes{off, yes, yes, yes, switches, runs, yes, yes, yes, off, stops};
constexpr Codes touch{yes, yes, yes, by_hand, switches, runs, runs, runs, yes, yes, stops};
// The length that is measured counts for the held program at once.
constexpr Codes touch_tool{yes, yes, yes, by_hand, switches, runs, yes, yes, yes, yes, stops};
// While a program runs only by a little (E6101).
constexpr Codes tables{yes, yes, yes, yes, yes, yes, yes, yes, yes, yes, stops};
constexpr Codes interlude{nothing_ran, nothing_ran, nothing_ran, nothing_ran, nothing_ran, not_held,
                          yes,         yes,         alarm,       alarm,       stops};
constexpr Codes go_back{nothing_ran, nothing_ran, nothing_ran, nothing_ran, nothing_ran, not_held,
                        on_path,     yes,         alarm,       alarm,       stops};

const Codes& codes_of(AdmissionRule rule) RT_SAFE {
  switch (rule) {
    case AdmissionRule::power_on:
      return power_on;
    case AdmissionRule::load:
      return load;
    case AdmissionRule::search:
      return search;
    case AdmissionRule::run:
      return run;
    case AdmissionRule::start:
      return start;
    case AdmissionRule::resume:
      return resume;
    case AdmissionRule::select:
      return select;
    case AdmissionRule::jog:
      return jog_codes;
    case AdmissionRule::tables:
      return tables;
    case AdmissionRule::touch:
      return touch;
    case AdmissionRule::touch_tool:
      return touch_tool;
    case AdmissionRule::interlude:
      return interlude;
    case AdmissionRule::go_back:
      return go_back;
    case AdmissionRule::always:
      return always;
  }
  return always;
}

}  // namespace

std::string_view name_of(Situation situation) {
  switch (situation) {
    case Situation::off:
      return "off";
    case Situation::idle:
      return "idle";
    case Situation::ready:
      return "ready";
    case Situation::by_hand:
      return "by hand";
    case Situation::switching:
      return "switching";
    case Situation::running:
      return "running";
    case Situation::held:
      return "held";
    case Situation::aside:
      return "aside";
    case Situation::alarm:
      return "alarm";
    case Situation::fault:
      return "fault";
    case Situation::ending:
      return "ending";
  }
  return "";
}

std::string_view refusal_code(OperatorAction action, Situation situation) RT_SAFE {
  return codes_of(row_of(action).rule)[situation];
}

std::string_view claim_of_refusal(std::string_view code) RT_SAFE {
  if (code == runs) return ": a program is running or held";
  if (code == alarm) return " must be reset first: it has an active alarm";
  if (code == no_program) return ": no program is loaded";
  if (code == off) return ": the machine is off";
  if (code == nothing_ran) return ": nothing was running";
  if (code == by_hand) return ": axes are being jogged or homed";
  if (code == stops) return ": it is still coming to rest";
  if (code == switches) return ": the kinematics are being changed";
  if (code == scheme_in_use) return ": a program is using its kinematics";
  if (code == not_held) return ": its program is not held";
  if (code == is_aside) return ": its axes were moved away from the path; return to it first";
  if (code == on_path) return ": its axes are on the path";
  return "";
}

ControlScope control_scope(OperatorAction action) RT_SAFE {
  if (is_stop(action)) return ControlScope::nothing;
  return concerns_all_channels(action) ? ControlScope::all_channels : ControlScope::channel;
}

bool concerns_all_channels(OperatorAction action) RT_SAFE {
  return row_of(action).reach == CommandReach::all_channels;
}

}  // namespace stanok::channels
