// AskedAt: when a request came in, in terms of the machine. With it the cycle knows what has
// overtaken the request, and how old it is.
#pragma once

#include <cstdint>
#include <limits>

namespace stanok::daemon {

struct AskedAt {
  std::uint64_t stops_before = std::numeric_limits<std::uint64_t>::max();  // stops taken by then
  std::int64_t cycle = -1;  // the newest one that its asker had seen; -1: it has no age
};

}  // namespace stanok::daemon
