// Actions of spindles: speed, turning, orientation, constant cutting speed.
//
// A spindle is named by `$`, by its index in S2=, or is the channel's master spindle. Each has its
// own speed; only one at a time runs with constant cutting speed.
#include <algorithm>
#include <cmath>

#include "lang/actions/actions.h"
#include "lang/text/number.h"
#include "lang/text/source.h"

namespace stanok::lang {
namespace {

// Index of a spindle among those of the channel; the master spindle is the first.
std::size_t index_of_spindle(const ActiveBlock& block, int spindle) {
  const std::vector<int>& known = block.channel.spindles;
  const auto found = std::find(known.begin(), known.end(), spindle);
  return found == known.end() ? 0 : static_cast<std::size_t>(found - known.begin());
}

bool exists(const ActiveBlock& block, int spindle) {
  const std::vector<int>& known = block.channel.spindles;
  return spindle == 0 || spindle == -1 ||
         std::find(known.begin(), known.end(), spindle) != known.end();
}

std::optional<int> checked(ActiveBlock& block, int spindle, const WordName& word) {
  if (exists(block, spindle)) return spindle;
  block.fail("E4053", word, "the channel has no spindle " + std::to_string(spindle),
             "unknown spindle");
  return std::nullopt;
}

bool is_cutting_speed_of(const ActiveBlock& block, int spindle) {
  return block.modal.code(Group::spindle_mode) == g(96) && spindle != -1 &&
         index_of_spindle(block, spindle) ==
             index_of_spindle(block, block.modal.spindles.cutting_spindle);
}

void send_cutting_speed(ActiveBlock& block) {
  const ModalState& modal = block.modal;
  block.queue.emit(CuttingSpeedMode{modal.spindles.cutting_spindle, true,
                                    modal.spindles.cutting_speed_m_per_min,
                                    modal.spindles.speed_limit_rev_per_min});
}

// S as a cutting speed, in m/min.
double cutting_speed(const ActiveBlock& block) {
  return block.value('S') * (block.modal.inches() ? m_per_foot : 1.0);
}

void set_speed(ActiveBlock& block, int spindle, double speed, const WordName& word) {
  if (refuse_spindle_that_is_axis(block, spindle, word)) return;
  if (speed < 0.0) {
    block.fail("E4022", word, "the spindle speed must not be negative", "negative speed");
    return;
  }
  if (is_cutting_speed_of(block, spindle)) {
    block.modal.spindles.cutting_speed_m_per_min =
        speed * (block.modal.inches() ? m_per_foot : 1.0);
    return send_cutting_speed(block);
  }
  if (spindle == -1) {
    block.modal.spindles.speeds_rev_per_min.fill(speed);
  } else {
    block.modal.spindles.speeds_rev_per_min[index_of_spindle(block, spindle)] = speed;
  }
  block.modal.spindles.speed_rev_per_min = block.modal.spindles.speeds_rev_per_min[0];
  block.queue.emit(SpindleCommand{
      .spindle = spindle, .action = SpindleAction::set_speed, .speed_rev_per_min = speed});
}

void note_action(ActiveBlock& block, int spindle, SpindleAction action) {
  const bool running = action != SpindleAction::stop && action != SpindleAction::orient;
  const std::uint16_t which =
      spindle == -1 ? std::uint16_t{0xFFFF}
                    : static_cast<std::uint16_t>(1U << index_of_spindle(block, spindle));
  running ? block.modal.spindles.start(which) : block.modal.spindles.stop(which);
}

bool speeds_differ(const ActiveBlock& block) {
  const auto& speeds = block.modal.spindles.speeds_rev_per_min;
  const auto last = speeds.begin() + static_cast<std::ptrdiff_t>(block.channel.spindles.size());
  return std::any_of(speeds.begin(), last, [&](double speed) { return speed != speeds[0]; });
}

}  // namespace

std::optional<int> named_spindle(ActiveBlock& block) {
  return checked(block, block.words.spindle_named ? block.words.spindle : 0, {});
}

double speed_of_spindle(const ActiveBlock& block, int spindle) {
  return block.modal.spindles.speeds_rev_per_min[index_of_spindle(block, spindle)];
}

bool spindle_turns(const ActiveBlock& block, int spindle) {
  return block.modal.spindles.runs(index_of_spindle(block, spindle));
}

bool spindle_has_position(const ActiveBlock& block, int spindle) {
  const std::vector<int>& known = block.channel.spindles;
  if (known.empty()) return false;
  const int id = known[index_of_spindle(block, spindle)];
  const std::vector<int>& with = block.channel.spindles_with_position;
  return std::find(with.begin(), with.end(), id) != with.end();
}

void turn_spindle(ActiveBlock& block, int spindle, SpindleAction action) {
  note_action(block, spindle, action);
  const bool turns =
      action == SpindleAction::clockwise || action == SpindleAction::counter_clockwise;
  if (spindle == -1 && turns && speeds_differ(block)) {
    for (const int one : block.channel.spindles) turn_spindle(block, one, action);
    return;
  }
  SpindleCommand command;
  command.spindle = spindle;
  command.action = action;
  command.speed_rev_per_min = speed_of_spindle(block, spindle);
  if (turns && is_cutting_speed_of(block, spindle)) {
    command.cutting_speed_m_per_min = block.modal.spindles.cutting_speed_m_per_min;
  }
  block.queue.emit(command);
}

void take_speed(ActiveBlock& block, CodeNumber) {
  if (block.has('S')) {
    const auto spindle = named_spindle(block);
    if (spindle) set_speed(block, *spindle, block.value('S'), {'S', -1, {}});
  }
  for (const NamedWord& word : block.words.named) {
    const auto index = spindle_of_indexed_speed(word);
    if (!index || block.channel_words.axis_called(word.name).exists()) continue;
    const WordName name{0, -1, word.name};
    const auto spindle = checked(block, *index, name);
    if (spindle) set_speed(block, *spindle, word.value, name);
  }
}

void switch_spindle(ActiveBlock& block, CodeNumber code) {
  const auto spindle = named_spindle(block);
  if (!spindle) return;
  const bool stops = code == m(5);
  if (!stops && refuse_spindle_that_is_axis(block, *spindle, {'M', code, {}})) return;
  turn_spindle(block, *spindle,
               code == m(3)   ? SpindleAction::clockwise
               : code == m(4) ? SpindleAction::counter_clockwise
                              : SpindleAction::stop);
}

void orient_spindle(ActiveBlock& block, CodeNumber code) {
  const auto spindle = named_spindle(block);
  if (!spindle || refuse_spindle_that_is_axis(block, *spindle, {'M', code, {}})) return;
  SpindleCommand command;
  command.spindle = *spindle;
  command.action = SpindleAction::orient;
  command.speed_rev_per_min = speed_of_spindle(block, *spindle);
  if (block.has('R')) command.angle_deg = block.value('R');
  // Haas says the angle by P, or by R. Source: Haas operator's manuals, M19.
  const bool angle_by_p = block.words.rules.is_haas() && block.has('P');
  if (angle_by_p) command.angle_deg = block.value('P');
  block.modal.spindles.orient_angle_deg = command.angle_deg;
  if (block.has('P') && !angle_by_p) {
    const auto way = block.integer('P', 0, 2);
    if (!way) return;
    command.way = static_cast<OrientWay>(*way);
  }
  if (block.has('Q')) {
    command.timeout_s = block.value('Q');
    if (command.timeout_s < 0.0) {
      block.fail("E4008", {'Q', -1, {}}, "a timeout must not be negative", "negative");
      return;
    }
  }
  note_action(block, *spindle, SpindleAction::orient);
  block.queue.emit(command);
}

// G96 S D, G97. The S of G96 is its own: without it the last cutting speed holds.
void select_spindle_mode(ActiveBlock& block, CodeNumber code) {
  const auto spindle = named_spindle(block);
  if (!spindle) return;
  ModalState& modal = block.modal;
  if (code == g(97)) {
    if (modal.code(Group::spindle_mode) != g(96)) return;
    block.queue.emit(CuttingSpeedMode{modal.spindles.cutting_spindle});
    return;
  }
  if (refuse_spindle_that_is_axis(block, *spindle, {'G', code, {}})) return;
  if (modal.feed.law.speed != FeedLaw::Speed::unchanged) {
    block
        .fail("E4344", {'G', code, {}},
              "`G96` is not possible while a feed law sets the spindle speed", "both set the speed")
        .help.emplace_back("end the law with `#feedlaw (off)` or an F word first");
    return;
  }
  if (block.has('D')) modal.spindles.speed_limit_rev_per_min = block.value('D');
  if (block.has('S')) modal.spindles.cutting_speed_m_per_min = cutting_speed(block);
  modal.spindles.cutting_spindle = *spindle;
  if (modal.spindles.speed_limit_rev_per_min < 0.0 ||
      modal.spindles.cutting_speed_m_per_min < 0.0) {
    block.fail("E4022", {modal.spindles.speed_limit_rev_per_min < 0.0 ? 'D' : 'S', -1, {}},
               "a speed must not be negative", "negative speed");
  } else if (modal.spindles.cutting_speed_m_per_min == 0.0) {
    block.fail("E4054", {'G', g(96), {}}, "`G96` needs a cutting speed", "no S")
        .help.push_back("give m/min (G20: ft/min), e.g. `G96 S180 D2500`");
  } else {
    send_cutting_speed(block);
  }
}

void restore_spindle_mode(ActiveBlock& block, const ModalState& saved) {
  ModalState& modal = block.modal;
  const CodeNumber code = saved.code(Group::spindle_mode);
  const bool same =
      modal.code(Group::spindle_mode) == code &&
      modal.spindles.cutting_spindle == saved.spindles.cutting_spindle &&
      modal.spindles.cutting_speed_m_per_min == saved.spindles.cutting_speed_m_per_min &&
      modal.spindles.speed_limit_rev_per_min == saved.spindles.speed_limit_rev_per_min;
  if (same) return;
  if (code != g(96) && modal.code(Group::spindle_mode) == g(96)) {
    block.queue.emit(CuttingSpeedMode{modal.spindles.cutting_spindle});
  }
  modal.spindles.cutting_spindle = saved.spindles.cutting_spindle;
  modal.spindles.cutting_speed_m_per_min = saved.spindles.cutting_speed_m_per_min;
  modal.spindles.speed_limit_rev_per_min = saved.spindles.speed_limit_rev_per_min;
  block.set_modal(Group::spindle_mode, code);
  if (code == g(96)) send_cutting_speed(block);
}

// G50 S and G92 S on a lathe channel: the limit of G96.
void limit_speed(ActiveBlock& block) {
  const double limit = block.value('S');
  if (limit < 0.0) {
    block.fail("E4022", {'S', -1, {}}, "the speed limit must not be negative", "negative speed");
    return;
  }
  block.modal.spindles.speed_limit_rev_per_min = limit;
  if (block.modal.code(Group::spindle_mode) == g(96)) send_cutting_speed(block);
}

}  // namespace stanok::lang
