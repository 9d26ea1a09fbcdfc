// Addresses of more than one letter that every channel has: feed laws and spindle positions.
// Written with `=`: dS=0.1, S2=300.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "lang/words/block_words.h"

namespace stanok::lang {

[[nodiscard]] std::span<const std::string_view> named_addresses();
// The address as registered, whatever the case of `name`; empty if there is none.
[[nodiscard]] std::string_view find_named_address(std::string_view name);

// The spindle that S2= means; nothing when the word is none.
[[nodiscard]] std::optional<int> spindle_of_indexed_speed(const NamedWord& word);

}  // namespace stanok::lang
