#include "channels/coordinator/value_desk.h"

#include <cmath>

#include "base/units.h"
#include "base/visit_in_cycle.h"

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

struct InputStates {
  bool before = false;
  bool now = false;
};

bool has_happened(requests::InputEvent event, const InputStates& input) RT_SAFE {
  switch (event) {
    case requests::InputEvent::none:
      return true;
    case requests::InputEvent::rise:
      return input.now && !input.before;
    case requests::InputEvent::fall:
      return !input.now && input.before;
    case requests::InputEvent::on:
      return input.now;
    case requests::InputEvent::off:
      return !input.now;
  }
  return false;
}

}  // namespace

struct ValueDesk::Access {
  ValueDesk& desk;
  Errand& errand;

  [[nodiscard]] SharedVariables& shared() const RT_SAFE { return *desk.stores_.shared; }
  [[nodiscard]] const Channel& asker() const RT_SAFE { return desk.channels_[errand.asker]; }
  [[nodiscard]] std::optional<double> value_of_table() const RT_SAFE {
    return execute_table_request(*desk.stores_.tables, errand.request, asker().axes.machine_axes());
  }
  [[nodiscard]] Verdict table_read() const RT_SAFE {
    const auto value = value_of_table();
    return value ? success(*value) : refusal("E5021", "the tables have no such entry");
  }
  // What is not plausible ends the program, whether it looks at the result or not.
  [[nodiscard]] Verdict table_write() const RT_SAFE {
    const ReasonText reason =
        implausible_entry(*desk.stores_.tables, errand.request, asker().axes.machine_axes());
    if (!reason.empty()) {
      Verdict verdict = refusal("E5022", reason.view());
      verdict.raises = true;
      return verdict;
    }
    const auto value = value_of_table();
    if (value) return success(*value);
    return refusal("", "no such entry, a value out of range, or write-protected tables");
  }

  // The program itself goes on with what it wrote.
  void settle_others(const lang::ChangedRows& rows) const RT_SAFE {
    for (int k = 0; k < desk.channels_.count(); ++k) {
      if (k != errand.asker) desk.channels_[k].items().settling().want(rows);
    }
  }

  Verdict operator()(const requests::ToolRead& /*read*/) const RT_SAFE { return table_read(); }
  Verdict operator()(const requests::OffsetRead& /*read*/) const RT_SAFE { return table_read(); }
  Verdict operator()(const requests::ToolWrite& /*write*/) const RT_SAFE { return table_write(); }
  Verdict operator()(const requests::OffsetWrite& write) const RT_SAFE {
    const Verdict verdict = table_write();
    if (verdict.ok) settle_others({.work_offset = write.place.offset});
    return verdict;
  }
  Verdict operator()(const requests::MachineValueRead& read) const RT_SAFE {
    return desk.machine_value(read, asker());
  }
  Verdict operator()(const requests::AnalogRead& read) const RT_SAFE {
    return success(desk.stores_.inputs->analog[read.input]);
  }
  Verdict operator()(const requests::InputWait& wait) const RT_SAFE {
    return desk.wait_for(wait, errand);
  }
  Verdict operator()(const requests::SharedNumberRead& read) const RT_SAFE {
    return success(shared().number(read.cell));
  }
  Verdict operator()(const requests::SharedNumberWrite& write) const RT_SAFE {
    shared().set_number(write.cell, write.value);
    return success();
  }
  // Read, computed and written in one cycle: of two channels that count neither is lost. What
  // cannot be computed leaves the value as it is.
  Verdict operator()(const requests::SharedNumberCombine& request) const RT_SAFE {
    if (request.combination == lang::Combination::divide && request.operand == 0.0)
      return refusal("E3008", "a number is divided by zero");
    const double value =
        combined(shared().number(request.cell), request.operand, request.combination);
    if (!std::isfinite(value)) return refusal("E3009", "the result is too large");
    shared().set_number(request.cell, value);
    return success();
  }
  Verdict operator()(const requests::SharedTextRead& read) const RT_SAFE {
    Verdict verdict = success();
    verdict.text = ReasonText(shared().text(read.cell).view());
    return verdict;
  }
  Verdict operator()(const requests::SharedTextWrite& write) const RT_SAFE {
    shared().set_text(write.cell, write.text);
    return success();
  }
  Verdict operator()(const requests::SharedTextAppend& request) const RT_SAFE {
    if (shared().append_text(request.cell, request.more)) return success();
    return refusal("E3009", "a shared string has at most 255 bytes");
  }
  Verdict operator()(const auto& /*other*/) const RT_SAFE {
    return refusal("E2090", "not supported in this release");
  }
};

Verdict ValueDesk::step(Errand& errand) RT_SAFE {
  return visit_in_cycle(Access{*this, errand}, errand.request);
}

Verdict ValueDesk::wait_for(const requests::InputWait& wait, Errand& errand) const RT_SAFE {
  const bool now = stores_.inputs->is_on(wait.input);
  const auto* const watched = std::get_if<errand_states::WatchingInput>(&errand.state);
  const bool before = watched == nullptr ? now : watched->was_on;
  errand.state = ErrandState(errand_states::WatchingInput{now});
  if (has_happened(wait.event, {.before = before, .now = now})) return success(now ? 1.0 : 0.0);
  const bool over = static_cast<double>(errand.cycles) * cycle_s_ >= wait.seconds;
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

Verdict ValueDesk::machine_value(const requests::MachineValueRead& read, const Channel& asker) const
    RT_SAFE {
  constexpr double percent = 100.0;
  const std::string_view name = read.name.view();
  const int index = read.index;
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

}  // namespace stanok::channels
