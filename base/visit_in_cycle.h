// visit_in_cycle: std::visit for functions that the real-time cycle reaches; and holds_one_of.
//
// std::visit may throw, so that clang refuses it there. A variant whose alternatives are trivially
// copyable always holds one of them: what it holds is found by asking for one after the other,
// which compilers turn into a jump by its index.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include "base/rt_safe.h"

namespace stanok {

// Hands what the variant holds to `visitor`; RT_SAFE where the calls of `visitor` are.
template <std::size_t first = 0, class Visitor, class... Alternatives>
constexpr decltype(auto) visit_in_cycle(Visitor&& visitor,
                                        const std::variant<Alternatives...>& variant) RT_SAFE {
  static_assert((std::is_trivially_copyable_v<Alternatives> && ...));
  if constexpr (first + 1 < sizeof...(Alternatives)) {
    if (const auto* held = std::get_if<first>(&variant)) return visitor(*held);
    return visit_in_cycle<first + 1>(visitor, variant);
  } else {
    return visitor(*std::get_if<first>(&variant));
  }
}

// Whether the variant holds one of `Kinds`.
template <class... Kinds, class Variant>
[[nodiscard]] constexpr bool holds_one_of(const Variant& variant) RT_SAFE {
  return (std::holds_alternative<Kinds>(variant) || ...);
}

}  // namespace stanok
