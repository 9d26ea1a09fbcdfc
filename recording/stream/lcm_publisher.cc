#include "recording/stream/lcm_publisher.h"

#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <utility>

namespace stanok::recording {
namespace {

std::string chosen_url(std::string url) {
  if (!url.empty()) return url;
  const char* from_environment = std::getenv("LCM_DEFAULT_URL");  // NOLINT: read at start only
  return from_environment != nullptr && *from_environment != '\0' ? from_environment
                                                                  : default_lcm_url;
}

}  // namespace

LcmPublisher::LcmPublisher(std::string url) {
  status_.url = chosen_url(std::move(url));
  reopen();
}

void LcmPublisher::reopen() {
  if (bus_ != nullptr || status_.url.starts_with("tcpq")) return;
  bus_ = std::make_unique<lcm::LCM>(status_.url);
  status_.open = bus_->good();
  if (!status_.open) bus_.reset();
}

LcmPublisher::~LcmPublisher() = default;

void LcmPublisher::send(const std::string& channel, std::int64_t /*utime*/,
                        std::span<const std::uint8_t> bytes) {
  if (bus_ == nullptr) {
    ++status_.lost;
    return;
  }
  const int result = bus_->publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
  ++(result == 0 ? status_.sent : status_.lost);
}

}  // namespace stanok::recording
