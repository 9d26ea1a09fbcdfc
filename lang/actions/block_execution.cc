#include "lang/actions/block_execution.h"

#include <algorithm>
#include <utility>

#include "lang/actions/action_table.h"
#include "lang/actions/actions.h"
#include "lang/block/block_check.h"
#include "lang/block/other_controls.h"
#include "lang/corners/corner_stage.h"
#include "lang/corners/corner_value.h"
#include "lang/corners/corner_words.h"
#include "lang/corners/line_angle.h"
#include "lang/orientation/set_up_angles.h"
#include "lang/orientation/tool_orientation.h"
#include "lang/words/corner_word.h"
#include "lang/words/law_address.h"
#include "lang/words/polar_word.h"

namespace stanok::lang {
namespace {

constexpr LetterSet arc_words = letters_of("IJKR");

// Units and diameter mode set in a block hold for its own words too.
void apply_units(ActiveBlock& block, const BlockCodes& codes) {
  const bool has_cycles = block.channel.kind == ChannelKind::lathe || block.words.rules.is_haas();
  if (!has_cycles && block.words.g.has(g(70))) block.set_modal(Group::units, g(20));
  if (!has_cycles && block.words.g.has(g(71))) block.set_modal(Group::units, g(21));
  for (const Code* const row : codes) {
    const bool early = row->group == Group::units || row->group == Group::diameter;
    if (early && block.modal.code(row->group) != row->number)
      block.set_modal(row->group, row->number);
  }
}

AxisWordCount axis_words_of(const ActiveBlock& block) {
  return block.programmed != 0 ? AxisWordCount::some : AxisWordCount::none;
}

// G80 with axis words in the Fanuc dialect: the motion from before the cycle takes them.
bool is_end_of_cycle_with_motion(const ActiveBlock& block, const BlockCodes& codes) {
  return block.words.rules.is_fanuc() && block.words.g.has(g(80)) && codes.has(Group::motion) &&
         motion_of(codes)->action == CodeAction::end_cycle;
}

// The modally active motion takes the axis words that no code of the block claims.
void add_modal_motion(ActiveBlock& block, BlockCodes& codes, LetterSet free_words) {
  if (codes.axis_user != nullptr) return;
  const bool ends_cycle = is_end_of_cycle_with_motion(block, codes);
  if (codes.has(Group::motion) && block.programmed != 0 && !ends_cycle) {
    const Code& row = *motion_of(codes);
    block.fail("E4012", {row.letter, row.number, {}},
               "`" + code_text(row.letter, row.number) + "` takes no axis words", "");
    return;
  }
  const CodeNumber number =
      ends_cycle ? motion_behind_cycle(block.modal) : block.modal.code(Group::motion);
  const bool arc = number == g(2) || number == g(3);
  const bool by_vector = (number == g(0) || number == g(1)) &&
                         block.modal.code(Group::length) == g(43, 5) &&
                         (free_words & vector_letters) != 0;
  const bool knot = number == g(6, 2) && block.modal.curve.open();
  const bool moves =
      block.programmed != 0 || by_vector || knot || (arc && (free_words & arc_words) != 0);
  if (!moves) return;
  const Code* const motion = find_code('G', number);
  if (motion->axes == AxisWords::unused) {
    BlockFault& fault =
        block.fail("E4012", {}, "axis words need a motion code", "no motion is active");
    fault.notes.push_back(block.modal.origin_of(Group::motion));
    return;
  }
  codes.add(motion);
  codes.words |= words_of_code(*motion, &block.channel.kind, block.words.rules);
  codes.axis_user = motion;
}

// Increments are ways to go: other codes than motions have no use for them.
void check_incremental_words(ActiveBlock& block, const BlockCodes& codes) {
  if (block.incremental == 0 || codes.axis_user == nullptr) return;
  const Code& user = *codes.axis_user;
  const bool moves =
      user.order == EffectOrder::motion || user.action == CodeAction::go_to_reference_point;
  if (moves) return;
  const char letter = first_letter(block.words.letters & block.channel_words.incremental_letters());
  block.fail("E4302", {letter, -1, {}},
             "`" + code_text('G', user.number) + "` cannot take the increment `" + letter + "`",
             "not here");
}

bool belongs_to(const ProgrammedCurve& curve, CodeAction action) {
  if (curve.has_knots()) return action == CodeAction::collect_knot;
  return action == CodeAction::collect_nurbs_point || action == CodeAction::end_nurbs;
}

// Between G5.2 and G5.3, and up to the last knot of G6.2, there are control points, nothing else.
void check_open_curve(ActiveBlock& block, const BlockCodes& codes) {
  const ProgrammedCurve& curve = block.modal.curve;
  if (!curve.open()) return;
  for (const Code* const row : codes) {
    if (belongs_to(curve, row->action)) continue;
    BlockFault& fault =
        block.fail("E4312", {row->letter, row->number, {}},
                   "`" + code_text(row->letter, row->number) + "` inside a NURBS curve",
                   "the curve has not ended");
    fault.notes.push_back(block.modal.origin_of(Group::motion));
    fault.help.push_back(curve.has_knots()
                             ? "end the curve first: " + std::to_string(curve.knots_to_come()) +
                                   " knots are missing, each `K` in a block of its own"
                             : "end the curve with `G5.3` first");
    return;
  }
}

// Under G54.2 lines alone turn the table: their ends are where it will have carried the offset.
// True: the block has failed.
bool turns_table_otherwise(ActiveBlock& block, const BlockCodes& codes) {
  const bool turns = (block.programmed & ~block.channel_words.linear_axes()) != 0;
  if (!block.modal.frames.is_carried || !turns || codes.axis_user == nullptr) return false;
  const Code& user = *codes.axis_user;
  const bool is_other =
      user.order == EffectOrder::motion && user.action != CodeAction::move_straight;
  return is_other && excluded_by_mode(block, user.number, {Exclusion::carried_offset}, user.letter);
}

// Under G54.4 with turns the control finds the angles of rotary axes for lines under G43.4 and
// G43.5 alone. True: the block has failed.
bool turns_against_set_up(ActiveBlock& block, const BlockCodes& codes) {
  const FrameSettings& frames = block.modal.frames;
  if (!frames.set_up.turns() || codes.axis_user == nullptr || block.words.g.has(g(53)))
    return false;
  const Code& user = *codes.axis_user;
  if (user.order != EffectOrder::motion) return false;
  const bool is_led = corrects_angles(block);
  const bool turns = (block.programmed & ~block.channel_words.linear_axes()) != 0 ||
                     (is_led && !frames.set_up_angles.are_known);
  if (!turns || (is_led && user.action == CodeAction::move_straight)) return false;
  block
      .fail("E4301", {user.letter, user.number, {}},
            "rotary axes cannot turn here while `G54.4` turns the workpiece", "not in this mode")
      .help.emplace_back(
          "turn them with G0 or G1 under `G43.4` or `G43.5`, which compute the angles, or end "
          "`G54.4` with P0 first");
  return true;
}

// Between the blocks of a plane that points or vectors give there is nothing else.
void check_open_plane(ActiveBlock& block, const BlockCodes& codes) {
  if (!block.modal.frames.definition.is_open()) return;
  for (const Code* const row : codes) {
    if (row->action == CodeAction::tilt_plane) continue;
    return fail_open_plane(block, {row->letter, row->number, {}});
  }
}

// A word has one meaning: two codes that use the same letter need a block each. F, S and T are not
// in question, nor are axis words; functions of the machine builder share P and Q.
void check_shared_words(ActiveBlock& block, const BlockCodes& codes) {
  LetterSet taken = 0;
  for (const Code* const row : codes) {
    if (row->action == CodeAction::send_machine_function) continue;
    const LetterSet wanted = row->words & block.words.letters & ~always_allowed;
    if (const LetterSet both = taken & wanted; both != 0) {
      const char letter = first_letter(both);
      block
          .fail("E4015", {letter, -1, {}},
                std::string("`") + letter + "` would be used by two codes of the block",
                "it is not clear which one")
          .help.push_back("program `" + code_text(row->letter, row->number) +
                          "` in a block of its own");
      return;
    }
    taken |= wanted;
  }
}

void check_unused(ActiveBlock& block, const BlockCodes& codes) {
  LetterSet allowed = codes.words | allowed_everywhere(block.words.rules) |
                      block.channel_words.letters() | block.channel_words.incremental_letters();
  if (block.dwell_word != 0) allowed |= letter_bit(block.dwell_word);
  allowed |= block.end.plain_corners;
  const LetterSet unused = block.words.letters & ~allowed;
  if (unused != 0) {
    const BlockFault fault = unused_word(unused, &block.channel);
    block.fail(fault.code, fault.word, fault.message, fault.label).notes = fault.notes;
    return;
  }
  const bool turns_spindle = block.has('S') || names_spindle(codes);
  if (block.words.spindle_named && !turns_spindle) {
    block.fail("E4003", {}, "nothing in this block uses the spindle after `$`", "unused word");
  }
  for (const NamedWord& word : block.words.named) {
    if (block.channel_words.axis_called(word.name).exists()) continue;
    if (spindle_of_indexed_speed(word) || is_word_of_spindle_axis(codes, word)) continue;
    if (is_law_address(word.name) || is_corner_word(word.name)) continue;
    if (is_polar_word(word.name)) continue;
    block.fail("E4003", {0, -1, word.name}, "nothing in this block uses `" + word.name + "`",
               "unused word");
  }
}

// D of the Fanuc dialect, unless a code of the block has another use for it.
void keep_offset_of_radius(ActiveBlock& block, const BlockCodes& codes) {
  if (!block.words.rules.is_fanuc() || !block.has('D')) return;
  const bool compensates = block.words.g.has(g(41)) || block.words.g.has(g(42));
  if (!compensates && (codes.words & letters_of("D")) != 0) return;
  if (const auto number = block.integer('D', 0, 99999999)) block.modal.tool.radius_offset = *number;
}

// H alone under G43 or G44 in the Fanuc dialect: the length of another offset from here on.
void add_modal_length(ActiveBlock& block, BlockCodes& codes) {
  const CodeNumber length = block.modal.code(Group::length);
  const bool is_free = block.words.rules.is_fanuc() && block.has('H') &&
                       (codes.words & letters_of("H")) == 0 && !codes.has(Group::length);
  if (!is_free || (length != g(43) && length != g(44))) return;
  codes.add(find_code('G', length));
  codes.groups |= group_bit(Group::length);
  codes.words |= letters_of("H");
}

// In the order in which they take effect; codes of one rank stay as written.
void sort_by_phase(BlockCodes& codes) {
  for (const Code** next = codes.begin(); next != codes.end(); ++next) {
    const Code** const later =
        std::upper_bound(codes.begin(), next, *next,
                         [](const Code* a, const Code* b) { return a->order < b->order; });
    std::rotate(later, next, next + 1);
  }
}

void run_actions(ActiveBlock& block, BlockCodes& codes) {
  sort_by_phase(codes);
  for (std::size_t i = block.done.actions; i < codes.count && !block.failed(); ++i) {
    const Code& row = *codes.rows[i];
    if (&row == codes.axis_user) {
      take_polar_words(block, row);
      take_line_angle(block);
    }
    if (block.failed()) return;
    block.done.actions = i + 1;
    if (&row != codes.resting_motion) function_of(row.action)(block, row.number);
    const bool kept = (group_bit(row.group) & block.kept_groups) != 0;
    if (block.done.actions == i) return;
    block.done.parts = 0;
    if (row.group != Group::none && !kept && block.modal.code(row.group) != row.number) {
      block.set_modal(row.group, row.number);
    }
    if (block.awaits_position && block.done.actions < codes.count) return;
  }
  block.awaits_position = false;
}

}  // namespace

void execute_block(ActiveBlock& block) {
  follow_table(block);
  BlockCodes codes;
  if (auto fault =
          resolve_codes(block.words, &block.channel.kind, block.channel_words.dialect(), codes)) {
    block.faults.first = std::move(fault);
    return;
  }
  if (auto fault = check_master(block.words, block.channel)) {
    block.faults.first = std::move(fault);
    return;
  }
  block.dwell_word = dwell_word(block.words, codes);
  refuse_while_compensated(block, codes);
  if (block.failed()) return;
  apply_units(block, codes);
  collect_axis_words(block);
  collect_incremental_words(block, codes);
  collect_polar_words(block);
  find_plain_corners(block, codes);
  collect_line_angle(block);
  refuse_axes_that_are_spindles(block);
  if (block.failed()) return;
  if (auto fault = missing_axes(codes, axis_words_of(block))) {
    block.faults.first = std::move(fault);
    return;
  }
  if (auto fault = other_meaning(
          {block.words, codes, block.channel.kind, block.programmed != 0, &block.modal})) {
    block.faults.first = std::move(fault);
    return;
  }
  add_modal_motion(block, codes, block.words.letters & ~codes.words);
  add_modal_length(block, codes);
  if (block.failed()) return;
  if (auto fault = check_feed_law(block.words, codes, axis_words_of(block))) {
    block.faults.first = std::move(fault);
    return;
  }
  check_unused(block, codes);
  check_shared_words(block, codes);
  check_incremental_words(block, codes);
  check_open_curve(block, codes);
  check_open_plane(block, codes);
  if (turns_table_otherwise(block, codes) || turns_against_set_up(block, codes) || block.failed())
    return;
  block.flow.moves = block.programmed != 0 && codes.axis_user != nullptr &&
                     codes.axis_user->order == EffectOrder::motion;
  check_line_angle(block, codes.axis_user);
  read_corner(block);
  if (block.failed()) return;
  keep_offset_of_radius(block, codes);
  add_feed_speed_tool(block, codes);
  run_actions(block, codes);
}

namespace {

// A move that turns rotary axes may do more than go there.
bool turns_specially(const ActiveBlock& block) {
  return block.modal.frames.is_carried || block.modal.frames.set_up.turns() ||
         (block.modal.tool.turning == TurningWay::vector &&
          (block.programmed & ~block.channel_words.linear_axes()) != 0);
}

}  // namespace

bool execute_simple_move(ActiveBlock& block, Move& move) {
  const BlockWords& words = block.words;
  CodeNumber motion = block.modal.code(Group::motion);
  if (words.m.count != 0 || words.g.count > 1 || !words.named.empty()) return false;
  if (block.modal.curve.open()) return false;
  if (words.g.count == 1) motion = words.g.numbers[0];
  if (motion != g(0) && motion != g(1)) return false;
  if (block.modal.code(Group::polar) != g(15)) return false;
  if (block.modal.frames.definition.is_open()) return false;
  const LetterSet axes = words.letters & block.channel_words.letters();
  if (axes == 0 || (words.letters & ~(axes | letter_bit('F'))) != 0) return false;
  if (words.has('F')) {
    if (words.value('F') <= 0.0 || block.modal.feed.law.kind != FeedLaw::Kind::off) return false;
    set_feed(block);
  } else if (motion == g(1) && (!block.modal.feed.known || block.modal.feed.programmed <= 0.0)) {
    return false;
  }
  collect_axis_words(block);
  refuse_axes_that_are_spindles(block);
  if (block.failed() || turns_specially(block)) return false;
  move = {};
  move.kind = motion == g(0) ? MoveKind::rapid : MoveKind::line;
  resolve_ends(block, move);
  resolve_modal_feed(block, move);
  if (block.failed()) return false;
  advance_position(block, move);
  if (block.modal.code(Group::motion) != motion) block.set_modal(Group::motion, motion);
  return true;
}

namespace {

void forget_compensation(ModalState& modal, std::uint32_t line) {
  modal.compensation = {};
  modal.set(Group::radius_compensation, g(40), line);
}

std::string in_line(std::uint32_t line, const std::string& why) {
  return "line " + std::to_string(line) + ": " + why;
}

void take_all(CommandQueue& queue, ContourCommands& made) {
  Command command;
  while (!queue.empty()) {
    queue.take(command);
    made.commands.push_back(command);
  }
}

void cut_corners(CommandQueue& queue, CornerStage& corners, ContourCommands& made) {
  Command command;
  while (!queue.empty() && made.problem.empty()) {
    queue.take(command);
    const auto fault = corners.take(command);
    if (fault) made.problem = in_line(fault->origin.line, fault->fault.message);
  }
}

}  // namespace

ContourCommands commands_of(ActiveBlock& block, const Contour& contour, ModalState modal) {
  forget_compensation(modal, block.line);
  CommandQueue queue;
  CornerStage corners(block.channel_words);
  ContourCommands made;
  for (const Contour::Block& one : contour.blocks) {
    const BlockSurroundings around{modal, block.channel_words, block.channel, block.tables,
                                   queue, block.probe,         block.states,  nullptr};
    queue.set_origin(one.origin, 0);
    const AxisValues start_W = modal.position_W;
    ActiveBlock inner(one.words, around, one.origin.line);
    execute_block(inner);
    forget_compensation(modal, block.line);
    if (inner.awaits_position) {
      made.problem = "TCP (RTCP) is switched in line " + std::to_string(one.origin.line);
    } else if (inner.faults.first) {
      made.problem = in_line(one.origin.line, inner.faults.first->message);
    } else {
      corners.select(inner.end.corner, modal.plane(), start_W);
      cut_corners(queue, corners, made);
      take_all(corners.ready(), made);
    }
    if (!made.problem.empty()) return made;
  }
  if (corners.awaits_end()) made.problem = "the last line is given by its angle and has no end";
  corners.finish();
  take_all(corners.ready(), made);
  return made;
}

}  // namespace stanok::lang
