// Names of the injected faults.
#include "plant/drive/fault.h"

#include "base/enum_names.h"

namespace stanok::plant {
namespace {

constexpr auto names = enum_names<FaultKind>({{FaultKind::none, "none"},
                                              {FaultKind::off, "off"},
                                              {FaultKind::stuck, "stuck"},
                                              {FaultKind::garbage, "garbage"},
                                              {FaultKind::slow, "slow"},
                                              {FaultKind::intermittent, "intermittent"},
                                              {FaultKind::trip, "trip"},
                                              {FaultKind::elsewhere, "elsewhere"},
                                              {FaultKind::mangled, "mangled"},
                                              {FaultKind::hang_up, "hang_up"},
                                              {FaultKind::jammed, "jammed"},
                                              {FaultKind::frozen, "frozen"}});

}  // namespace

std::string_view name_of(FaultKind kind) {
  return names[kind];
}

std::optional<FaultKind> fault_named(std::string_view name) {
  return names.value(name);
}

}  // namespace stanok::plant
