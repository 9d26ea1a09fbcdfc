// System variables that the run knows itself: programmed values, no wait for the axes.
#include <algorithm>
#include <cmath>

#include "lang/run/program_run.h"
#include "lang/text/number.h"

namespace stanok::lang {

void ProgramRun::push_system_value(const Instruction& instruction) {
  const std::string_view name = system_variables()[instruction.operand].name;
  if (name == "program") return push(value_of(file().source.name()));
  const bool has_index = instruction.count != 0;
  const double index = has_index ? pop_number() : 0.0;
  double value = 0.0;
  if (name == "channel") value = channel_.id;
  if (name == "line") value = span().line;
  if (name == "prog_pos") value = programmed_position(around_, static_cast<std::size_t>(index));
  if (name == "probe_ok") value = probe_.found ? 1.0 : 0.0;
  if (name == "probe") {
    const auto axis = static_cast<std::size_t>(index);
    value = as_programmed(around_, axis, probe_.position[axis]);
  }
  if (name == "feed") value = modal_.feed_programmed;
  if (name == "tool") value = modal_.tool_active;
  if (name == "tool_next") value = std::max(modal_.tool_prepared, 0);
  if (name == "edge") value = modal_.tool_edge;
  const Tool tool = tables_.tool_edge(modal_.tool_active, modal_.tool_edge).value_or(Tool{});
  if (name == "tool_length") value = tool.length_mm[2];
  if (name == "tool_radius") value = tool.radius_mm;
  if (name == "overhang") value = overhang_in_force(around_);
  if (name == "speed") {
    const auto speed = spindle_speed(index);
    if (!speed) return fail("E4053", "the channel has no such spindle", "unknown spindle");
    value = *speed;
  }
  if (name == "g") {
    const auto code = modal_code_of_group(index);
    if (!code) return fail("E3011", "there is no modal group of this number");
    value = *code;
  }
  push(value_of(value));
}

// Programmed speed in 1/min of a spindle by its id; 0: the master spindle.
std::optional<double> ProgramRun::spindle_speed(double id) const {
  if (std::abs(id) <= 1e-9) return modal_.speed_rev_per_min;
  const auto is_meant = [id](int spindle) { return is_integer(id) && std::lround(id) == spindle; };
  const std::vector<int>& known = channel_.spindles;
  const auto found = std::find_if(known.begin(), known.end(), is_meant);
  if (found == known.end()) return std::nullopt;
  return modal_.speeds_rev_per_min[static_cast<std::size_t>(found - known.begin())];
}

// Active code of modal group n of docs/reference/language.md.
std::optional<double> ProgramRun::modal_code_of_group(double index) const {
  if (!is_integer(index) || index < 1.0 || index > 17.0) return std::nullopt;
  const auto group = static_cast<std::size_t>(std::lround(index)) - 1;
  return modal_.codes[group] / 10.0;
}

}  // namespace stanok::lang
