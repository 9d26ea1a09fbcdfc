// Addresses of more than one letter that every channel has: feed laws and spindle positions.
// Written with `=`: dS=0.1.
#pragma once

#include <span>
#include <string_view>

namespace stanok::lang {

[[nodiscard]] std::span<const std::string_view> named_addresses();
// The address as registered, whatever the case of `name`; empty if there is none.
[[nodiscard]] std::string_view find_named_address(std::string_view name);

}  // namespace stanok::lang
