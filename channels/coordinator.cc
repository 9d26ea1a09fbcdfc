#include "channels/coordinator.h"

#include <algorithm>

namespace stanok::channels {
namespace {

// A drive needs several polls of the bus from switch-on to holding its axis.
constexpr double drives_ready_within_s = 3.0;

lang::RequestKind errand_of(OperatorAction action) RT_SAFE {
  switch (action) {
    case OperatorAction::program_load:
      return lang::RequestKind::channel_load;
    case OperatorAction::program_run:
      return lang::RequestKind::channel_run;
    case OperatorAction::program_start:
      return lang::RequestKind::channel_start;
    case OperatorAction::kinematics_select:
      return lang::RequestKind::kinematics;
    default:
      return lang::RequestKind::channel_reset;
  }
}

bool is_busy(const Channel& channel) RT_SAFE {
  return channel.state() == ChannelState::running || channel.state() == ChannelState::held;
}

}  // namespace

Coordinator::Coordinator(std::span<Channel* const> channels,
                         const std::array<OwnerFailure, channels_max>& on_owner_failure,
                         double cycle_s, Ring<OperatorReply>& replies)
    : channel_count_(static_cast<int>(channels.size())),
      on_owner_failure_(on_owner_failure),
      cycle_s_(cycle_s),
      replies_(replies) {
  std::copy(channels.begin(), channels.end(), channels_.begin());
  owner_.fill(operator_asker);
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
  verdict.text = ShortText(text);
  return verdict;
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
  if (const auto verdict = apply_at_once(event, channel)) return reply(event.id, *verdict);
  if (channel == nullptr) return reply(event.id, refusal("E6001", "a channel must be named"));
  const auto slot = std::find_if(errands_.begin() + channels_max, errands_.end(),
                                 [](const Errand& errand) RT_SAFE { return !errand.active; });
  if (slot == errands_.end()) return reply(event.id, refusal("E6002", "too many commands at once"));
  *slot = {};
  slot->active = true;
  slot->reply_id = event.id;
  slot->kind = errand_of(event.action);
  slot->target = index;
  slot->number = event.number;
  slot->text = event.text;
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
        c.begin_reset();
        c.power_off_at_rest();
      });
    case OperatorAction::machine_estop:
      return each([](Channel& c) RT_SAFE { c.fault("A1001", "emergency stop by an operator"); });
    case OperatorAction::program_hold:
      return each([](Channel& c) RT_SAFE { c.hold(); });
    case OperatorAction::program_resume:
      return each([](Channel& c) RT_SAFE { c.resume(); });
    case OperatorAction::override_feed:
    case OperatorAction::override_rapid:
    case OperatorAction::override_spindle:
      return each([&](Channel& c) RT_SAFE { set_overrides(event, c); });
    case OperatorAction::alarm_acknowledge:
      return success();
    default:
      return std::nullopt;
  }
}

Coordinator::Verdict Coordinator::switch_on(Channel* channel) RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    const Channel& candidate = *channels_[static_cast<std::size_t>(k)];
    if (channel != nullptr && channel != &candidate) continue;
    if (!candidate.drives_answer()) return refusal("A3001", "a drive does not answer");
    if (candidate.state() == ChannelState::alarm) {
      return refusal("E6004", "a channel has an alarm; reset it first");
    }
  }
  for (int k = 0; k < channel_count_; ++k) {
    Channel& candidate = *channels_[static_cast<std::size_t>(k)];
    if (channel == nullptr || channel == &candidate) candidate.power(true);
  }
  return success();
}

void Coordinator::set_overrides(const OperatorEvent& event, Channel& channel) RT_SAFE {
  if (event.action == OperatorAction::override_feed)
    channel.set_feed_override(std::clamp(event.value, 0.0, 2.0));
  if (event.action == OperatorAction::override_rapid)
    channel.set_rapid_override(std::clamp(event.value, 0.0, 1.0));
  if (event.action == OperatorAction::override_spindle)
    channel.set_spindle_override(std::clamp(event.value, 0.5, 1.5));
}

void Coordinator::step() RT_SAFE {
  adopt_requests();
  for (Errand& errand : errands_) {
    if (!errand.active) continue;
    const Verdict verdict = step(errand);
    ++errand.cycles;
    if (verdict.done) conclude(errand, verdict);
  }
  follow_owners();
}

void Coordinator::adopt_requests() RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Item* item = channels_[i]->request();
    Errand& errand = errands_[i];
    if (item == nullptr) {
      errand.active = false;
      continue;
    }
    if (errand.active) continue;
    errand = {};
    errand.active = true;
    errand.asker = k;
    errand.kind = item->request.kind;
    errand.number = item->request.number;
    errand.seconds = item->request.seconds;
    errand.tag = item->tag;
    errand.text = item->text;
    static_cast<void>(channel_with_id(item->request.channel, errand.target));
  }
}

void Coordinator::conclude(Errand& errand, const Verdict& verdict) RT_SAFE {
  errand.active = false;
  if (errand.asker == operator_asker) return reply(errand.reply_id, verdict);
  channels_[static_cast<std::size_t>(errand.asker)]->answer(verdict.ok, verdict.number,
                                                            verdict.code, verdict.text);
}

void Coordinator::reply(std::uint64_t id, const Verdict& verdict) RT_SAFE {
  if (id == 0) return;
  OperatorReply answer;
  answer.id = id;
  answer.ok = verdict.ok;
  answer.code = verdict.code;
  answer.text = FixedText<240>(verdict.text.view());
  static_cast<void>(replies_.push(answer));
}

Coordinator::Verdict Coordinator::step(Errand& errand) RT_SAFE {
  using lang::RequestKind;
  if (errand.kind == RequestKind::sync) return success();
  if (errand.kind == RequestKind::terminate) return step_terminate(errand);
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
      return success(static_cast<double>(target.state()));
    default:
      return refusal("E2090", "not supported in this release");
  }
}

Coordinator::Verdict Coordinator::step_load(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    if (is_busy(target) || target.is_resetting())
      return refusal("E6003", "the channel is running or held");
    if (target.state() == ChannelState::alarm)
      return refusal("E6004", "the channel has an alarm; reset it first");
    target.begin_load(errand.text);
    errand.stage = 1;
    return pending();
  }
  if (target.load_outcome() == Outcome::pending) return pending();
  if (target.load_outcome() == Outcome::failed) return refusal("", target.last_text().view());
  return success();
}

Coordinator::Verdict Coordinator::step_start(Errand& errand, Channel& target) RT_SAFE {
  if (target.state() == ChannelState::held) {
    target.resume();
    return success();
  }
  if (target.state() == ChannelState::running)
    return refusal("E6003", "the channel is already running");
  if (target.state() == ChannelState::alarm)
    return refusal("E6004", "the channel has an alarm; reset it first");
  if (!target.has_program()) return refusal("E6005", "no program is loaded");
  if (!target.is_powered()) return refusal("E6006", "the machine is off");
  if (!target.drives_ready()) {
    const double waited = static_cast<double>(errand.cycles) * cycle_s_;
    return waited < drives_ready_within_s ? pending()
                                          : refusal("E6008", "the drives are not ready");
  }
  if (!target.is_quiet()) return pending();
  target.begin_run();
  owner_[static_cast<std::size_t>(errand.target)] = errand.asker;
  return success();
}

Coordinator::Verdict Coordinator::step_run(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage < 2) {
    const Verdict loaded = step_load(errand, target);
    if (!loaded.done || !loaded.ok) return loaded;
    errand.stage = 2;
  }
  return step_start(errand, target);
}

Coordinator::Verdict Coordinator::step_wait(Errand& errand, const Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    if (waits_on(errand.target, errand.asker))
      return refusal("E6020", "channels would wait for each other for ever");
    errand.awaited_run = target.run();
    errand.stage = 1;
  }
  if (target.has_ended(errand.awaited_run)) {
    if (target.run() == 0 || target.ended_well()) return success();
    return refusal("E6010", "the awaited program ended abnormally");
  }
  if (errand.seconds >= 0.0 && static_cast<double>(errand.cycles) * cycle_s_ >= errand.seconds) {
    return refusal("E6010", "the time given for waiting is over");
  }
  return pending();
}

Coordinator::Verdict Coordinator::step_stop(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    if (!is_busy(target)) return refusal("E6007", "nothing was running");
    target.hold();
    errand.stage = 1;
  }
  if (!is_busy(target)) return success();
  return target.is_standing() ? success() : pending();
}

Coordinator::Verdict Coordinator::step_reset(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    target.begin_reset();
    errand.stage = 1;
    return pending();
  }
  return target.is_resetting() ? pending() : success();
}

Coordinator::Verdict Coordinator::step_kinematics(Errand& errand, Channel& target) RT_SAFE {
  if (errand.stage == 0) {
    const bool own = errand.asker == errand.target;
    if (!target.has_scheme(errand.number))
      return refusal("E5201", "the channel has no such kinematic scheme");
    if (!own && is_busy(target))
      return refusal("E5202", "the channel whose kinematics shall change is running or held");
    if (target.state() == ChannelState::alarm)
      return refusal("E6004", "the channel has an alarm; reset it first");
    if (!target.is_powered()) return refusal("E6006", "the machine is off");
    if (!own && !target.is_quiet()) return pending();
    target.begin_switch(errand.number);
    errand.stage = 1;
    return pending();
  }
  if (target.switch_outcome() == Outcome::pending) return pending();
  if (target.switch_outcome() == Outcome::failed)
    return refusal("E5204", target.last_text().view());
  return success();
}

// The interpreter ends the run with the alarm U<code> once it has this answer.
Coordinator::Verdict Coordinator::step_terminate(const Errand& errand) RT_SAFE {
  static_cast<void>(errand);
  return success();
}

// Whether channel `waiter` waits, over any number of channels, for channel `awaited`.
bool Coordinator::waits_on(int waiter, int awaited) const RT_SAFE {
  for (int hops = 0; hops < channel_count_ && waiter >= 0; ++hops) {
    if (waiter == awaited) return true;
    const Errand& errand = errands_[static_cast<std::size_t>(waiter)];
    if (!errand.active || errand.kind != lang::RequestKind::channel_wait) return false;
    waiter = errand.target;
  }
  return waiter == awaited;
}

// A program that ends abnormally takes the runs that it started along, as configured.
void Coordinator::follow_owners() RT_SAFE {
  for (int k = 0; k < channel_count_; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const int owner = owner_[i];
    if (owner < 0) continue;
    const Channel& master = *channels_[static_cast<std::size_t>(owner)];
    if (is_busy(master) && !master.is_resetting()) continue;
    owner_[i] = operator_asker;
    if (master.ended_well() || !is_busy(*channels_[i])) continue;
    if (on_owner_failure_[i] == OwnerFailure::hold) channels_[i]->hold();
    if (on_owner_failure_[i] == OwnerFailure::reset) channels_[i]->begin_reset();
  }
}

bool Coordinator::is_quiet() const RT_SAFE {
  return std::none_of(errands_.begin(), errands_.end(),
                      [](const Errand& errand) RT_SAFE { return errand.active; });
}

}  // namespace stanok::channels
