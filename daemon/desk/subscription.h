// Subscription: what one client wants to be told, and what it has been told last.
//
// The first status is a full snapshot; later ones hold only what changed, as a merge patch (RFC
// 7396) against the last one that was sent. A status that was not sent costs nothing: the next
// difference contains it.
#pragma once

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace stanok::daemon {

// The patch that makes `after` of `before`; empty object: nothing has changed.
[[nodiscard]] nlohmann::json merge_patch_between(const nlohmann::json& before,
                                                 const nlohmann::json& after);

class Subscription {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // Nothing at all.
  Subscription() = default;
  // `channel` 0: all channels.
  Subscription(const nlohmann::json& topics, double rate_hz, int channel);

  [[nodiscard]] bool wants(const std::string& topic) const;
  [[nodiscard]] bool wants_status() const;
  [[nodiscard]] const nlohmann::json& topics() const { return topics_; }
  [[nodiscard]] int channel() const { return channel_; }

  [[nodiscard]] bool is_due(Time now) const { return wants_status() && now >= next_; }
  // The parameters of the status message for this snapshot; nothing when nothing has changed.
  [[nodiscard]] std::optional<nlohmann::json> status(nlohmann::json snapshot, Time now);
  [[nodiscard]] std::int64_t next_seq() { return ++seq_; }

 private:
  nlohmann::json topics_ = nlohmann::json::array();
  int channel_ = 0;
  std::chrono::steady_clock::duration period_{};
  Time next_{};
  std::int64_t seq_ = 0;
  std::optional<nlohmann::json> sent_;
};

}  // namespace stanok::daemon
