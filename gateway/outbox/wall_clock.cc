#include "gateway/outbox/wall_clock.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>

namespace stanok::gateway {

double wall_clock_s() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::string utc_text(double time_s) {
  constexpr long long ms_per_s = 1000;
  const long long ms = std::llround(time_s * static_cast<double>(ms_per_s));
  const auto seconds = static_cast<std::time_t>(ms / ms_per_s);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), ms % ms_per_s);
}

}  // namespace stanok::gateway
