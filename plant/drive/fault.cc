// Names of the injected faults.
#include "plant/drive/fault.h"

#include <algorithm>
#include <array>

namespace stanok::plant {
namespace {

// In the order of the enumeration.
constexpr std::array<std::string_view, fault_kind_count> names = {
    "none", "off",       "stuck",   "garbage", "slow",   "intermittent",
    "trip", "elsewhere", "mangled", "hang_up", "jammed", "frozen"};

}  // namespace

std::string_view name_of(FaultKind kind) {
  return names[static_cast<std::size_t>(kind)];
}

std::optional<FaultKind> fault_named(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    return std::nullopt;
  }
  return static_cast<FaultKind>(found - names.begin());
}

}  // namespace stanok::plant
