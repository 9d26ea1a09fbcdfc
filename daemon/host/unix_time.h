// The time of Unix, for what people read.
#pragma once

#include <chrono>

namespace stanok::daemon {

[[nodiscard]] inline double unix_time_s() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace stanok::daemon
