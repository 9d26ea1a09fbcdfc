#include "channels/coordinator/coordinator.h"

#include <algorithm>

#include "base/visit_in_cycle.h"
#include "channels/contract/operator_action.h"

namespace stanok::channels {
namespace {

// What a command that takes time is, as a request. The channel is that of the command.
struct Commission {
  Request operator()(const commands::ProgramLoad& command) const RT_SAFE {
    return requests::ProgramLoad{.program = command.program};
  }
  Request operator()(const commands::ProgramRun& command) const RT_SAFE {
    return requests::ProgramRun{.program = command.program};
  }
  Request operator()(const commands::Mdi& command) const RT_SAFE {
    return requests::LineRun{command.line};
  }
  Request operator()(const commands::ProgramSearch& command) const RT_SAFE {
    return requests::Search{command.target, command.way, command.passes};
  }
  Request operator()(const commands::ProgramStart& /*command*/) const RT_SAFE {
    return requests::ProgramStart{};
  }
  Request operator()(const commands::KinematicsSelect& command) const RT_SAFE {
    return requests::KinematicsSelect{.scheme = command.scheme};
  }
  Request operator()(const commands::Home& command) const RT_SAFE {
    return requests::Home{command.axis};
  }
  Request operator()(const commands::ProgramReturn& command) const RT_SAFE {
    return requests::ProgramReturn{command.velocity};
  }
  // A stop or a reset.
  Request operator()(const auto& /*command*/) const RT_SAFE { return requests::ProgramReset{}; }
};

// What begins something on another channel, or for an operator.
bool begins_something(const Errand& errand) RT_SAFE {
  if (errand.target < 0 || errand.asker == errand.target) return false;
  return holds_one_of<requests::Home, requests::KinematicsSelect, requests::ProgramLoad,
                      requests::Search, requests::ProgramStart, requests::ProgramRun,
                      requests::LineRun, requests::ProgramReturn>(errand.request);
}

// Of the channel that a request names; 0: it names none.
struct NamedChannel {
  template <class Kind>
  std::int32_t operator()(const Kind& request) const RT_SAFE {
    if constexpr (requires { request.channel; }) return request.channel;
    return 0;
  }
};

}  // namespace

struct Coordinator::Step {
  Coordinator& coordinator;
  Errand& errand;

  // On the channel that the request names.
  template <class Function>
  Verdict on_target(Function&& function) const RT_SAFE {
    if (errand.target < 0) return refusal("E6001", "there is no such channel");
    return function(coordinator.channels_[errand.target]);
  }
  [[nodiscard]] Channel& asker() const RT_SAFE { return coordinator.channels_[errand.asker]; }
  [[nodiscard]] ChannelErrands& errands() const RT_SAFE { return coordinator.channel_errands_; }

  Verdict operator()(const requests::Standstill& /*request*/) const RT_SAFE { return success(); }
  Verdict operator()(const requests::Terminate& /*request*/) const RT_SAFE { return success(); }
  // The channel has answered where its probe is.
  Verdict operator()(const requests::ProbeResult& /*request*/) const RT_SAFE { return success(); }
  // Endless on a machine; a simulation ends behind it.
  Verdict operator()(const requests::ProgramRestart& /*request*/) const RT_SAFE {
    return asker().begins_again() ? success() : refusal("W2099", "M99 in the main program");
  }
  Verdict operator()(const requests::TapOut& /*request*/) const RT_SAFE {
    return errands().tap_out(errand);
  }
  Verdict operator()(const requests::SpindleToAxis& request) const RT_SAFE {
    return errands().spindle_to_axis(errand, request.spindle);
  }
  Verdict operator()(const requests::AxisToSpindle& request) const RT_SAFE {
    asker().spindles.open_position_loop(request.spindle);
    return success();
  }
  Verdict operator()(const requests::MarkWait& /*request*/) const RT_SAFE {
    return coordinator.waits_.wait_at_mark(errand);
  }
  Verdict operator()(const requests::EndWait& request) const RT_SAFE {
    return on_target([&](const Channel& target) RT_SAFE {
      return coordinator.waits_.wait_for_end(errand, request.seconds, target);
    });
  }
  Verdict operator()(const requests::StateRead& /*request*/) const RT_SAFE {
    return on_target([](const Channel& target)
                         RT_SAFE { return success(static_cast<double>(target.state().shown())); });
  }
  Verdict operator()(const requests::MarkRead& request) const RT_SAFE {
    return on_target([&](const Channel& target) RT_SAFE {
      return success(target.marks.is_set(request.mark) ? 1.0 : 0.0);
    });
  }
  Verdict operator()(const ChannelRequest auto& request) const RT_SAFE {
    return on_target([&](const Channel&) RT_SAFE { return errands().step(errand, request); });
  }
  Verdict operator()(const ValueRequest auto& /*request*/) const RT_SAFE {
    return coordinator.values_.step(errand);
  }
};

Coordinator::Coordinator(std::span<Channel* const> channels, const OwnerFailures& on_owner_failure,
                         CoordinatorTimes times, ReplyRings replies, const MachineStores& stores)
    : channels_(channels),
      ownership_(channels),
      replies_(replies),
      gate_(times.cycle_s, times.request_age_max_s),
      control_(channels_, ownership_),
      operators_(channels_, control_, stores),
      values_(channels_, ownership_, stores, times.cycle_s),
      waits_(channels_, std::span(errands_).first(channels_max), times.cycle_s),
      channel_errands_(channels_, ownership_, control_, on_owner_failure, times.cycle_s) {}

bool Coordinator::admits(const OperatorEvent& event, std::int64_t cycle) RT_SAFE {
  const int index = channels_.index_of(event.channel);
  const Channel* const named = index < 0 ? nullptr : &channels_[index];
  if (const auto refused = gate_.refusal_of(event, cycle, named, index)) {
    reply(event.id, *refused);
    return false;
  }
  if (event.situation == 0 || index < 0) return true;
  if (channels_[index].items().current_tag().situation == event.situation) return true;
  reply(event.id,
        refusal("E6090", "codes, tool or tables have changed since then: check them again"));
  return false;
}

void Coordinator::take(const OperatorEvent& event) RT_SAFE {
  const int index = channels_.index_of(event.channel);
  if (index < 0 && event.channel != 0)
    return reply(event.id, refusal("E6001", "there is no such channel"));
  Channel* const named = index < 0 ? nullptr : &channels_[index];
  gate_.note(event, index);
  if (const auto refused = refusal_by_rule(event.action(), named)) return reply(event.id, *refused);
  if (const auto verdict = operators_.apply(event, named)) return reply(event.id, *verdict);
  if (named == nullptr) return reply(event.id, refusal("E6001", "a channel must be named"));
  begin_errand(event, index);
}

// What the table of command_rules.h says of a channel, or of all of them.
std::optional<Verdict> Coordinator::refusal_by_rule(OperatorAction action,
                                                    const Channel* named) const RT_SAFE {
  const bool asks_all = concerns_all_channels(action);
  std::string_view code;
  FixedText<64> who;
  int count = 0;
  for (const Channel* const channel : channels_.all()) {
    const bool is_asked = named == nullptr ? asks_all : channel == named;
    if (!is_asked) continue;
    const std::string_view found = refusal_code(action, channel->state().situation());
    if (found.empty() || (count > 0 && found != code)) continue;
    code = found;
    who.append(count++ > 0 ? ", " : "").append(channel->id());
  }
  if (count == 0) return std::nullopt;
  Verdict verdict = refusal(code, count > 1 ? "channels " : "channel ");
  verdict.text.append(who.view()).append(claim_of_refusal(code));
  return verdict;
}

void Coordinator::begin_errand(const OperatorEvent& event, int target) RT_SAFE {
  RunControl& run = channels_[target].run;
  const bool stops = is_stop(event.action());
  const bool resets = event.action() == OperatorAction::program_reset;
  if (stops) resets ? run.begin_reset() : run.begin_stop();
  const auto slot = std::find_if(errands_.begin() + channels_max, errands_.end(),
                                 [](const Errand& errand) RT_SAFE { return !errand.active; });
  if (slot == errands_.end()) {
    // A stop that has begun needs no room; only the answer does not wait for rest.
    return reply(event.id,
                 stops ? success() : refusal("E6002", "there are too many commands at once"));
  }
  *slot = {};
  slot->active = true;
  slot->order = ++errands_taken_;
  slot->reply_id = event.id;
  slot->target = target;
  slot->generation = run.generation();
  slot->controller = control_.of(target);
  slot->request = visit_in_cycle(Commission{}, event.command);
  if (stops)
    slot->state =
        ErrandState(errand_states::Ending{});  // it has begun; what is left is to wait for rest
}

void Coordinator::step() RT_SAFE {
  for (int k = 0; k < channels_.count(); ++k) adopt_request(k);
  waits_.advance([this](Errand& errand, const Verdict& fault) RT_SAFE { conclude(errand, fault); });
  for (Errand& errand : errands_) {
    if (!errand.active || is_asker_held(errand) || !is_its_turn(errand)) continue;
    const Verdict verdict = step(errand);
    ++errand.cycles;
    if (verdict.done) conclude(errand, verdict);
  }
  channel_errands_.follow_owners();
}

void Coordinator::adopt_request(int index) RT_SAFE {
  const OpenRequest* const open = channels_[index].items().request();
  Errand& errand = errands_[index];
  if (open == nullptr) {
    errand.active = false;
    return;
  }
  if (errand.active) return;
  errand = {};
  errand.active = true;
  errand.order = ++errands_taken_;
  errand.asker = index;
  errand.request = open->content;
  errand.tag = open->tag;
  errand.target = channels_.index_of(visit_in_cycle(NamedChannel{}, errand.request));
  if (errand.target < 0) return;
  errand.generation = channels_[errand.target].run.generation();
  errand.controller = control_.of(errand.target);
}

// One after the other: a program that is being loaded is not replaced before it has started.
bool Coordinator::is_its_turn(const Errand& errand) const RT_SAFE {
  return !begins_something(errand) ||
         std::none_of(errands_.begin(), errands_.end(), [&](const Errand& other) RT_SAFE {
           return other.active && other.target == errand.target && other.order < errand.order &&
                  begins_something(other) && !is_asker_held(other);
         });
}

// Stop of a channel holds its wait.
bool Coordinator::is_asker_held(const Errand& errand) const RT_SAFE {
  return errand.asker != operator_asker &&
         channels_[errand.asker].state().shown() == ChannelState::held;
}

Verdict Coordinator::step(Errand& errand) RT_SAFE {
  return visit_in_cycle(Step{*this, errand}, errand.request);
}

void Coordinator::conclude(Errand& errand, const Verdict& verdict) RT_SAFE {
  errand.active = false;
  if (errand.asker == operator_asker) return reply(errand.reply_id, verdict);
  ChannelAnswer answer;
  answer.ok = verdict.ok;
  answer.raises = verdict.raises;
  answer.value = verdict.number;
  answer.code = verdict.code;
  answer.text = verdict.text;
  channels_[errand.asker].items().answer(answer);
}

void Coordinator::reply(std::uint64_t id, const Verdict& verdict) RT_SAFE {
  if (id == 0) return;
  OperatorReply answer;
  answer.id = id;
  answer.ok = verdict.ok;
  answer.code = verdict.code;
  answer.text = FixedText<240>(verdict.text.view());
  const bool is_of_stop = (id & stop_id_mark) != 0;
  if (!(is_of_stop ? replies_.stops : replies_.usual).push(answer))
    replies_.lost.fetch_add(1, std::memory_order_relaxed);
}

bool Coordinator::is_quiet() const RT_SAFE {
  return std::none_of(errands_.begin(), errands_.end(),
                      [](const Errand& errand) RT_SAFE { return errand.active; });
}

}  // namespace stanok::channels
