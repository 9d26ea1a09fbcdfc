#include "daemon/desk/channel_control.h"

#include "channels/contract/command_rules.h"
#include "daemon/desk/dispatch.h"

namespace stanok::daemon {

using protocol::Failure;

namespace {

Failure refusal_of_control(int channel, const std::string& holder) {
  std::string text = "channel " + std::to_string(channel) + " is controlled by " + holder;
  return {protocol::FailureKind::refused, "E6080", std::move(text), channel, {}};
}

}  // namespace

std::optional<Failure> ChannelControl::take(int channel, const SessionState& session) {
  const auto [place, is_free] = holders_.try_emplace(channel, Holder{session.id, session.peer});
  if (is_free || place->second.session == session.id) return std::nullopt;
  return refusal_of_control(channel, holder(channel));
}

void ChannelControl::give_back(int channel, int session) {
  const auto held = holders_.find(channel);
  if (held != holders_.end() && held->second.session == session) holders_.erase(held);
}

void ChannelControl::forget(int session) {
  std::erase_if(holders_, [&](const auto& held) { return held.second.session == session; });
}

std::optional<Failure> ChannelControl::obstacle(channels::OperatorAction action, int channel,
                                                int session) const {
  const channels::ControlScope scope = channels::control_scope(action);
  if (scope == channels::ControlScope::nothing) return std::nullopt;
  if (scope == channels::ControlScope::all_channels) return obstacle_to_all(session);
  const int controller = session_with(channel);
  if (controller == 0 || controller == session) return std::nullopt;
  return refusal_of_control(channel, holder(channel));
}

std::optional<Failure> ChannelControl::obstacle_to_all(int session) const {
  for (const auto& [channel, held] : holders_) {
    if (held.session != session) return refusal_of_control(channel, holder(channel));
  }
  return std::nullopt;
}

int ChannelControl::session_with(int channel) const {
  const auto held = holders_.find(channel);
  return held == holders_.end() ? 0 : held->second.session;
}

std::string ChannelControl::holder(int channel) const {
  const auto held = holders_.find(channel);
  if (held == holders_.end()) return "";
  return "session " + std::to_string(held->second.session) + " (" + held->second.peer + ")";
}

}  // namespace stanok::daemon
