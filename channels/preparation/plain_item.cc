#include "channels/preparation/plain_item.h"

#include <string>

namespace stanok::channels {
namespace {

// Fills its item from a command; false: the command is no such one.
struct PlainItem {
  Item item;

  bool is(ItemKind kind) {
    item.kind = kind;
    return true;
  }
  bool operator()(const lang::Dwell& dwell) {
    item.value = dwell.seconds;
    return is(ItemKind::dwell);
  }
  bool operator()(const lang::SpindleCommand& spindle) {
    item.spindle = spindle;
    return is(ItemKind::spindle);
  }
  bool operator()(const lang::CuttingSpeedMode& mode) {
    item.cutting = mode;
    return is(ItemKind::cutting_speed);
  }
  bool operator()(const lang::CoolantCommand& coolant) {
    item.coolant = coolant;
    return is(ItemKind::coolant);
  }
  bool operator()(const lang::ToolChange& change) {
    item.number = change.tool;
    item.value = change.edge;
    return is(ItemKind::tool_change);
  }
  bool operator()(const lang::OverrideControl& control) {
    item.overrides = control;
    return is(ItemKind::override_control);
  }
  bool operator()(const lang::ForceControl& force) {
    item.force = force;
    return is(ItemKind::force_control);
  }
  bool operator()(const lang::ProgramStop& stop) {
    item.number = static_cast<std::int64_t>(stop.kind);
    return is(ItemKind::program_stop);
  }
  bool operator()(const lang::MachineFunction& function) {
    item.text = ShortText("M" + std::to_string(function.code));
    return is(ItemKind::machine_function);
  }
  bool operator()(const auto&) { return false; }
};

}  // namespace

std::optional<Item> plain_item(const lang::Payload& payload) {
  PlainItem made;
  if (!std::visit(made, payload)) return std::nullopt;
  return made.item;
}

}  // namespace stanok::channels
