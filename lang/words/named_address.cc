#include "lang/words/named_address.h"

#include <array>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

constexpr auto addresses =
    std::to_array<std::string_view>({"S_n", "S_k", "dS", "dl", "Smin", "Smax", "n_s", "L_A", "L_B",
                                     "n_n", "n_k", "dn", "v_n", "v_k", "dv", "SPOS"});

}  // namespace

std::span<const std::string_view> named_addresses() {
  return addresses;
}

std::string_view find_named_address(std::string_view name) {
  for (const std::string_view known : addresses) {
    if (folded(known) == folded(name)) return known;
  }
  return {};
}

}  // namespace stanok::lang
