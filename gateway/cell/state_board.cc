#include "gateway/cell/state_board.h"

#include "gateway/outbox/wall_clock.h"
#include "protocol/contract/json_text.h"

namespace stanok::gateway {

void StateBoard::set(const std::string& topic, nlohmann::json content) {
  const std::lock_guard lock(mutex_);
  State& state = states_[topic];
  if (state.content == content) return;
  state.content = std::move(content);
  state.payload = payload(++number_, wall_clock_s(), state.content);
  state.is_new = true;
}

StateBoard::Payloads StateBoard::take_new() {
  const std::lock_guard lock(mutex_);
  Payloads payloads;
  for (auto& [topic, state] : states_) {
    if (!state.is_new) continue;
    payloads.emplace_back(topic, state.payload);
    state.is_new = false;
  }
  return payloads;
}

std::optional<StateBoard::Contents> StateBoard::contents_since(std::int64_t& number) {
  const std::lock_guard lock(mutex_);
  if (number == number_) return std::nullopt;
  number = number_;
  Contents contents;
  for (const auto& [topic, state] : states_) contents[topic] = state.content;
  return contents;
}

void StateBoard::renew_all() {
  const std::lock_guard lock(mutex_);
  for (auto& [topic, state] : states_) state.is_new = true;
}

std::string StateBoard::payload(std::int64_t number, double time_s, nlohmann::json content) const {
  content["source"] = source_;
  content["seq"] = number;
  content["time"] = utc_text(time_s);
  return protocol::json_text(content);
}

}  // namespace stanok::gateway
