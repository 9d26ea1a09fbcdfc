#include "gateway/cell/topics.h"

namespace stanok::gateway {
namespace {

std::string joined(std::string_view left, std::string_view right) {
  return std::string(left) + "/" + std::string(right);
}

}  // namespace

std::string topic_of(std::string_view prefix, std::string_view machine, std::string_view state) {
  return machine.empty() ? joined(prefix, state) : joined(joined(prefix, machine), state);
}

std::string event_topic_of(std::string_view prefix, std::string_view machine,
                           std::string_view kind) {
  // What belongs to no machine is the gateway's.
  const std::string_view whose = machine.empty() ? topic::gateway : machine;
  return joined(joined(joined(prefix, whose), "event"), kind);
}

bool is_level(std::string_view name) {
  constexpr std::string_view not_allowed("+#/\0", 4);
  return !name.empty() && name.find_first_of(not_allowed) == std::string_view::npos;
}

}  // namespace stanok::gateway
