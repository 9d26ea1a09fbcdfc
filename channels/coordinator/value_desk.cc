#include "channels/coordinator/value_desk.h"

#include <cmath>

#include "base/units.h"

namespace stanok::channels {
namespace {

double combined(double there, double operand, lang::Combination combination) RT_SAFE {
  switch (combination) {
    case lang::Combination::subtract:
      return there - operand;
    case lang::Combination::multiply:
      return there * operand;
    case lang::Combination::divide:
      return there / operand;
    case lang::Combination::add:
      break;
  }
  return there + operand;
}

}  // namespace

bool ValueDesk::serves(lang::RequestKind kind) RT_SAFE {
  using lang::RequestKind;
  switch (kind) {
    case RequestKind::shared_read:
    case RequestKind::shared_write:
    case RequestKind::shared_combine:
    case RequestKind::tool_table_write:
    case RequestKind::tool_table_read:
    case RequestKind::offset_table_write:
    case RequestKind::offset_table_read:
    case RequestKind::machine_value:
    case RequestKind::input_wait:
      return true;
    default:
      return false;
  }
}

Verdict ValueDesk::step(Errand& errand) RT_SAFE {
  using lang::RequestKind;
  switch (errand.kind) {
    case RequestKind::shared_read:
    case RequestKind::shared_write:
      return shared(errand);
    case RequestKind::shared_combine:
      return combine(errand);
    case RequestKind::machine_value:
      return machine_value(errand);
    case RequestKind::input_wait:
      return input_wait(errand);
    default:
      return table(errand);
  }
}

Verdict ValueDesk::shared(const Errand& errand) RT_SAFE {
  SharedVariables& variables = *stores_.shared;
  const RequestData& request = errand.request;
  const bool writes = errand.kind == lang::RequestKind::shared_write;
  if (writes && request.is_text) variables.set_text(request.number, errand.text);
  if (writes && !request.is_text) variables.set_number(request.number, request.value);
  Verdict verdict = success();
  if (!writes && request.is_text) verdict.text = ReasonText(variables.text(request.number).view());
  if (!writes && !request.is_text) verdict.number = variables.number(request.number);
  return verdict;
}

// Read, computed and written in one cycle: of two channels that count neither is lost. What cannot
// be computed leaves the value as it is.
Verdict ValueDesk::combine(const Errand& errand) RT_SAFE {
  SharedVariables& variables = *stores_.shared;
  const RequestData& request = errand.request;
  if (request.is_text) {
    if (!variables.append_text(request.number, errand.text))
      return refusal("E3009", "a shared string has at most 255 bytes");
    return success();
  }
  if (request.combination == lang::Combination::divide && request.value == 0.0)
    return refusal("E3008", "a number is divided by zero");
  const double value =
      combined(variables.number(request.number), request.value, request.combination);
  if (!std::isfinite(value)) return refusal("E3009", "the result is too large");
  variables.set_number(request.number, value);
  return success();
}

// M66; the modes are those of its L. A time without the event is answered with -1.
Verdict ValueDesk::input_wait(Errand& errand) const RT_SAFE {
  const RequestData& request = errand.request;
  if (request.analog) return success(stores_.inputs->analog[request.number]);
  const bool now = stores_.inputs->is_on(request.number);
  const bool before = errand.stage == 0 ? now : errand.input_before;
  errand.stage = 1;
  errand.input_before = now;
  const bool happened = request.index == 0 || (request.index == 1 && now && !before) ||
                        (request.index == 2 && !now && before) || (request.index == 3 && now) ||
                        (request.index == 4 && !now);
  if (happened) return success(now ? 1.0 : 0.0);
  const bool over = static_cast<double>(errand.cycles) * cycle_s_ >= errand.seconds;
  return over ? success(-1.0) : pending();
}

std::optional<double> ValueDesk::value_of_axis(std::string_view name, const Channel& asker,
                                               int axis) const RT_SAFE {
  const motion::InterpolatorOutput& path = asker.motion.path();
  if (name == "pos") return path.point[axis].value;
  if (name == "pos_mcs") return path.axes[axis].value;
  if (name == "homed") return asker.drives.is_homed(axis) ? 1.0 : 0.0;
  if (name == "axis_channel") {
    const int owner = ownership_.owner(asker.axes.machine_axis(axis));
    return static_cast<double>(channels_[owner].id());
  }
  return std::nullopt;
}

Verdict ValueDesk::machine_value(const Errand& errand) const RT_SAFE {
  constexpr double percent = 100.0;
  const Channel& asker = channels_[errand.asker];
  const std::string_view name = errand.text.view();
  const int index = errand.request.index;
  if (const auto value = value_of_axis(name, asker, index)) return success(*value);
  if (name == "clock") return success(static_cast<double>(asker.runs.cycle()) * cycle_s_);
  if (name == "feed_act") return success(asker.motion.path().s_speed * seconds_per_minute);
  if (name == "ovr_feed") return success(asker.switches.feed_override() * percent);
  if (name == "skip") {
    if (index < 1 || index > 9) return refusal("E6027", "levels of block skip are 1 to 9");
    return success((asker.switches.block_skip() >> index & 1) != 0 ? 1.0 : 0.0);
  }
  if (name == "speed_act") {
    const auto speed = asker.spindles.speed(index);
    return speed ? success(*speed) : refusal("E4053", "the channel has no such spindle");
  }
  if (name == "in" || name == "ain") return input(name, index);
  if (name == "kinematics") {
    const int named = channels_.index_of(index);
    return named < 0 ? refusal("E6001", "there is no such channel")
                     : success(channels_[named].schemes.active_id());
  }
  return refusal("E6033", "the machine does not know this value");
}

Verdict ValueDesk::input(std::string_view name, int index) const RT_SAFE {
  const bool analog = name == "ain";
  const int count = analog ? Signals::analog_count : Signals::digital_count;
  if (index < 0 || index >= count) return refusal("E6028", "there is no such input");
  if (analog) return success(stores_.inputs->analog[index]);
  return success(stores_.inputs->is_on(index) ? 1.0 : 0.0);
}

Verdict ValueDesk::table(const Errand& errand) RT_SAFE {
  using lang::RequestKind;
  const RequestData& request = errand.request;
  const bool offsets = errand.kind == RequestKind::offset_table_write ||
                       errand.kind == RequestKind::offset_table_read;
  const int axis = offsets && request.index >= 0
                       ? channels_[errand.asker].axes.machine_axis(request.index)
                       : request.index;
  const auto value = execute_table_request(*stores_.tables, request, axis);
  if (value) return success(*value);
  const bool writes = errand.kind == RequestKind::tool_table_write ||
                      errand.kind == RequestKind::offset_table_write;
  return writes ? refusal("", "no such entry, a value out of range, or write-protected tables")
                : refusal("E5021", "the tables have no such entry");
}

}  // namespace stanok::channels
