#include "runtime/operator_request.h"

#include "channels/contract/operator_action.h"

namespace stanok::runtime {

std::optional<channels::OperatorEvent> operator_event(const protocol::MachineRequest& request) {
  const auto action = channels::operator_action(request.action);
  if (!action) return std::nullopt;
  const auto command = channels::command_of({.action = *action,
                                             .number = request.number,
                                             .value = request.value,
                                             .value_2 = request.value_2,
                                             .text = std::string_view(request.text)});
  if (!command) return std::nullopt;
  channels::OperatorEvent event;
  event.command = *command;
  event.channel = request.channel;
  return event;
}

}  // namespace stanok::runtime
