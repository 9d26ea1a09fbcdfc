#include "channels/coordinator.h"

#include <algorithm>

namespace stanok::channels {
namespace {

lang::RequestKind errand_of(OperatorAction action) RT_SAFE {
  switch (action) {
    case OperatorAction::program_load:
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

constexpr double interruption_mm_min = 0.001;  // L_B

bool is_table_request(lang::RequestKind kind) RT_SAFE {
  using lang::RequestKind;
  return kind == RequestKind::tool_table_write || kind == RequestKind::offset_table_write ||
         kind == RequestKind::tool_table_read || kind == RequestKind::offset_table_read;
}

}  // namespace

Coordinator::Coordinator(std::span<Channel* const> channels,
                         const std::array<OwnerFailure, channels_max>& on_owner_failure,
                         double cycle_s, Ring<OperatorReply>& replies, MachineStores stores)
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
  return channel.state() == ChannelState::running || channel.state() == ChannelState::held;
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
  slot->homes = event.action == OperatorAction::home;
  slot->job = event.action == OperatorAction::mdi ? Job::line : Job::program;
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
      return each([](Channel& c) RT_SAFE { c.hold_by_operator(); });
    case OperatorAction::program_resume:
      return each([](Channel& c) RT_SAFE { c.resume(); });
    case OperatorAction::override_feed:
    case OperatorAction::override_rapid:
    case OperatorAction::override_spindle:
      return each([&](Channel& c) RT_SAFE { set_overrides(event, c); });
    case OperatorAction::alarm_acknowledge:
      return success();
    case OperatorAction::optional_stop:
      return each([&](Channel& c) RT_SAFE { c.set_optional_stop(event.number != 0); });
    case OperatorAction::single_block:
      return each([&](Channel& c) RT_SAFE { c.set_single_block(event.number != 0); });
    case OperatorAction::jog:
      return jog(event, channel);
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
      return each([&](Channel& c) RT_SAFE { c.set_block_skip(event.number, on); });
    }
    default:
      return std::nullopt;
  }
}

Coordinator::Verdict Coordinator::switch_on(Channel* channel) RT_SAFE {
  FixedText<64> waiting;
  int alarms = 0;
  for (int k = 0; k < channel_count_; ++k) {
    const Channel& candidate = *channels_[static_cast<std::size_t>(k)];
    if (channel != nullptr && channel != &candidate) continue;
    if (!candidate.drives_answer()) return refusal("A3001", "a drive does not answer");
    if (candidate.state() == ChannelState::alarm) {
      ++alarms;
      waiting.append(alarms > 1 ? ", " : "").append(candidate.id());
    }
  }
  if (alarms > 0) {
    Verdict verdict = refusal("E6004", alarms > 1 ? "channels " : "channel ");
    verdict.text.append(waiting.view()).append(" must be reset first: ");
    verdict.text.append(alarms > 1 ? "they have alarms" : "it has an alarm");
    return verdict;
  }
  for (int k = 0; k < channel_count_; ++k) {
    Channel& candidate = *channels_[static_cast<std::size_t>(k)];
    if (channel == nullptr || channel == &candidate) candidate.power(true);
  }
  return success();
}

// For the program at hand, or the next one: an operator interrupts what he sees.
Coordinator::Verdict Coordinator::interrupt_feed(const OperatorEvent& event, Channel* channel)
    RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  if (channel->axis_count() == 0) return refusal("E6029", "the channel has no axes");
  if (!(event.value >= 0.0) || (event.value > 0.0 && !(event.value_2 >= interruption_mm_min)))
    return refusal("E6029",
                   "an interruption of the feed needs L_A > 0 and L_B of 0.001 mm or more");
  channel->interrupt_feed({.stand_mm = event.value, .cut_mm = event.value_2});
  return success();
}

Coordinator::Verdict Coordinator::switch_automatic_feed(const OperatorEvent& event,
                                                        Channel* channel) RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  const auto law =
      event.text.view() == "linear" ? motion::LawKind::linear : motion::LawKind::modulated;
  if (channel->switch_automatic_feed(law, event.number != 0)) return success();
  return refusal("E6030", "the machine file gives the channel no such automatic feed law");
}

Coordinator::Verdict Coordinator::control_force(const OperatorEvent& event, Channel* channel)
    RT_SAFE {
  if (channel == nullptr) return refusal("E6001", "a channel must be named");
  if (!channel->has_force_control())
    return refusal("E6060", "the machine file gives the channel no force control");
  const std::string_view quantity = event.text.view();
  const bool is_force = quantity.empty() || quantity == "force";
  motion::ForceOrder order;
  switch (static_cast<ForceAction>(event.number)) {
    case ForceAction::off:
      break;
    case ForceAction::on:
      if (!is_force) return refusal("E6061", "force control is switched on with a force");
      order.kind = motion::ForceOrder::Kind::force;
      order.force_n = event.value;
      break;
    case ForceAction::set:
      if (quantity.empty() || !(event.value > 0.0))
        return refusal("E6061", "a quantity is set to a value above 0");
      order.kind = motion::ForceOrder::Kind::adjust;
      if (is_force) order.force_n = event.value;
      if (quantity == "level") order.level_um = event.value;
      if (quantity == "mass") order.reduced_mass_kg = event.value;
      if (quantity == "frequency") order.oscillation_hz = event.value;
      break;
  }
  if (channel->order_force(order)) return success();
  return refusal("E6062", "no force was ordered yet: process adaptive on force N");
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
  work_marks();
  for (Errand& errand : errands_) {
    if (!errand.active || is_asker_held(errand)) continue;
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
    errand.request = item->request;
    errand.number = item->request.number;
    errand.members = channels_with_ids(item->request.channels);
    errand.seconds = item->request.seconds;
    errand.tag = item->tag;
    errand.text = item->text;
    static_cast<void>(channel_with_id(item->request.channel, errand.target));
  }
}

// Stop of a channel holds its wait.
bool Coordinator::is_asker_held(const Errand& errand) const RT_SAFE {
  return errand.asker != operator_asker &&
         channels_[static_cast<std::size_t>(errand.asker)]->state() == ChannelState::held;
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
  channels_[static_cast<std::size_t>(errand.asker)]->answer(answer);
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
  if (errand.homes) return step_home(errand, channel(errand.target));
  if (errand.kind == RequestKind::sync) return success();
  // The interpreter ends the run with the alarm U<code> once it has this answer.
  if (errand.kind == RequestKind::terminate) return success();
  if (errand.kind == RequestKind::program_restart)
    return step_restart(*channels_[static_cast<std::size_t>(errand.asker)]);
  if (errand.kind == RequestKind::spindle_to_axis)
    return step_spindle_to_axis(errand, channel(errand.asker));
  if (errand.kind == RequestKind::axis_to_spindle) {
    channel(errand.asker).open_position_loop(errand.number);
    return success();
  }
  if (errand.kind == RequestKind::mark_wait) return step_mark_wait(errand);
  if (errand.kind == RequestKind::shared_read || errand.kind == RequestKind::shared_write)
    return step_shared(errand);
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
      return success(static_cast<double>(target.state()));
    case RequestKind::mark_state:
      return success(target.is_mark_set(errand.number) ? 1.0 : 0.0);
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
    if (!master.has_ended(run) && !master.is_resetting()) continue;
    owner_[i] = operator_asker;
    if (master.ended_well(run) || !is_busy(*channels_[i])) continue;
    if (on_owner_failure_[i] == OwnerFailure::hold) channels_[i]->hold(HoldCause::owner_failed);
    if (on_owner_failure_[i] == OwnerFailure::reset) channels_[i]->begin_reset();
  }
}

bool Coordinator::is_quiet() const RT_SAFE {
  return std::none_of(errands_.begin(), errands_.end(),
                      [](const Errand& errand) RT_SAFE { return errand.active; });
}

}  // namespace stanok::channels
