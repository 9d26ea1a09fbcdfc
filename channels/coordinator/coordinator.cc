#include "channels/coordinator/coordinator.h"

#include <algorithm>

#include "base/visit_in_cycle.h"
#include "channels/contract/operator_action.h"

namespace stanok::channels {
namespace {

// What a command that takes time is, as an errand.
struct Commission {
  Errand& errand;

  void load(lang::RequestKind kind, Job job, const ShortText& text) const RT_SAFE {
    errand.kind = kind;
    errand.job = job;
    errand.text = text;
  }
  void operator()(const commands::ProgramLoad& command) const RT_SAFE {
    load(lang::RequestKind::channel_load, Job::program, command.program);
  }
  void operator()(const commands::ProgramRun& command) const RT_SAFE {
    load(lang::RequestKind::channel_run, Job::program, command.program);
  }
  void operator()(const commands::Mdi& command) const RT_SAFE {
    load(lang::RequestKind::channel_run, Job::line, command.line);
  }
  void operator()(const commands::ProgramSearch& command) const RT_SAFE {
    load(lang::RequestKind::channel_load, Job::search, command.target);
    errand.way = command.way;
    errand.passes = command.passes;
  }
  void operator()(const commands::ProgramStart& /*command*/) const RT_SAFE {
    errand.kind = lang::RequestKind::channel_start;
  }
  void operator()(const commands::KinematicsSelect& command) const RT_SAFE {
    errand.kind = lang::RequestKind::kinematics;
    errand.number = command.scheme;
  }
  void operator()(const commands::Home& command) const RT_SAFE {
    errand.kind = lang::RequestKind::channel_reset;
    errand.homes = true;
    errand.text = command.axis;
  }
  // A stop or a reset has begun; what is left is to wait for rest.
  void operator()(const auto& /*command*/) const RT_SAFE {
    errand.kind = lang::RequestKind::channel_reset;
    errand.stage = 1;
  }
};

// What begins something on another channel, or for an operator.
bool begins_something(const Errand& errand) RT_SAFE {
  using lang::RequestKind;
  if (errand.target < 0 || errand.asker == errand.target) return false;
  return errand.homes || errand.kind == RequestKind::kinematics ||
         errand.kind == RequestKind::channel_load || errand.kind == RequestKind::channel_start ||
         errand.kind == RequestKind::channel_run;
}

}  // namespace

Coordinator::Coordinator(std::span<Channel* const> channels, const OwnerFailures& on_owner_failure,
                         double cycle_s, ReplyRings replies, const MachineStores& stores)
    : channels_(channels),
      ownership_(channels),
      replies_(replies),
      control_(channels_, ownership_),
      operators_(channels_, control_, stores),
      values_(channels_, ownership_, stores, cycle_s),
      waits_(channels_, std::span(errands_).first(channels_max), cycle_s),
      channel_errands_(channels_, ownership_, control_, on_owner_failure, cycle_s) {}

void Coordinator::take(const OperatorEvent& event) RT_SAFE {
  const int index = channels_.index_of(event.channel);
  if (index < 0 && event.channel != 0)
    return reply(event.id, refusal("E6001", "there is no such channel"));
  Channel* const named = index < 0 ? nullptr : &channels_[index];
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
    if (channel != named && (named != nullptr || !asks_all)) continue;
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
  visit_in_cycle(Commission{*slot}, event.command);
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
  const RequestData& request = open->request.data;
  errand.kind = request.kind;
  errand.request = request;
  errand.number = request.number;
  errand.members = channels_.with_ids(request.channels);
  errand.seconds = request.seconds;
  errand.tag = open->tag;
  errand.text = open->request.text;
  errand.target = channels_.index_of(request.channel);
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
  using lang::RequestKind;
  if (errand.homes) return channel_errands_.home(errand);
  if (ValueDesk::serves(errand.kind)) return values_.step(errand);
  switch (errand.kind) {
    case RequestKind::sync:
    // The interpreter ends the run with the alarm U<code> once it has this answer.
    case RequestKind::terminate:
      return success();
    case RequestKind::program_restart:
      // Endless on a machine; a simulation ends behind it.
      return channels_[errand.asker].begins_again() ? success()
                                                    : refusal("W2099", "M99 in the main program");
    case RequestKind::spindle_to_axis:
      return channel_errands_.spindle_to_axis(errand);
    case RequestKind::axis_to_spindle:
      channels_[errand.asker].spindles.open_position_loop(errand.number);
      return success();
    case RequestKind::mark_wait:
      return waits_.wait_at_mark(errand);
    default:
      return errand.target < 0 ? refusal("E6001", "there is no such channel")
                               : step_on_target(errand);
  }
}

Verdict Coordinator::step_on_target(Errand& errand) RT_SAFE {
  using lang::RequestKind;
  const Channel& target = channels_[errand.target];
  switch (errand.kind) {
    case RequestKind::kinematics:
      return channel_errands_.change_kinematics(errand);
    case RequestKind::channel_load:
      return channel_errands_.load(errand);
    case RequestKind::channel_start:
      return channel_errands_.start(errand);
    case RequestKind::channel_run:
      return channel_errands_.run(errand);
    case RequestKind::channel_wait:
      return waits_.wait_for_end(errand, target);
    case RequestKind::channel_stop:
      return channel_errands_.stop(errand);
    case RequestKind::channel_reset:
      return channel_errands_.reset(errand);
    case RequestKind::channel_state:
      return success(static_cast<double>(target.state().shown()));
    case RequestKind::mark_state:
      return success(target.marks.is_set(errand.number) ? 1.0 : 0.0);
    default:
      return refusal("E2090", "not supported in this release");
  }
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
  static_cast<void>((is_of_stop ? replies_.stops : replies_.usual).push(answer));
}

bool Coordinator::is_quiet() const RT_SAFE {
  return std::none_of(errands_.begin(), errands_.end(),
                      [](const Errand& errand) RT_SAFE { return errand.active; });
}

}  // namespace stanok::channels
