// Words that a program may not declare, and those that name types. Names are folded.
#pragma once

#include <optional>
#include <string_view>

#include "lang/tree/tree.h"

namespace stanok::lang {

[[nodiscard]] bool is_keyword(std::string_view folded_name);
[[nodiscard]] bool is_reserved_word(std::string_view folded_name);
[[nodiscard]] std::optional<Type> type_of_keyword(std::string_view folded_name);

}  // namespace stanok::lang
