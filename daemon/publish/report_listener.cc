#include "daemon/publish/report_listener.h"

#include <spdlog/spdlog.h>

#include <chrono>

namespace stanok::daemon {

void ReportListener::tell_once(const char* what, const std::string& fault, bool& has_told) const {
  if (fault.empty() || has_told) return;
  spdlog::warn("{} are not written: {}", what, fault);
  if (trouble_) trouble_(std::string(what) + " are not written: " + fault);
  has_told = true;
}

void ReportListener::on_event(const channels::Event& event) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  measurements_.take(event, std::chrono::duration_cast<std::chrono::microseconds>(now).count());
  printed_.take(event);
  tell_once("measurements", measurements_.error(), has_told_measurements_);
  tell_once("lines of DPRNT", printed_.error(), has_told_printed_);
}

}  // namespace stanok::daemon
