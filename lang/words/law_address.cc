#include "lang/words/law_address.h"

#include <algorithm>
#include <array>

namespace stanok::lang {
namespace {

constexpr LawAddressArray<std::string_view> names{"S_n",  "S_k", "dS",  "dl",  "Smin",
                                                  "Smax", "n_s", "L_A", "L_B", "n_n",
                                                  "n_k",  "dn",  "v_n", "v_k", "dv"};
static_assert(!names.back().empty());

}  // namespace

std::string_view name_of(LawAddress address) {
  return names[address];
}

std::optional<LawAddress> find_law_address(std::string_view name) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<LawAddress>(found - names.begin());
}

bool is_law_address(std::string_view name) {
  return find_law_address(name).has_value();
}

}  // namespace stanok::lang
