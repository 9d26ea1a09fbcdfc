// Actions of feed, speed, tool, coolant, dwell and program end.
#include <algorithm>
#include <cmath>

#include "lang/actions/actions.h"
#include "lang/block/other_controls.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

// A T word in two parts: tool and edge, 0 = no offset.
struct ToolWord {
  int tool = 0;
  int edge = 1;
  int offset = -1;  // tool whose values hold; -1: its own
};

// On a lathe channel three and more digits hold the edge in the last two (T0101).
ToolWord tool_of_word(const ActiveBlock& block, int number) {
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  const bool with_edge = block.channel.tool_word_has_edge.value_or(lathe);
  if (block.channel.tool_word_has_offset && number >= 100) return {number / 100, 1, number % 100};
  if (with_edge && number >= 100) return {number / 100, number % 100};
  return {number, 1};
}

bool changes_at_tool_word(const ActiveBlock& block) {
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  return block.channel.tool_word_changes_tool.value_or(lathe);
}

void put_into_spindle(ActiveBlock& block, const ToolWord& tool) {
  set_overhang(block, {});
  block.modal.tool.active = tool.tool;
  block.modal.tool.edge = tool.edge;
  block.queue.emit(ToolChange{.tool = tool.tool, .edge = std::max(tool.edge, 1)});
}

// An output of the machine builder, and the input that tells that it has done its work.
void switch_and_wait(ActiveBlock& block, const UserCode& output) {
  block.queue.emit(OutputCommand{false, false, output.output, output.on ? 1.0 : 0.0});
  if (output.feedback < 0) return;
  constexpr int while_on = 3;  // L of M66
  constexpr int while_off = 4;
  ProgramRequest request;
  request.kind = RequestKind::input_wait;
  request.number = output.feedback;
  request.index = output.on ? while_on : while_off;
  request.seconds = output.timeout_s;
  request.statement = true;
  block.queue.emit(std::move(request));
}

}  // namespace

void only_modal(ActiveBlock&, CodeNumber) {}

// In the Fanuc dialect G80 is in a group of its own: the motion code from before the cycle is in
// force again.
CodeNumber motion_behind_cycle(const ModalState& modal) {
  const CodeNumber number = modal.code(Group::motion);
  const bool drills = find_code('G', number)->action == CodeAction::drill_hole;
  const bool also_elsewhere = number == g(73) || number == g(74) || number == g(76);
  return drills || also_elsewhere ? modal.cycles.motion_before : number;
}

void end_cycle(ActiveBlock& block, CodeNumber) {
  if (!block.words.rules.is_fanuc()) return;
  block.kept_groups |= group_bit(Group::motion);
  const CodeNumber behind = motion_behind_cycle(block.modal);
  if (behind != block.modal.code(Group::motion)) block.set_modal(Group::motion, behind);
}

void take_feed(ActiveBlock& block, CodeNumber) {
  set_feed(block);
  if (!block.failed()) end_feed_law(block);
}

void set_feed(ActiveBlock& block) {
  const double feed = block.value('F');
  if (feed < 0.0) {
    block.fail("E4022", {'F', -1, {}}, "the feed must not be negative", "negative feed");
    return;
  }
  block.modal.feed.known = true;
  block.modal.feed.programmed = feed;
  block.modal.feed.mm = feed * block.length_unit();
}

void take_tool(ActiveBlock& block, CodeNumber) {
  const auto number = block.integer('T', 0, 99999999);
  if (!number) return;
  const ToolWord word = tool_of_word(block, *number);
  const bool known = word.tool == 0 || block.tables.tool(word.tool);
  if (!known) {
    block
        .fail("E5021", {'T', -1, {}}, "the tool table has no tool " + std::to_string(word.tool),
              "unknown tool")
        .help.push_back("enter it with `stanok tool set " + std::to_string(word.tool) +
                        " length 100`, or as a [[tool]] in the tables file");
    return;
  }
  if (word.tool != 0 && word.edge > 1 && !block.tables.tool_edge(word.tool, word.edge)) {
    const std::string tool = std::to_string(word.tool);
    block
        .fail("E5021", {'T', -1, {}}, "tool " + tool + " has no edge " + std::to_string(word.edge),
              "unknown edge")
        .help.push_back(
            "the last two digits are the edge: edge 1 is `T" + tool +
            "01`; with t_format = \"tool_offset\" in the machine file they are an offset");
    return;
  }
  if (word.offset > 0 && !block.tables.tool(word.offset)) {
    block.fail("E5021", {'T', -1, {}},
               "the tool table has no values for offset " + std::to_string(word.offset),
               "unknown offset");
    return;
  }
  block.modal.tool.prepared = word.tool;
  block.queue.emit(ToolPrepare{word.tool});
  if (!changes_at_tool_word(block)) return;
  put_into_spindle(block, word);
  if (word.offset >= 0) return use_tool_offset(block, word.offset, word.offset == 0 ? 0 : 1);
  use_tool_offset(block, word.tool, word.edge);
}

void take_words_before_call(ActiveBlock& block, CodeNumber m_code) {
  if (m_code == m(6) && block.has('T') && !changes_at_tool_word(block)) take_tool(block, m_code);
  if ((m_code == m(3) || m_code == m(4)) && block.has('S')) take_speed(block, m_code);
}

void change_tool(ActiveBlock& block, CodeNumber) {
  if (block.modal.tool.prepared < 0) {
    block
        .fail("E4051", {'M', m(6), {}}, "`M6` has no tool to change to",
              "no T was programmed before")
        .help.push_back("name the tool first, e.g. `T1 M6`");
    return;
  }
  put_into_spindle(block, {block.modal.tool.prepared, 1});
}

// M61: the tool in the spindle is called Q; nothing moves.
void set_tool_number(ActiveBlock& block, CodeNumber) {
  if (!block.has('Q')) {
    block.fail("E4007", {'M', m(61), {}}, "`M61` needs Q, the number of the tool", "no Q");
    return;
  }
  const auto tool = block.integer('Q', 0, 99999999);
  if (!tool) return;
  if (*tool != 0 && !block.tables.tool(*tool)) {
    block.fail("E5021", {'Q', -1, {}}, "the tool table has no tool " + std::to_string(*tool),
               "unknown tool");
    return;
  }
  set_overhang(block, {});
  block.modal.tool.active = *tool;
  block.modal.tool.edge = 1;
  block.queue.emit(ToolChange{*tool, true});
}

void select_feed_mode(ActiveBlock& block, CodeNumber code) {
  if (block.modal.code(Group::feed_mode) == code) return;
  block.modal.feed.known = false;
  block.modal.feed.behind_law = false;
  end_feed_law(block);
}

void select_path_mode(ActiveBlock& block, CodeNumber code) {
  PathControl path;
  if (code == g(64)) {
    path.mode = PathMode::continuous;
    if (block.has('P')) path.tolerance_mm = block.length('P');
    if (block.has('Q')) path.straightening_mm = block.length('Q');
    for (const char letter : {'P', 'Q'}) {
      if (!block.has(letter) || block.value(letter) >= 0.0) continue;
      block.fail("E4008", {letter, -1, {}}, "a tolerance must not be negative", "negative");
      return;
    }
  } else {
    path.mode = code == g(61, 1) ? PathMode::exact_stop : PathMode::exact_path;
  }
  block.modal.path = path;
}

void dwell(ActiveBlock& block, CodeNumber) {
  if (block.dwell_word == 0) {
    block.fail("E4007", {'G', g(4), {}}, "`G4` needs a time", "no P, X, U, F or S")
        .help.push_back("give seconds, e.g. `G4 P0.5`");
    return;
  }
  const bool in_ms = block.dwell_word == 'P';
  double seconds = in_ms ? value_or_thousandths(block, 'P') : block.value(block.dwell_word);
  if (block.dwell_word == 'S') {
    const auto spindle = named_spindle(block);
    if (!spindle) return;
    const double speed = speed_of_spindle(block, *spindle);
    if (speed <= 0.0) {
      block.fail("E4052", {'S', -1, {}}, "a dwell in revolutions needs a spindle speed",
                 "the spindle is stopped");
      return;
    }
    seconds *= 60.0 / speed;
  }
  if (check_dwell(block, block.dwell_word, seconds)) block.queue.emit(Dwell{seconds});
}

bool check_dwell(ActiveBlock& block, char letter, double seconds) {
  constexpr double seconds_max = 1e9;  // 31 years: in cycles a number that can be counted to
  if (seconds >= 0.0 && seconds <= seconds_max) return true;
  const bool negative = seconds < 0.0;
  block.fail("E4008", {letter, -1, {}},
             negative ? "a dwell must not be negative" : "a dwell is at most 1000000000 s",
             negative ? "negative" : "too long");
  return false;
}

void switch_coolant(ActiveBlock& block, CodeNumber code) {
  if (code == m(7)) block.modal.switches.mist = true;
  if (code == m(8)) block.modal.switches.flood = true;
  if (code == m(9)) {
    block.modal.switches.mist = false;
    block.modal.switches.flood = false;
    block.set_modal(Group::flood, code);
  }
  block.queue.emit(CoolantCommand{block.modal.switches.mist, block.modal.switches.flood});
}

void switch_overrides(ActiveBlock& block, CodeNumber code) {
  const bool enabled = code == m(48);
  block.modal.switches.feed_override = enabled;
  block.modal.switches.spindle_override = enabled;
  block.queue.emit(override_control_of(block.modal));
}

// The operator may move the axes while the program stands: the position is read again afterwards.
// Radius compensation needs the blocks behind M0 and M1.
void stop_program(ActiveBlock& block, CodeNumber code) {
  const StopKind kind = code == m(0)   ? StopKind::program_stop
                        : code == m(1) ? StopKind::optional_stop
                                       : StopKind::pallet_stop;
  block.queue.emit(ProgramStop{kind});
  const bool goes_on = block.modal.compensation.on() && kind != StopKind::pallet_stop;
  if (!goes_on) block.queue.emit(ProgramRequest{});
}

void end_program(ActiveBlock& block, CodeNumber code) {
  block.flow.kind = Flow::end_of_program;
  block.flow.end_kind = code == m(2) ? ProgramEndKind::end : ProgramEndKind::end_and_rewind;
}

void call_program(ActiveBlock& block, CodeNumber code) {
  if (!block.has('P')) {
    block
        .fail("E4007", {'M', code, {}}, "`" + code_text('M', code) + "` needs P, a program number",
              "no P")
        .help.emplace_back(
            "text in parentheses is a comment; `call (\"NAME.nc\");` calls a file by its name");
    return;
  }
  block.flow.kind = Flow::call_numbered;
  block.flow.code = code;
}

// M97 P100 L2: N100 of this program up to M99, as on Haas controls.
void call_block(ActiveBlock& block, CodeNumber code) {
  if (!block.has('P')) {
    block.fail("E4007", {'M', code, {}}, "`M97` needs P, a block number", "no P");
    return;
  }
  const auto number = block.integer('P', 0, 99999999);
  const auto repeats = block.has('L') ? block.integer('L', 0, 99999999) : 1;
  if (!number || !repeats) return;
  block.flow.kind = Flow::call_block;
  block.flow.block = *number;
  block.flow.repeats = *repeats;
}

void end_modal_call(ActiveBlock& block, CodeNumber) {
  block.flow.kind = Flow::end_modal_call;
}

void send_machine_function(ActiveBlock& block, CodeNumber code) {
  const UserCode& output = *block.channel_words.dialect().output_code(code);
  if (output.kind == UserCode::Kind::output_switched) return switch_and_wait(block, output);
  MachineFunction function;
  function.code = code / 10;
  if (block.has('P')) function.p = block.value('P');
  if (block.has('Q')) function.q = block.value('Q');
  block.queue.emit(function);
  if (output.waits) block.queue.emit(ProgramRequest{});
}

// M99 P10 goes on with N10 of the caller.
void return_from_program(ActiveBlock& block, CodeNumber) {
  if (block.has('P')) {
    const auto number = block.integer('P', 0, 99999999);
    if (!number) return;
    block.flow.block = *number;
  }
  block.flow.kind = Flow::return_from_subprogram;
}

}  // namespace stanok::lang
