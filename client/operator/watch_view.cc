#include "client/operator/watch_view.h"

#include "client/operator/channel_text.h"
#include "client/operator/overview_text.h"
#include "client/operator/result_text.h"
#include "client/operator/run_progress.h"
#include "protocol/contract/json_text.h"

namespace stanok::client {
namespace {

using nlohmann::json;

std::string event_line(const json& event) {
  const std::string code = cell_text(event.value("code", json()));
  return "cycle " + cell_text(event.value("cycle", json())) + "  channel " +
         cell_text(event.value("channel", json())) + "  " + (code == "-" ? "" : code + "  ") +
         cell_text(event.value("text", json())) + "\n";
}

}  // namespace

std::string WatchView::shown(const std::string& method, const json& parameters) {
  if (form_ == OutputForm::json) {
    return protocol::json_text(json{{"method", method}, {"params", parameters}}) + "\n";
  }
  if (method == "event") {
    const std::string line = event_line(parameters);
    return terminal_.is_terminal() ? picture_.told_above(line) : line;
  }
  if (method != "status") return "";
  json news = parameters.value("state", json::object());
  // In a patch null takes a member away, in a whole state it is a value (RFC 7396).
  if (parameters.value("full", false)) {
    state_ = std::move(news);
  } else {
    state_.merge_patch(news);
  }
  return status_text();
}

std::string WatchView::status_text() {
  if (terminal_.is_terminal()) return picture_.drawn(drawn());
  std::string text;
  for (const json& channel : channels_in_order(state_.value("channels", json::object())))
    text += progress_line(channel) + "\n";
  return text;
}

std::string WatchView::drawn() const {
  const json channels = state_.value("channels", json::object());
  if (view_ == OperatorView::overview) return overview_text(channels, terminal_);
  std::string text;
  for (const auto& [topic, members] : state_.items()) {
    if (topic != "channels") text += result_text(topic, members, terminal_) + "\n";
  }
  for (const json& channel : channels_in_order(channels))
    text += channel_text(channel, terminal_) + "\n";
  return text;
}

}  // namespace stanok::client
