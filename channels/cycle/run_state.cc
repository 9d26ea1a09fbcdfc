#include "channels/cycle/run_state.h"

#include <array>

#include "base/enum_names.h"

namespace stanok::channels {
namespace {

template <class... Situations>
constexpr SituationSet set_of(Situations... situations) RT_SAFE {
  return static_cast<SituationSet>(((1U << static_cast<unsigned>(situations)) | ...));
}

constexpr SituationSet at_rest = set_of(Situation::off, Situation::idle, Situation::ready);
constexpr SituationSet on_at_rest = set_of(Situation::idle, Situation::ready);
constexpr SituationSet busy = set_of(Situation::running, Situation::held);
constexpr SituationSet stopped = set_of(Situation::alarm, Situation::fault);
constexpr SituationSet beside = set_of(Situation::by_hand, Situation::switching);
constexpr SituationSet any_but_ending =
    at_rest | busy | stopped | beside | set_of(Situation::aside);

constexpr auto table = std::to_array<Transition>({
    {Change::power_on, at_rest, Aim::rest},
    {Change::power_on, stopped, Aim::alarm},
    {Change::power_off, at_rest | beside, Aim::rest},
    {Change::power_off, stopped, Aim::alarm},
    {Change::loaded, at_rest, Aim::rest},
    {Change::run_begins, on_at_rest, Aim::running},
    {Change::held, busy, Aim::held},
    {Change::resumed, set_of(Situation::held), Aim::running},
    {Change::path_left, set_of(Situation::held), Aim::aside},
    {Change::path_joined, set_of(Situation::aside), Aim::held},
    {Change::run_ends, busy, Aim::rest},
    {Change::alarm, any_but_ending, Aim::alarm},
    {Change::ending_begins, any_but_ending, Aim::ending},
    {Change::ending_ends, set_of(Situation::ending), Aim::rest},
    {Change::ending_ends_in_alarm, set_of(Situation::ending), Aim::alarm},
    {Change::hand_begins, on_at_rest, Aim::by_hand},
    {Change::hand_ends, set_of(Situation::by_hand), Aim::rest},
    {Change::switch_begins, on_at_rest, Aim::switching},
    {Change::switch_ends, set_of(Situation::switching), Aim::rest},
});

}  // namespace

std::span<const Transition> transitions() RT_SAFE {
  return table;
}

std::string_view name_of(Change change) {
  static constexpr auto names =
      enum_names<Change>({{Change::power_on, "power_on"},
                          {Change::power_off, "power_off"},
                          {Change::loaded, "loaded"},
                          {Change::run_begins, "run_begins"},
                          {Change::held, "held"},
                          {Change::resumed, "resumed"},
                          {Change::path_left, "path_left"},
                          {Change::path_joined, "path_joined"},
                          {Change::run_ends, "run_ends"},
                          {Change::alarm, "alarm"},
                          {Change::ending_begins, "ending_begins"},
                          {Change::ending_ends, "ending_ends"},
                          {Change::ending_ends_in_alarm, "ending_ends_in_alarm"},
                          {Change::hand_begins, "hand_begins"},
                          {Change::hand_ends, "hand_ends"},
                          {Change::switch_begins, "switch_begins"},
                          {Change::switch_ends, "switch_ends"}});
  return names[change];
}

std::string_view name_of(Aim aim) {
  static constexpr auto names = enum_names<Aim>({{Aim::rest, "rest"},
                                                 {Aim::running, "running"},
                                                 {Aim::held, "held"},
                                                 {Aim::aside, "aside"},
                                                 {Aim::alarm, "alarm"},
                                                 {Aim::ending, "ending"},
                                                 {Aim::by_hand, "by hand"},
                                                 {Aim::switching, "switching"}});
  return names[aim];
}

void RunState::apply(Change change) RT_SAFE {
  note(change);
  for (const Transition& row : table) {
    if (row.change != change || (row.from & set_of(situation_)) == 0) continue;
    situation_ = reached(row.to);
    break;
  }
  if (!is_ending()) shown_ = state();
  if (is_ending() && change == Change::alarm) shown_ = ChannelState::alarm;
}

// What holds whatever the situation is.
void RunState::note(Change change) RT_SAFE {
  switch (change) {
    case Change::power_on:
      is_powered_ = true;
      return;
    case Change::power_off:
      is_powered_ = false;
      return;
    case Change::loaded:
      has_program_ = true;
      return;
    case Change::run_begins:
      is_running_ = true;
      return;
    case Change::run_ends:
      is_running_ = false;
      return;
    default:
      return;
  }
}

ChannelState RunState::state() const RT_SAFE {
  switch (situation_) {
    case Situation::running:
      return ChannelState::running;
    case Situation::held:
    case Situation::aside:
      return ChannelState::held;
    case Situation::alarm:
    case Situation::fault:
      return ChannelState::alarm;
    default:
      return has_program_ ? ChannelState::ready : ChannelState::idle;
  }
}

Situation RunState::reached(Aim aim) const RT_SAFE {
  switch (aim) {
    case Aim::rest:
      if (!is_powered_) return Situation::off;
      return has_program_ ? Situation::ready : Situation::idle;
    case Aim::running:
      return Situation::running;
    case Aim::held:
      return Situation::held;
    case Aim::aside:
      return Situation::aside;
    case Aim::alarm:
      return is_powered_ ? Situation::alarm : Situation::fault;
    case Aim::ending:
      return Situation::ending;
    case Aim::by_hand:
      return Situation::by_hand;
    case Aim::switching:
      return Situation::switching;
  }
  return situation_;
}

}  // namespace stanok::channels
