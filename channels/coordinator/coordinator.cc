#include "channels/coordinator/coordinator.h"

#include <algorithm>

#include "channels/contract/operator_action.h"

namespace stanok::channels {
namespace {

lang::RequestKind errand_of(OperatorAction action) RT_SAFE {
  switch (action) {
    case OperatorAction::program_load:
    case OperatorAction::program_search:
      return lang::RequestKind::channel_load;
    case OperatorAction::program_run:
    case OperatorAction::mdi:
      return lang::RequestKind::channel_run;
    case OperatorAction::program_start:
      return lang::RequestKind::channel_start;
    case OperatorAction::kinematics_select:
      return lang::RequestKind::kinematics;
    default:
      return lang::RequestKind::channel_reset;
  }
}

Job job_of(OperatorAction action) RT_SAFE {
  if (action == OperatorAction::mdi) return Job::line;
  return action == OperatorAction::program_search ? Job::search : Job::program;
}

bool is_table_request(lang::RequestKind kind) RT_SAFE {
  using lang::RequestKind;
  return kind == RequestKind::tool_table_write || kind == RequestKind::offset_table_write ||
         kind == RequestKind::tool_table_read || kind == RequestKind::offset_table_read;
}

}  // namespace

Coordinator::Coordinator(std::span<Channel* const> channels,
                         const std::array<OwnerFailure, channels_max>& on_owner_failure,
                         double cycle_s, ReplyRings replies, MachineStores stores)
    : channel_count_(static_cast<int>(channels.size())),
      ownership_(channels),
      on_owner_failure_(on_owner_failure),
      cycle_s_(cycle_s),
      replies_(replies),
      stores_(stores) {
  std::copy(channels.begin(), channels.end(), channels_.begin());
  owner_.fill(operator_asker);
}

void Coordinator::settle_owners() {
  ownership_ = AxisOwnership({channels_.data(), static_cast<std::size_t>(channel_count_)});
}

Coordinator::Verdict Coordinator::pending() RT_SAFE {
  Verdict verdict;
  verdict.done = false;
  return verdict;
}

Coordinator::Verdict Coordinator::success(double number) RT_SAFE {
  Verdict verdict;
  verdict.number = number;
  return verdict;
}

Coordinator::Verdict Coordinator::refusal(std::string_view code, std::string_view text) RT_SAFE {
  Verdict verdict;
  verdict.ok = false;
  verdict.code = FixedText<8>(code);
  verdict.text = ReasonText(text);
  return verdict;
}

Coordinator::Verdict Coordinator::refusal(std::string_view code, const Channel& channel,
                                          std::string_view claim) RT_SAFE {
  Verdict verdict = refusal(code, "channel ");
  verdict.text.append(channel.id()).append(claim);
  return verdict;
}

bool Coordinator::is_busy(const Channel& channel) RT_SAFE {
  return channel.state().shown() == ChannelState::running ||
         channel.state().shown() == ChannelState::held;
}

Channel* Coordinator::channel_with_id(int id, int& index) const RT_SAFE {
  for (index = 0; index < channel_count_; ++index) {
    Channel* channel = channels_[static_cast<std::size_t>(index)];
    if (channel->id() == id) return channel;
  }
  index = -1;
  return nullptr;
}

void Coordinator::take(const OperatorEvent& event) RT_SAFE {
  int index = -1;
  Channel* channel = channel_with_id(event.channel, index);
  if (channel == nullptr && event.channel != 0) {
    return reply(event.id, refusal("E6001", "no such channel"));
  }
  if (const auto refused = refusal_by_rule(event.action, channel)) return reply(event.id, *refused);
  if (const auto verdict = apply_at_once(event, channel)) return reply(event.id, *verdict);
  if (channel == nullptr) return reply(event.id, refusal("E6001", "a channel must be named"));
  const bool stops = is_stop(event.action);
  if (stops) begin_stop(event.action, *channel);
  const auto slot = std::find_if(errands_.begin() + channels_max, errands_.end(),
                                 [](const Errand& errand) RT_SAFE { return !errand.active; });
  if (slot == errands_.end()) {
    // A stop that has begun needs no room; only the answer does not wait for rest.
    return reply(event.id, stops ? success() : refusal("E6002", "too many commands at once"));
  }
  *slot = {};
  slot->active = true;
  slot->order = ++errands_taken_;
  slot->reply_id = event.id;
  slot->kind = errand_of(event.action);
  slot->homes = event.action == OperatorAction::home;
  slot->job = job_of(event.action);
  slot->target = index;
  slot->number = event.number;
  slot->value = event.value;
  slot->text = event.text;
  slot->generation = channel->run.generation();
  slot->controller = controller_[static_cast<std::size_t>(index)];
  slot->stage = stops ? 1 : 0;
}

// What the table of command_rules.h says of a channel, or of all of them.
std::optional<Coordinator::Verdict> Coordinator::refusal_by_rule(OperatorAction action,
                                                                 const Channel* named) const
    RT_SAFE {
  const bool asks_all = concerns_all_channels(action);
  std::string_view code;
  FixedText<64> who;
  int count = 0;
  for (int k = 0; k < channel_count_; ++k) {
    if (&channel(k) != named && (named != nullptr || !asks_all)) continue;
    const std::string_view found = refusal_code(action, channel(k).state().situation());
    if (found.empty() || (count > 0 && found != code)) continue;
    code = found;
    who.append(count++ > 0 ? ", " : "").append(channel(k).id());
  }
  if (count == 0) return std::nullopt;
  Verdict verdict = refusal(code, count > 1 ? "channels " : "channel ");
  verdict.text.append(who.view()).append(claim_of_refusal(code));
  return verdict;
}

void Coordinator::begin_stop(OperatorAction action, Channel& channel) RT_SAFE {
  action == OperatorAction::program_reset ? channel.run.begin_reset() : channel.run.begin_stop();
}

// Commands that take effect in this cycle, whatever the state. Nothing: the event is an errand.
std::optional<Coordinator::Verdict> Coordinator::apply_at_once(const OperatorEvent& event,
                                                               Channel* channel) RT_SAFE {
  const auto each = [&](auto&& effect) RT_SAFE {
    for (int k = 0; k < channel_count_; ++k) {
      Channel& candidate = *channels_[static_cast<std::size_t>(k)];
      if (channel == nullptr || channel == &candidate) effect(candidate);
    }
    return std::optional<Verdict>(success());
  };
  switch (event.action) {
    case OperatorAction::machine_on:
      return switch_on(channel);
    case OperatorAction::machine_off:
      return each([](Channel& c) RT_SAFE {
        c.run.begin_stop();
        c.run.power_off_at_rest();
      });
    case OperatorAction::machine_estop:
      return each([](Channel& c) RT_SAFE { c.run.stop_in_emergency(); });
    case OperatorAction::program_hold:
      return each([](Channel& c) RT_SAFE { c.switches.hold(); });
    case OperatorAction::program_resume:
      return each([](Channel& c) RT_SAFE { c.run.resume(); });
    case OperatorAction::override_feed:
    case OperatorAction::override_rapid:
    case OperatorAction::override_spindle:
      return each([&](Channel& c) RT_SAFE { set_overrides(event, c); });
    case OperatorAction::alarm_acknowledge:
      return success();
    case OperatorAction::optional_stop:
      return each([&](Channel& c) RT_SAFE { c.switches.set_optional_stop(event.number != 0); });
    case OperatorAction::single_block:
      return each([&](Channel& c) RT_SAFE {
        c.set_single_block(event.number != 0 ? Switch::on : Switch::off);
      });
    case OperatorAction::jog:
      return jog(event, channel);
    case OperatorAction::channel_control:
      return set_controller(event);
    case OperatorAction::tool_set:
      return set_tool(event);
    case OperatorAction::offset_set:
      return set_offset(event);
    case OperatorAction::process_interrupt:
      return interrupt_feed(event, channel);
    case OperatorAction::process_automatic:
      return switch_automatic_feed(event, channel);
    case OperatorAction::process_adaptive:
      return control_force(event, channel);
    case OperatorAction::block_skip:
    case OperatorAction::block_skip_off: {
      if (event.number < 1 || event.number > 9)
        return refusal("E6027", "levels of block skip are 1 to 9");
      const bool on = event.action == OperatorAction::block_skip;
      return each([&](Channel& c) RT_SAFE { c.switches.set_block_skip(event.number, on); });
    }
    default:
      return std::nullopt;
  }
}

Coordinator::Verdict Coordinator::switch_on(const Channel* named) RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    if (named != nullptr && named != &channel(k)) continue;
    if (!channel(k).drives.all_answer()) return refusal("A3001", "a drive does not answer");
  }
  for (int k = 0; k < channel_count_; ++k) {
    Channel& candidate = channel(k);
    if (named != nullptr && named != &candidate) continue;
    // What is under way has given drives and brakes their state.
    if (!candidate.state().is_powered() || candidate.is_quiet()) candidate.power(Power::on);
  }
  return success();
}

void Coordinator::step() RT_SAFE {
  adopt_requests();
  work_marks();
  for (Errand& errand : errands_) {
    if (!errand.active || is_asker_held(errand) || !is_its_turn(errand)) continue;
    const Verdict verdict = step(errand);
    ++errand.cycles;
    if (verdict.done) conclude(errand, verdict);
  }
  follow_owners();
}

void Coordinator::adopt_requests() RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Item* item = channels_[i]->items().request();
    Errand& errand = errands_[i];
    if (item == nullptr) {
      errand.active = false;
      continue;
    }
    if (errand.active) continue;
    errand = {};
    errand.active = true;
    errand.order = ++errands_taken_;
    errand.asker = k;
    errand.kind = item->request.kind;
    errand.request = item->request;
    errand.number = item->request.number;
    errand.members = channels_with_ids(item->request.channels);
    errand.seconds = item->request.seconds;
    errand.tag = item->tag;
    errand.text = item->text;
    const Channel* target = channel_with_id(item->request.channel, errand.target);
    if (target != nullptr) {
      errand.generation = target->run.generation();
      errand.controller = controller_[static_cast<std::size_t>(errand.target)];
    }
  }
}

// What begins something on another channel, or for an operator.
bool Coordinator::begins_something(const Errand& errand) RT_SAFE {
  using lang::RequestKind;
  if (errand.target < 0 || errand.asker == errand.target) return false;
  return errand.homes || errand.kind == RequestKind::kinematics ||
         errand.kind == RequestKind::channel_load || errand.kind == RequestKind::channel_start ||
         errand.kind == RequestKind::channel_run;
}

// One after the other: a program that is being loaded is not replaced before it has started.
bool Coordinator::is_its_turn(const Errand& errand) const RT_SAFE {
  return !begins_something(errand) ||
         std::none_of(errands_.begin(), errands_.end(), [&](const Errand& other) RT_SAFE {
           return other.active && other.target == errand.target && other.order < errand.order &&
                  begins_something(other) && !is_asker_held(other);
         });
}

// Why what was asked for may not begin now: what the channel does, a stop since it was asked, or
// somebody who has the channel to himself.
std::optional<Coordinator::Verdict> Coordinator::obstacle(const Errand& errand,
                                                          OperatorAction action,
                                                          const Channel& target) const RT_SAFE {
  if (errand.asker == errand.target) return std::nullopt;
  const std::string_view code = refusal_code(action, target.state().situation());
  if (!code.empty()) return refusal(code, target, claim_of_refusal(code));
  if (errand.generation != target.run.generation())
    return refusal("E6072", target, " was stopped before it began");
  if (!is_under_control_of_others(errand)) return std::nullopt;
  return refusal("E6080", target, " is under control of another operator");
}

// Stop of a channel holds its wait.
bool Coordinator::is_asker_held(const Errand& errand) const RT_SAFE {
  return errand.asker != operator_asker &&
         channels_[static_cast<std::size_t>(errand.asker)]->state().shown() == ChannelState::held;
}

// Bit k of `ids` stands for the channel with id k.
ChannelSet Coordinator::channels_with_ids(std::uint32_t ids) const RT_SAFE {
  ChannelSet set = 0;
  for (int k = 0; k < channel_count_; ++k) {
    if ((ids >> channels_[static_cast<std::size_t>(k)]->id() & 1U) != 0) set |= channel_bit(k);
  }
  return set;
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
  channels_[static_cast<std::size_t>(errand.asker)]->items().answer(answer);
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

Coordinator::Verdict Coordinator::step(Errand& errand) RT_SAFE {
  using lang::RequestKind;
  if (errand.homes) return step_home(errand, channel(errand.target));
  if (errand.kind == RequestKind::sync) return success();
  // The interpreter ends the run with the alarm U<code> once it has this answer.
  if (errand.kind == RequestKind::terminate) return success();
  if (errand.kind == RequestKind::program_restart)
    return step_restart(*channels_[static_cast<std::size_t>(errand.asker)]);
  if (errand.kind == RequestKind::spindle_to_axis)
    return step_spindle_to_axis(errand, channel(errand.asker));
  if (errand.kind == RequestKind::axis_to_spindle) {
    channel(errand.asker).spindles.open_position_loop(errand.number);
    return success();
  }
  if (errand.kind == RequestKind::mark_wait) return step_mark_wait(errand);
  if (errand.kind == RequestKind::shared_read || errand.kind == RequestKind::shared_write)
    return step_shared(errand);
  if (errand.kind == RequestKind::shared_combine) return combine_shared(errand);
  if (is_table_request(errand.kind)) return step_table(errand);
  if (errand.kind == RequestKind::machine_value) return step_value(errand);
  if (errand.kind == RequestKind::input_wait) return step_input_wait(errand);
  if (errand.target < 0) return refusal("E6001", "no such channel");
  Channel& target = *channels_[static_cast<std::size_t>(errand.target)];
  switch (errand.kind) {
    case RequestKind::kinematics:
      return step_kinematics(errand, target);
    case RequestKind::channel_load:
      return step_load(errand, target);
    case RequestKind::channel_start:
      return step_start(errand, target);
    case RequestKind::channel_run:
      return step_run(errand, target);
    case RequestKind::channel_wait:
      return step_wait(errand, target);
    case RequestKind::channel_stop:
      return step_stop(errand, target);
    case RequestKind::channel_reset:
      return step_reset(errand, target);
    case RequestKind::channel_state:
      return success(static_cast<double>(target.state().shown()));
    case RequestKind::mark_state:
      return success(target.marks.is_set(errand.number) ? 1.0 : 0.0);
    default:
      return refusal("E2090", "not supported in this release");
  }
}

// A program that ends abnormally takes the runs that it started along, as configured.
void Coordinator::follow_owners() RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const int owner = owner_[i];
    if (owner < 0) continue;
    const Channel& master = *channels_[static_cast<std::size_t>(owner)];
    const std::uint32_t run = owner_run_[i];
    if (!master.has_ended(run) && !master.state().is_ending()) continue;
    owner_[i] = operator_asker;
    if (master.runs.ended_well(run) || !is_busy(*channels_[i])) continue;
    if (on_owner_failure_[i] == OwnerFailure::hold) channels_[i]->run.hold(HoldCause::owner_failed);
    if (on_owner_failure_[i] == OwnerFailure::reset) channels_[i]->run.begin_reset();
  }
}

bool Coordinator::is_quiet() const RT_SAFE {
  return std::none_of(errands_.begin(), errands_.end(),
                      [](const Errand& errand) RT_SAFE { return errand.active; });
}

}  // namespace stanok::channels
