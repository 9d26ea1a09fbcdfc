#include "protocol/contract/method_table.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "protocol/contract/method_rows.h"

namespace stanok::protocol {
namespace {

std::vector<Method> all_rows() {
  std::vector<Method> all;
  for (const auto& part :
       {rows::machine_methods(), rows::program_text_methods(), rows::program_methods(),
        rows::queue_methods(), rows::axes_methods(), rows::tables_methods(), rows::hand_methods(),
        rows::process_methods(), rows::scope_methods(), rows::daemon_methods()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

constexpr auto nouns = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"machine", "the machine as a whole"},
    {"channel", "channels: state and position"},
    {"program", "programs: load, run, hold, stop"},
    {"queue", "programs that run one after the other"},
    {"override", "feed, rapid and spindle overrides"},
    {"kinematics", "kinematic schemes of a channel"},
    {"drive", "drives and their bus"},
    {"alarm", "alarms: list, acknowledge, history"},
    {"measurement", "results that programs have measured"},
    {"tool", "tool table"},
    {"offset", "work offsets"},
    {"process", "cutting process and adaptive control"},
    {"workpiece", "virtual workpiece"},
    {"scope", "record signals at the full cycle rate"},
    {"history", "earlier runs: logs of a machine; runs, alarms and use of a cell"},
    {"log", "log files and recorder"},
    {"session", "this connection"},
    {"system", "the daemon itself"},
    {"rpc", "the protocol itself"},
});

constexpr auto effect_names = enum_names<Effect>({
    {Effect::looks, "looks"},
    {Effect::changes, "changes"},
    {Effect::begins_motion, "begins_motion"},
    {Effect::stops, "stops"},
});
constexpr auto role_names = enum_names<Role>({
    {Role::observer, "observer"},
    {Role::machine_operator, "operator"},
    {Role::programmer, "programmer"},
    {Role::integrator, "integrator"},
});

constexpr auto type_names = enum_names<ParameterType>({
    {ParameterType::integer, "integer"},
    {ParameterType::number, "number"},
    {ParameterType::text, "string"},
    {ParameterType::choice, "choice"},
    {ParameterType::text_list, "list"},
});

}  // namespace

std::span<const Method> methods() {
  static const std::vector<Method> table = all_rows();
  return table;
}

const Method* find_method(std::string_view name) {
  const auto table = methods();
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const Method& m) { return m.name == name; });
  return row == table.end() ? nullptr : &*row;
}

std::string_view noun(const Method& method) {
  return method.name.substr(0, method.name.find('.'));
}

std::string_view verb(const Method& method) {
  const std::size_t dot = method.name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : method.name.substr(dot + 1);
}

std::string_view noun_help(std::string_view noun) {
  const auto row =
      std::find_if(nouns.begin(), nouns.end(), [&](const auto& n) { return n.first == noun; });
  return row == nouns.end() ? std::string_view{} : row->second;
}

std::string_view effect_name(Effect effect) {
  return effect_names[effect];
}

std::string_view role_name(Role role) {
  return role_names[role];
}

std::optional<Role> role_named(std::string_view name) {
  return role_names.value(name);
}

std::string_view type_name(ParameterType type) {
  return type_names[type];
}

}  // namespace stanok::protocol
