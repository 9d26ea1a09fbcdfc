// The addresses of feed laws: S_n, dS, dl, ... What they make together: lang/feed_law.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/enum_array.h"

namespace stanok::lang {

enum class LawAddress : std::uint8_t {
  feed_first,     // S_n
  feed_last,      // S_k
  feed_step,      // dS
  path_step,      // dl, its sign is the direction of the feed
  feed_min,       // Smin
  feed_max,       // Smax
  steps,          // n_s
  stand,          // L_A
  cut,            // L_B
  speed_first,    // n_n
  speed_last,     // n_k
  speed_step,     // dn
  cutting_first,  // v_n
  cutting_last,   // v_k
  cutting_step,   // dv
};
// A value for each address.
template <class Value>
using LawAddressArray = EnumArray<LawAddress, Value>;

// As programs write it: "S_n".
[[nodiscard]] std::string_view name_of(LawAddress address);
// The address of this name as registered; nothing: it is none of a feed law.
[[nodiscard]] std::optional<LawAddress> find_law_address(std::string_view name);
// Whether a named word belongs to feed laws; `name` as registered.
[[nodiscard]] bool is_law_address(std::string_view name);

}  // namespace stanok::lang
