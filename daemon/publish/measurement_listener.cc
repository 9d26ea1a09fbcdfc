#include "daemon/publish/measurement_listener.h"

#include <spdlog/spdlog.h>

#include <chrono>

namespace stanok::daemon {

void MeasurementListener::on_event(const channels::Event& event) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  files_.take(event, std::chrono::duration_cast<std::chrono::microseconds>(now).count());
  if (files_.error().empty() || has_told_error_) return;
  spdlog::warn("measurements are not written: {}", files_.error());
  has_told_error_ = true;
}

}  // namespace stanok::daemon
