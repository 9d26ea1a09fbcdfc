// Wall clock of the gateway: seconds since 1970 in UTC, and their text as ISO 8601.
#pragma once

#include <string>

namespace stanok::gateway {

[[nodiscard]] double wall_clock_s();
// "2026-03-01T07:30:00.125Z"
[[nodiscard]] std::string utc_text(double time_s);

}  // namespace stanok::gateway
