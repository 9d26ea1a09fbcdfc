// Modes in which some codes have no meaning.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "lang/block/active_block.h"

namespace stanok::lang {

enum class Exclusion : std::uint8_t {
  radius_compensation,  // G41, G42
  tcp,                  // G43.4
  transformation,       // G12.1, G7.1
  drilling_cycle,
  inverse_time,  // G93
  rotation,      // G68, G68.2 to G68.4
  own_rotation,  // G68 alone
  tilted_plane,
  scaling,         // G51
  mirror,          // G51.1
  carried_offset,  // G54.2
};
struct ActiveMode {
  std::string_view name;  // "TCP (RTCP) is active"
  std::string_view remedy;
  Note set_by;
};
// The first of `modes` that is active.
[[nodiscard]] std::optional<ActiveMode> active_mode(const ModalState& modal,
                                                    std::initializer_list<Exclusion> modes);
// Fails the block when one of `modes` is active. True when it failed.
[[nodiscard]] bool excluded_by_mode(ActiveBlock& block, CodeNumber code,
                                    std::initializer_list<Exclusion> exclusions, char letter = 'G');

}  // namespace stanok::lang
