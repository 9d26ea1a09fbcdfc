#include "client/operator/run_progress.h"

#include <fmt/format.h>

#include "client/operator/channel_text.h"
#include "client/operator/result_text.h"

namespace stanok::client {
namespace {

using nlohmann::json;

constexpr double shown_rate_hz = 5.0;

}  // namespace

RunProgress::RunProgress(double channel, const json& hello) {
  int id = static_cast<int>(channel);
  const auto channels = hello.value("channels", json::array());
  if (id == 0 && !channels.empty()) id = channels.front().value("id", 0);
  channel_ = std::to_string(id);
}

void RunProgress::follow(OperatorClient& client) {
  client.on_notification([this](const std::string& method, const json& parameters) {
    if (method != "status") return;
    state_.merge_patch(parameters.value("state", json::object()));
    const auto channels = state_.value("channels", json::object());
    if (const auto channel = channels.find(channel_); channel != channels.end())
      line_.show(progress_line(*channel));
  });
  const json wanted = {{"topics", {"channels"}}, {"rate_hz", shown_rate_hz}};
  // Without a subscription there is no progress line; the command itself goes on.
  static_cast<void>(
      client.call("subscribe", wanted, OperatorClient::Clock::now() + std::chrono::seconds(5)));
}

std::string progress_line(const json& channel) {
  const std::string program = cell_text(channel.value("program", json()));
  const json at = channel.value("line", json());
  const std::string line = at.is_number() && at != 0 ? ":" + cell_text(at) : "";
  constexpr double s_per_min = 60.0;
  const json speed = channel.value("speed_mm_s", json());
  const double speed_mm_s = speed.is_number() ? speed.get<double>() : 0.0;
  const json remaining = channel.value("remaining_s", json());
  return "channel " + cell_text(channel.value("id", json())) + "  " +
         cell_text(channel.value("program_status", json())) + "  " + program + line + "  " +
         position_text(channel) + "  " + fmt::format("{:.0f} mm/min", speed_mm_s * s_per_min) +
         (remaining.is_null() ? "" : "  " + duration_text(remaining) + " left");
}

}  // namespace stanok::client
