#include "gateway/broker/settled_position.h"

namespace stanok::gateway {
namespace {

// Finer than this the age of an acknowledgement is not known.
constexpr std::chrono::milliseconds grain{250};

}  // namespace

void SettledPosition::acknowledge(std::int64_t number, Clock::time_point now) {
  const std::size_t count = acknowledged_.size();
  // The newest two within a grain become one, with the time of the later.
  if (count > 1 && now - acknowledged_[count - 2].since < grain)
    acknowledged_.back() = {now, number};
  else
    acknowledged_.push_back({now, number});
}

std::optional<std::int64_t> SettledPosition::take(Clock::time_point now) {
  std::optional<std::int64_t> settled;
  while (!acknowledged_.empty() && now - acknowledged_.front().since >= kept_) {
    settled = acknowledged_.front().number;
    acknowledged_.pop_front();
  }
  return settled;
}

}  // namespace stanok::gateway
