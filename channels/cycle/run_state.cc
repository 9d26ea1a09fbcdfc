#include "channels/cycle/run_state.h"

#include <array>

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
constexpr SituationSet any_but_ending = at_rest | busy | stopped | beside;

constexpr auto table = std::to_array<Transition>({
    {Change::power_on, at_rest, Aim::rest},
    {Change::power_on, stopped, Aim::alarm},
    {Change::power_off, at_rest | beside, Aim::rest},
    {Change::power_off, stopped, Aim::alarm},
    {Change::loaded, at_rest, Aim::rest},
    {Change::run_begins, on_at_rest, Aim::running},
    {Change::held, busy, Aim::held},
    {Change::resumed, set_of(Situation::held), Aim::running},
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

ChannelState state_of(Situation situation, bool has_program) RT_SAFE {
  switch (situation) {
    case Situation::running:
      return ChannelState::running;
    case Situation::held:
      return ChannelState::held;
    case Situation::alarm:
    case Situation::fault:
      return ChannelState::alarm;
    default:
      return has_program ? ChannelState::ready : ChannelState::idle;
  }
}

}  // namespace

std::span<const Transition> transitions() RT_SAFE {
  return table;
}

std::string_view name_of(Change change) {
  constexpr auto names = std::to_array<std::string_view>(
      {"power_on", "power_off", "loaded", "run_begins", "held", "resumed", "run_ends", "alarm",
       "ending_begins", "ending_ends", "ending_ends_in_alarm", "hand_begins", "hand_ends",
       "switch_begins", "switch_ends"});
  return names.at(static_cast<std::size_t>(change));
}

std::string_view name_of(Aim aim) {
  constexpr auto names = std::to_array<std::string_view>(
      {"rest", "running", "held", "alarm", "ending", "by hand", "switching"});
  return names.at(static_cast<std::size_t>(aim));
}

void RunState::apply(Change change) RT_SAFE {
  note(change);
  for (const Transition& row : table) {
    if (row.change != change || (row.from & set_of(situation_)) == 0) continue;
    situation_ = reached(row.to);
    break;
  }
  if (!is_ending()) shown_ = state_of(situation_, has_program_);
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

Situation RunState::reached(Aim aim) const RT_SAFE {
  switch (aim) {
    case Aim::rest:
      if (!is_powered_) return Situation::off;
      return has_program_ ? Situation::ready : Situation::idle;
    case Aim::running:
      return Situation::running;
    case Aim::held:
      return Situation::held;
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
