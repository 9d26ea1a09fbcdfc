// Built-in constants and system variables.
#include <array>
#include <numbers>

#include "lang/tree/builtin.h"

namespace stanok::lang {
namespace {

struct NamedNumber {
  std::string_view name;
  double number;
};

constexpr auto constants = std::to_array<NamedNumber>({
    {"pi", std::numbers::pi},
    {"ch_idle", 0.0},
    {"ch_ready", 1.0},
    {"ch_running", 2.0},
    {"ch_held", 3.0},
    {"ch_alarm", 4.0},
    {"gv_modal", 1.0},
    {"gv_feed", 2.0},
    {"gv_spindle", 4.0},
    {"gv_tool", 8.0},
    {"gv_frames", 16.0},
    {"gv_coolant", 32.0},
    {"gv_all", 63.0},
});

constexpr auto variables = std::to_array<SystemVariable>({
    {"channel", Type::number, Type::none, false},
    {"line", Type::number, Type::none, false},
    {"program", Type::string, Type::none, false},
    {"prog_pos", Type::number, Type::axis, false},
    {"probe_ok", Type::boolean, Type::none, false},
    {"probe", Type::number, Type::axis, false},
    {"g", Type::number, Type::number, false},
    {"feed", Type::number, Type::none, false},
    {"speed", Type::number, Type::none, false},
    {"tool", Type::number, Type::none, false},
    {"tool_next", Type::number, Type::none, false},
    {"edge", Type::number, Type::none, false},
    {"tool_length", Type::number, Type::none, false},
    {"tool_radius", Type::number, Type::none, false},
    {"overhang", Type::number, Type::none, false},
    {"skip", Type::boolean, Type::number, true},
    {"pos", Type::number, Type::axis, true},
    {"pos_mcs", Type::number, Type::axis, true},
    {"feed_act", Type::number, Type::none, true},
    {"speed_act", Type::number, Type::number, true},
    {"ovr_feed", Type::number, Type::none, true},
    {"in", Type::boolean, Type::number, true},
    {"ain", Type::number, Type::number, true},
    {"homed", Type::boolean, Type::axis, true},
    {"axis_channel", Type::number, Type::axis, true},
    {"kinematics", Type::number, Type::number, true},
});

}  // namespace

std::optional<double> find_builtin_constant(std::string_view folded_name) {
  for (const NamedNumber& constant : constants) {
    if (constant.name == folded_name) return constant.number;
  }
  return std::nullopt;
}

const SystemVariable* find_system_variable(std::string_view folded_name) {
  for (const SystemVariable& variable : variables) {
    if (variable.name == folded_name) return &variable;
  }
  return nullptr;
}

std::span<const SystemVariable> system_variables() {
  return variables;
}

}  // namespace stanok::lang
