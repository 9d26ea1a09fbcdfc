#include "channels/coordinator/request_gate.h"

#include <algorithm>
#include <cmath>

#include "channels/contract/operator_action.h"
#include "channels/cycle/channel.h"

namespace stanok::channels {
namespace {

const commands::Jog* leased_jog(const OperatorEvent& event) RT_SAFE {
  const auto* jog = std::get_if<commands::Jog>(&event.command);
  return jog != nullptr && jog->increment == 0.0 ? jog : nullptr;
}

const commands::ProgramRetrace* leased_retrace(const OperatorEvent& event) RT_SAFE {
  const auto* retrace = std::get_if<commands::ProgramRetrace>(&event.command);
  return retrace != nullptr && retrace->length == 0.0 ? retrace : nullptr;
}

// What moves as long as it is asked for again.
bool is_lease(const OperatorEvent& event) RT_SAFE {
  return leased_jog(event) != nullptr || leased_retrace(event) != nullptr;
}

bool is_under_lease(const Channel& channel) RT_SAFE {
  return channel.motion.manual().is_jogging() || channel.motion.retracing().is_leased();
}

bool is_renewal(const OperatorEvent& event, const Channel* named) RT_SAFE {
  if (named == nullptr) return false;
  if (const auto* retrace = leased_retrace(event))
    return named->motion.retracing().is_renewed_by(retrace->direction);
  const commands::Jog* const jog = leased_jog(event);
  if (jog == nullptr) return false;
  const ManualMotion& manual = named->motion.manual();
  if (jog->frame != JogFrame::machine) return manual.jogs_along_line();
  return manual.jogs(named->axes.named(jog->axis.view()));
}

// An override that lets a path go on, or go faster.
bool raises_override(const OperatorEvent& event, const Channel& channel) RT_SAFE {
  if (const auto* feed = std::get_if<commands::OverrideFeed>(&event.command))
    return feed->factor > channel.switches.feed_override();
  if (const auto* rapid = std::get_if<commands::OverrideRapid>(&event.command))
    return rapid->factor > channel.switches.rapid_override();
  if (const auto* part = std::get_if<commands::FirstPart>(&event.command))
    return part->to == Switch::off && channel.switches.first_part() == Switch::on;
  return false;
}

bool lets_move(const OperatorEvent& event, const Channel* named) RT_SAFE {
  return begins_motion(event.action()) || (named != nullptr && raises_override(event, *named));
}

}  // namespace

RequestGate::RequestGate(double cycle_s, double age_max_s)
    : cycle_s_(cycle_s), cycles_max_(std::llround(age_max_s / cycle_s)) {}

void RequestGate::note_gap(std::int64_t cycle, std::int64_t periods) RT_SAFE {
  if (periods <= 0) return;
  const std::int64_t lost = losses_[newest_].lost + periods;
  newest_ = (newest_ + 1) % losses_kept;
  losses_[newest_] = {cycle, lost};
}

std::optional<Verdict> RequestGate::refusal_of(const OperatorEvent& event, std::int64_t cycle,
                                               const Channel* named, int index) const RT_SAFE {
  const bool renews = is_renewal(event, named);
  if (is_lease(event) && named != nullptr && is_under_lease(*named) &&
      jogger_[index] != event.session)
    return refusal("E6056", "another session jogs this channel");
  if (renews || !lets_move(event, named)) return std::nullopt;
  const std::int64_t age = age_of(event, cycle);
  if (age <= cycles_max_) return std::nullopt;
  Verdict verdict = refusal("E6073", "");
  const auto tenths = std::llround(10.0 * static_cast<double>(age) * cycle_s_);
  verdict.text.append("the sender of the command last saw the state of the machine ")
      .append(static_cast<long>(tenths / 10))
      .append(".")
      .append(static_cast<long>(tenths % 10))
      .append(" s ago");
  return verdict;
}

void RequestGate::note(const OperatorEvent& event, int index) RT_SAFE {
  if (index >= 0 && is_lease(event)) jogger_[index] = event.session;
}

// In periods; 0 where it has none. Gaps before the oldest that is known are not counted.
std::int64_t RequestGate::age_of(const OperatorEvent& event, std::int64_t cycle) const RT_SAFE {
  if (event.seen_cycle < 0) return 0;
  std::int64_t lost_by_then = losses_[(newest_ + 1) % losses_kept].lost;
  for (const Loss& loss : losses_)
    if (loss.cycle <= event.seen_cycle) lost_by_then = std::max(lost_by_then, loss.lost);
  return cycle - event.seen_cycle + losses_[newest_].lost - lost_by_then;
}

}  // namespace stanok::channels
