#include "daemon/desk/subscription.h"

#include <algorithm>

namespace stanok::daemon {

using nlohmann::json;

json merge_patch_between(const json& before, const json& after) {
  if (!before.is_object() || !after.is_object()) return after;
  json patch = json::object();
  for (const auto& [name, value] : after.items()) {
    const auto old = before.find(name);
    if (old == before.end()) {
      patch[name] = value;
    } else if (*old != value) {
      patch[name] = merge_patch_between(*old, value);
    }
  }
  for (const auto& [name, value] : before.items()) {
    if (!after.contains(name)) patch[name] = nullptr;
  }
  return patch;
}

Subscription::Subscription(const json& topics, double rate_hz, int channel)
    : topics_(topics),
      channel_(channel),
      period_(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
          std::chrono::duration<double>(1.0 / rate_hz))) {}

bool Subscription::wants(const std::string& topic) const {
  return std::find(topics_.begin(), topics_.end(), topic) != topics_.end();
}

bool Subscription::wants_status() const {
  return wants("machine") || wants("channels") || wants("drives");
}

std::optional<json> Subscription::status(json snapshot, Time now) {
  next_ = now + period_;
  const bool is_full = !sent_.has_value();
  json state = is_full ? snapshot : merge_patch_between(*sent_, snapshot);
  if (!is_full && state.empty()) return std::nullopt;
  sent_ = std::move(snapshot);
  return json{{"seq", next_seq()}, {"full", is_full}, {"state", std::move(state)}};
}

}  // namespace stanok::daemon
