// What the commands of logs share: the value or the reason why a log cannot be read, the channels
// to work on, the warning of a damaged log.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "recording/read/log_contents.h"

namespace stanok::client {

// Throws std::runtime_error.
template <class Value>
[[nodiscard]] Value value_or_throw(Expected<Value, recording::LogError> result) {
  if (!result) throw std::runtime_error(result.error().text);
  return std::move(*result);
}

// "1, 2"
[[nodiscard]] std::string channel_list(const recording::LogContents& contents);

// The one that was asked for, or (0) all with setpoints; throws std::runtime_error where none has.
[[nodiscard]] std::vector<int> chosen_channels(const recording::LogContents& contents, int channel);

void warn_when_damaged(const recording::LogContents& contents, const std::string& file);

}  // namespace stanok::client
