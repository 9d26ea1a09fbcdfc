#include "drives/modbus/contact_watch.h"

#include <algorithm>
#include <numeric>

namespace stanok::drives {
namespace {

// Weight of a failed exchange in the leaky counter, a good one takes off 1: it falls while 20 % of
// the exchanges fail (0.2 x 3 < 0.8) and rises while 30 % do. Failures that come at random make it
// wander: with 20 % the counter reaches n with the probability x^-n, 0.2 x^4 + 0.8 = x, x = 1.151;
// once in 10^12 polls it reaches 200.
constexpr int failure_weight = 3;
constexpr int leak_max = 200;

}  // namespace

ContactWatch::ContactWatch(BusTime poll, BusTime timeout)
    : timeout_(timeout),
      leak_regained_(std::max(0, leak_max - static_cast<int>(3 * timeout / (2 * poll)))) {}

void ContactWatch::note_answer(BusTime asked) RT_SAFE {
  answering_ = true;
  leak_ = std::max(leak_ - 1, 0);
  lost_ = lost_ && leak_ > leak_regained_;
  answered_at_ = asked;
}

void ContactWatch::note_failure(ExchangeError error) RT_SAFE {
  ++errors_[error];
  answering_ = false;
  leak_ = std::min(leak_ + failure_weight, leak_max);
}

bool ContactWatch::is_exhausted(BusTime now) const RT_SAFE {
  return now - answered_at_ > timeout_ || leak_ >= leak_max;
}

std::uint64_t ContactWatch::error_count() const RT_SAFE {
  return std::accumulate(errors_.begin(), errors_.end(), std::uint64_t{0});
}

void ContactWatch::lose() RT_SAFE {
  lost_ = true;
  leak_ = leak_max;
}

}  // namespace stanok::drives
