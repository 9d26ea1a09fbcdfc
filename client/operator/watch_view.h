// WatchView: what `watch`, `channel watch` and `subscribe` show of the notifications.
//
// On a terminal the status is drawn in place, and what happens stands above it; into a pipe goes
// one line per change, with --json one notification per line as it came.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "client/operator/operator_commands.h"
#include "client/terminal/picture_in_place.h"
#include "client/terminal/terminal.h"

namespace stanok::client {

class WatchView {
 public:
  // An overview has one row per channel; else all that is known is shown.
  WatchView(OutputForm form, const Terminal& terminal, OperatorView view = OperatorView::answer)
      : form_(form), view_(view), terminal_(terminal), picture_(terminal) {}

  // The text to print for one notification; "" when it changes nothing that is shown.
  [[nodiscard]] std::string shown(const std::string& method, const nlohmann::json& parameters);

 private:
  [[nodiscard]] std::string status_text();
  [[nodiscard]] std::string drawn() const;

  OutputForm form_;
  OperatorView view_;
  Terminal terminal_;
  nlohmann::json state_ = nlohmann::json::object();
  PictureInPlace picture_;
};

}  // namespace stanok::client
