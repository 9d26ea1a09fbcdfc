// RunProgress: one line on the terminal that follows a program while `--wait` waits for its end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "client/operator/operator_client.h"
#include "client/terminal/progress_line.h"

namespace stanok::client {

class RunProgress {
 public:
  // `channel` 0: the first one of the daemon's hello.
  RunProgress(double channel, const nlohmann::json& hello);

  // Subscribes and shows what comes, until `clear`.
  void follow(OperatorClient& client);
  void clear() { line_.clear(); }

 private:
  std::string channel_;  // as in the status: "1"
  nlohmann::json state_ = nlohmann::json::object();
  ProgressLine line_;
};

// "channel 1  Active  part.nc:120  X 1.5000  Y 2  1500 mm/min"
[[nodiscard]] std::string progress_line(const nlohmann::json& channel);

}  // namespace stanok::client
