// Signals: inputs or outputs of programs, digital and analog (M62 to M68, M66, $in[n], $ain[n]).
//
// One type from the wire to the program: drives exchange it with I/O modules, channels read and
// write it in the cycle. Plain data.
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/numbered.h"
#include "base/rt_safe.h"

namespace stanok {

struct Signals {
  static constexpr int digital_count = 64;
  static constexpr int analog_count = 16;

  std::uint64_t digital = 0;  // bit n: signal n
  NumberedArray<double, analog_count> analog{};

  [[nodiscard]] bool is_on(int number) const RT_SAFE {
    return (digital >> static_cast<unsigned>(number) & 1U) != 0;
  }
  void set(int number, bool on) RT_SAFE {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(number);
    digital = on ? digital | bit : digital & ~bit;
  }
  friend bool operator==(const Signals&, const Signals&) = default;
};

static_assert(std::is_trivially_copyable_v<Signals>);

}  // namespace stanok
