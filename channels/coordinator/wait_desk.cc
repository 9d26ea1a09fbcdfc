#include "channels/coordinator/wait_desk.h"

namespace stanok::channels {
namespace {

// "flange.nc:118"
void append_place(const FileName& file, std::uint32_t line, ReasonText& text) RT_SAFE {
  text.append(" (").append(file.view()).append(":").append(line).append(")");
}

}  // namespace

Verdict WaitDesk::wait_for_end(Errand& errand, double seconds, const Channel& target) const
    RT_SAFE {
  if (errand.is<errand_states::Asked>()) {
    if (!target.state().is_running() && target.runs.was_reset()) return success();
    errand.state = ErrandState(errand_states::AwaitingEnd{target.runs.run()});
    if (errand.asker != operator_asker && target.state().is_running()) {
      if (const auto verdict = deadlock(errand.asker)) return *verdict;
    }
  }
  const std::uint32_t run = std::get_if<errand_states::AwaitingEnd>(&errand.state)->run;
  if (target.has_ended(run)) {
    if (run == 0 || target.runs.ended_well(run)) return success();
    const ChannelAlarm& alarm = target.log.last_alarm();
    if (alarm.run != run) return refusal_of(target.id(), "E6010", " was reset");
    Verdict verdict = refusal_of(target.id(), "E6010", " ended with alarm ");
    verdict.text.append(alarm.code.view());
    append_place(alarm.file, alarm.line, verdict.text);
    return verdict;
  }
  if (seconds >= 0.0 && static_cast<double>(errand.cycles) * cycle_s_ >= seconds) {
    return refusal_of(target.id(), "E6010", " has not ended within the given time");
  }
  return pending();
}

Verdict WaitDesk::wait_at_mark(const Errand& errand) const RT_SAFE {
  const Rendezvous::Arrival& arrival = rendezvous_.at(errand.asker);
  if (arrival.met) return success();
  return lost_partner(errand.asker).value_or(pending());
}

bool WaitDesk::comes_to_mark(int index) RT_SAFE {
  const Errand& errand = errand_of(index);
  const bool waits = errand.active && std::holds_alternative<requests::MarkWait>(errand.request);
  if (!waits && !channels_[index].marks.is_waiting()) rendezvous_.leave(index);
  return waits && errand.is<errand_states::Asked>();
}

std::optional<Verdict> WaitDesk::arrive_at_mark(int index) RT_SAFE {
  Errand& errand = errand_of(index);
  const auto& mark = *std::get_if<requests::MarkWait>(&errand.request);
  errand.state = ErrandState(errand_states::AtMark{});
  rendezvous_.arrive(index, mark.mark, channels_.with_ids(mark.channels), errand.tag);
  const auto fault = fault_of_arrival(index);
  if (fault) rendezvous_.leave(index);
  return fault;
}

void WaitDesk::meet() RT_SAFE {
  rendezvous_.meet();
  for (int k = 0; k < channels_.count(); ++k) work_soft_mark(k);
}

// A channel is at a soft mark when it stands there, or in the cycle in which it passes it.
void WaitDesk::arrive_at_soft_mark(int index) RT_SAFE {
  Channel& arriving = channels_[index];
  const Rider* passed = arriving.marks.passed_mark();
  if ((released_ & channel_bit(index)) != 0) {
    if (passed != nullptr || !arriving.marks.is_waiting()) released_ &= ~channel_bit(index);
    return;
  }
  const Rider* rider = passed != nullptr             ? passed
                       : arriving.marks.is_waiting() ? arriving.marks.soft_mark()
                                                     : nullptr;
  if (rider == nullptr || rendezvous_.at(index).present) return;
  const auto& mark = *std::get_if<riders::SoftMark>(&rider->content);
  rendezvous_.arrive(index, mark.mark, channels_.with_ids(mark.channels), rider->tag);
  if (passed != nullptr) return;
  const auto fault = fault_of_arrival(index);
  if (!fault) return;
  rendezvous_.leave(index);
  arriving.run.fail(fault->code.view(), fault->text.view(), rider->tag);
}

// After all arrivals of the cycle: opens soft marks whose partners are there.
void WaitDesk::work_soft_mark(int index) RT_SAFE {
  Channel& coming = channels_[index];
  const Rendezvous::Arrival arrival = rendezvous_.at(index);
  if (coming.marks.passed_mark() != nullptr && arrival.present) {
    if (!arrival.met) {
      coming.run.fail("E6021", "a partner left the mark while the channel was on its way to it",
                      arrival.tag);
    }
    return rendezvous_.leave(index);
  }
  const Rider* rider = coming.marks.soft_mark();
  if (rider == nullptr || (released_ & channel_bit(index)) != 0) return;
  if (!coming.marks.is_waiting()) {
    const auto& mark = *std::get_if<riders::SoftMark>(&rider->content);
    const ChannelSet members = channels_.with_ids(mark.channels);
    if (rendezvous_.missing(index, mark.mark, members) == 0) coming.marks.open();
    return;
  }
  if (arrival.met) {
    rendezvous_.leave(index);
    released_ |= channel_bit(index);
    coming.marks.open();
  } else if (arrival.present) {
    if (const auto lost = lost_partner(index)) {
      rendezvous_.leave(index);
      coming.run.fail(lost->code.view(), lost->text.view(), arrival.tag);
    }
  }
}

std::optional<Verdict> WaitDesk::fault_of_arrival(int index) const RT_SAFE {
  const int other = rendezvous_.mismatch(index);
  if (other < 0) return deadlock(index);
  const Rendezvous::Arrival& theirs = rendezvous_.at(other);
  Verdict verdict = refusal_of(channels_[other].id(), "E6022", " waits at mark ");
  verdict.raises = true;
  verdict.text.append(theirs.mark).append(" with other partners");
  append_place(channels_[other].log.file_name(theirs.tag), theirs.tag.line, verdict.text);
  return verdict;
}

// A partner whose program was over after this one began will not come any more.
std::optional<Verdict> WaitDesk::lost_partner(int index) const RT_SAFE {
  const Rendezvous::Arrival& arrival = rendezvous_.at(index);
  const ChannelSet missing = rendezvous_.missing(index, arrival.mark, arrival.members);
  for (int k = 0; k < channels_.count(); ++k) {
    const Channel& partner = channels_[k];
    if ((missing & channel_bit(k)) == 0 || partner.state().is_running()) continue;
    const bool has_ended =
        partner.runs.run() > 0 && partner.runs.end_cycle() >= channels_[index].runs.start_cycle();
    if (!has_ended && partner.state().shown() != ChannelState::alarm) continue;
    Verdict verdict = refusal_of(partner.id(), "E6021", " has ended without reaching mark ");
    verdict.raises = true;
    verdict.text.append(arrival.mark);
    return verdict;
  }
  return std::nullopt;
}

// The wait that channel `index` begins closes a circle.
std::optional<Verdict> WaitDesk::deadlock(int index) const RT_SAFE {
  NumberedArray<ChannelSet, channels_max> awaited{};
  for (int k = 0; k < channels_.count(); ++k) awaited[k] = awaited_by(k);
  const Circle circle = find_circle(awaited, index);
  if (circle.length == 0) return std::nullopt;
  Verdict verdict = refusal("E6020", "the channels would wait for each other forever");
  verdict.raises = true;
  for (int k = 0; k < circle.length; ++k) {
    const int waiter = circle.channels[k];
    const int next = circle.channels[(k + 1) % circle.length];
    describe_wait(waiter, next, verdict.text);
  }
  return verdict;
}

ChannelSet WaitDesk::awaited_by(int index) const RT_SAFE {
  const Errand& errand = errand_of(index);
  if (!channels_[index].state().is_running() || channels_[index].state().is_ending()) return 0;
  const Rendezvous::Arrival& arrival = rendezvous_.at(index);
  if (arrival.present && !arrival.met)
    return rendezvous_.missing(index, arrival.mark, arrival.members);
  const auto* const waits = std::get_if<errand_states::AwaitingEnd>(&errand.state);
  if (!errand.active || waits == nullptr || channels_[errand.target].has_ended(waits->run))
    return 0;
  return channel_bit(errand.target);
}

// One line: who waits, for whom, where.
void WaitDesk::describe_wait(int index, int awaited, ReasonText& text) const RT_SAFE {
  const Rendezvous::Arrival& arrival = rendezvous_.at(index);
  const motion::BlockTag& tag = arrival.present ? arrival.tag : errand_of(index).tag;
  text.append("\nchannel ").append(channels_[index].id()).append(" waits for channel ");
  text.append(channels_[awaited].id());
  if (arrival.present) text.append(" at mark ").append(arrival.mark);
  append_place(channels_[index].log.file_name(tag), tag.line, text);
}

bool WaitDesk::is_waiting_for_channels(int index) const RT_SAFE {
  if (channels_[index].marks.is_waiting()) return rendezvous_.at(index).present;
  const Errand& errand = errand_of(index);
  if (!errand.active || errand.is<errand_states::Asked>()) return false;
  if (errand.is<errand_states::AtMark>()) return !rendezvous_.at(index).met;
  const auto* const wait = std::get_if<requests::EndWait>(&errand.request);
  return wait != nullptr && wait->seconds < 0.0;
}

}  // namespace stanok::channels
