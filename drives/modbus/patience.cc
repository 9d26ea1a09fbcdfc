#include "drives/modbus/patience.h"

#include <algorithm>

namespace stanok::drives {
namespace {

constexpr int tries_in_timeout = 40;
constexpr int margin = 3;         // over the slowest answer
constexpr int longer_try_of = 4;  // one try in four is a longer one
constexpr int longest_share = 3;  // of the time-out, for a partner that is not known
constexpr int longer_share = 8;   // for one that answered before
constexpr int forgotten_in = 64;  // answers until a slow one counts for little

}  // namespace

std::chrono::nanoseconds Patience::for_next_answer() const {
  const bool is_known = slowest_.count() > 0;
  if (!is_known) {
    const bool is_longer_try = silences_ % longer_try_of == 0;
    return is_longer_try ? timeout_ / longest_share : between_tries();
  }
  const auto learned = std::clamp(margin * slowest_, between_tries(), timeout_ / longest_share);
  const bool is_longer_try = silences_ % longer_try_of == longer_try_of - 1;
  return is_longer_try ? std::max(learned, timeout_ / longer_share) : learned;
}

std::chrono::nanoseconds Patience::between_tries() const {
  return timeout_ / tries_in_timeout;
}

void Patience::note_answer(std::chrono::nanoseconds round_trip) {
  slowest_ = std::max(round_trip, slowest_ - slowest_ / forgotten_in);
  silences_ = 0;
}

}  // namespace stanok::drives
