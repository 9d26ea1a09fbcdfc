#include "channels/preparation/plain_item.h"

#include <concepts>
#include <variant>

namespace stanok::channels {
namespace {

template <class Command>
concept Plain =
    std::same_as<Command, lang::Dwell> || std::same_as<Command, lang::SpindleCommand> ||
    std::same_as<Command, lang::CuttingSpeedMode> || std::same_as<Command, lang::CoolantCommand> ||
    std::same_as<Command, lang::ToolChange> || std::same_as<Command, lang::OverrideControl> ||
    std::same_as<Command, lang::ForceControl> || std::same_as<Command, lang::ProgramStop> ||
    std::same_as<Command, lang::MachineFunction>;

struct PlainContent {
  using Content = std::optional<ItemContent>;

  Content operator()(const Plain auto& command) const { return command; }
  // With motion it is a rider of the path.
  Content operator()(const lang::OutputCommand& output) const {
    return output.with_motion ? Content() : output;
  }
  Content operator()(const auto& /*command*/) const { return std::nullopt; }
};

}  // namespace

std::optional<ItemContent> plain_content(const lang::Payload& payload) {
  return std::visit(PlainContent(), payload);
}

}  // namespace stanok::channels
