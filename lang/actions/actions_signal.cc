// Actions of inputs and outputs, and of single overrides.
#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

constexpr int digital_max = 63;
constexpr int analog_max = 15;

// The number of a signal in `letter`; fails the block when it is missing or out of range.
std::optional<int> signal(ActiveBlock& block, CodeNumber code, char letter, int largest) {
  if (block.has(letter)) return block.integer(letter, 0, largest);
  block.fail("E4007", {'M', code, {}},
             "`" + code_text('M', code) + "` needs the number of a signal",
             std::string("no ") + letter);
  return std::nullopt;
}

// M59 P4, M59 P1104 and M59 P12004 of Haas: output 4, by its number or the variable that has it.
std::optional<int> output_by_variable(ActiveBlock& block, CodeNumber code) {
  constexpr int first_old = 1100;
  constexpr int last_old = 1131;
  constexpr int first = 12000;
  const auto number = signal(block, code, 'P', first + digital_max);
  if (!number || *number <= digital_max) return number;
  if (*number >= first_old && *number <= last_old) return *number - first_old;
  if (*number >= first) return *number - first;
  block.fail("E4008", {'P', -1, {}}, "`P` must be an output or its variable",
             "0 to 63, 1100 to 1131, or 12000 to 12063");
  return std::nullopt;
}

}  // namespace

OverrideControl override_control_of(const ModalState& modal) {
  return {modal.switches.feed_override, modal.switches.spindle_override,
          modal.switches.adaptive_feed, modal.switches.feed_stop};
}

// P0 switches off; P1 or no P switches on.
void switch_override(ActiveBlock& block, CodeNumber code) {
  bool enabled = true;
  if (block.has('P')) {
    const auto given = block.integer('P', 0, 1);
    if (!given) return;
    enabled = *given == 1;
  }
  if (code == m(50)) block.modal.switches.feed_override = enabled;
  if (code == m(51)) block.modal.switches.spindle_override = enabled;
  if (code == m(52)) block.modal.switches.adaptive_feed = enabled;
  if (code == m(53)) block.modal.switches.feed_stop = enabled;
  block.queue.emit(override_control_of(block.modal));
}

void switch_output(ActiveBlock& block, CodeNumber code) {
  const bool by_variable = code == m(59) || code == m(69);
  const auto number =
      by_variable ? output_by_variable(block, code) : signal(block, code, 'P', digital_max);
  if (!number) return;
  const bool on = code == m(59) || code == m(62) || code == m(64);
  const bool with_motion = code == m(62) || code == m(63);
  block.queue.emit(OutputCommand{false, with_motion, *number, on ? 1.0 : 0.0});
}

void set_analog_output(ActiveBlock& block, CodeNumber code) {
  const auto number = signal(block, code, 'E', analog_max);
  if (!number) return;
  block.queue.emit(
      OutputCommand{true, code == m(67), *number, block.has('Q') ? block.value('Q') : 0.0});
}

// L: 0 at once, 1 rise, 2 fall, 3 on, 4 off. The result is #5399.
void wait_for_input(ActiveBlock& block, CodeNumber code) {
  const bool analog = block.has('E');
  if (analog == block.has('P')) {
    block.fail("E4007", {'M', code, {}}, "`M66` needs one input: P digital or E analog",
               analog ? "both are given" : "neither is given");
    return;
  }
  const auto number =
      analog ? signal(block, code, 'E', analog_max) : signal(block, code, 'P', digital_max);
  const auto mode = block.has('L') ? block.integer('L', 0, analog ? 0 : 4) : std::optional(0);
  if (!number || !mode) return;
  if (*mode != 0 && (!block.has('Q') || block.value('Q') <= 0.0)) {
    block
        .fail("E4007", {'M', code, {}}, "`M66` with L1 to L4 needs Q, the longest time to wait",
              "no Q above 0")
        .help.push_back("give seconds, e.g. `Q5`");
    return;
  }
  ProgramRequest request;
  request.kind = RequestKind::input_wait;
  request.number = *number;
  request.index = *mode;
  request.analog = analog;
  request.seconds = block.has('Q') ? block.value('Q') : 0.0;
  block.queue.emit(std::move(request));
}

}  // namespace stanok::lang
