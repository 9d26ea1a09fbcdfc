#include "client/watch_view.h"

#include <algorithm>

#include "client/overview_text.h"
#include "client/result_text.h"
#include "client/run_progress.h"
#include "protocol/json_text.h"

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
    lines_drawn_ = 0;  // the event stays above what is drawn next
    return event_line(parameters);
  }
  if (method != "status") return "";
  state_.merge_patch(parameters.value("state", json::object()));
  return status_text();
}

std::string WatchView::status_text() {
  std::string text;
  if (!terminal_.is_terminal()) {
    for (const json& channel : state_.value("channels", json::object())) {
      text += progress_line(channel) + "\n";
    }
    return text;
  }
  text = drawn();
  // ECMA-48: CPL moves up to the first line drawn before, ED erases from there.
  const std::string back =
      lines_drawn_ == 0 ? "" : "\033[" + std::to_string(lines_drawn_) + "F\033[J";
  lines_drawn_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return back + text;
}

std::string WatchView::drawn() const {
  const json channels = state_.value("channels", json::object());
  if (is_overview_) return overview_text(channels, terminal_);
  std::string text;
  for (const auto& [topic, members] : state_.items()) {
    if (topic != "channels") text += result_text(topic, members, terminal_) + "\n";
  }
  for (const json& channel : channels)
    text += result_text("channel.status", channel, terminal_) + "\n";
  return text;
}

}  // namespace stanok::client
