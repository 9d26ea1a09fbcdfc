// The codes of the modal groups that are in force from a block on, for displays.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lang/contract/code_number.h"
#include "lang/contract/environment.h"
#include "lang/contract/modal_group.h"

namespace stanok::lang {

// In tenths; 0 in a group of M codes: none.
using ActiveCodes = GroupArray<CodeNumber>;

// At the start of a program, after M2, M30 and reset.
[[nodiscard]] ActiveCodes default_codes(ChannelKind kind);

// "G1", "G17", ... for the letter G; "M3", "M8" for M, where M9 stands for both kinds of coolant.
[[nodiscard]] std::vector<std::string> names_of(const ActiveCodes& codes, char letter);

}  // namespace stanok::lang
