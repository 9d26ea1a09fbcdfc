// The actions of the code table: what each G and M code, F, S and T do to the modal state, and the
// commands they give. One function serves a family of codes and is told which of them it is. The
// functions are in actions_*.cc, a file for each family, beside what they share.
#pragma once

#include <optional>
#include <string>

#include "lang/block/active_block.h"
#include "lang/block/axis_words.h"
#include "lang/block/block_codes.h"
#include "lang/block/feed_law_rules.h"
#include "lang/block/mode_exclusion.h"
#include "lang/feed_law/feed_law_reader.h"
#include "lang/words/code_table.h"
#include "lang/words/named_address.h"

namespace stanok::lang {

// One for each name of the list, which says what codes it serves.
#define CODE_ACTION(name) void name(ActiveBlock& block, CodeNumber code);
#include "lang/words/code_actions.def"
#undef CODE_ACTION

// Feed, speed, tool and machine functions (actions_machine.cc)
// With a program of the machine file for M6, M3 or M4: T or S of the block, which these codes have
// from earlier blocks, too, come into force before the program is called. Where T itself changes
// the tool it is the program's.
void take_words_before_call(ActiveBlock& block, CodeNumber m_code);
// F alone, while no feed law is modal.
void set_feed(ActiveBlock& block);
// False, with the block failed, when `letter` does not hold a dwell of `seconds`.
[[nodiscard]] bool check_dwell(ActiveBlock& block, char letter, double seconds);
// What the modal state says about the overrides, as a command.
[[nodiscard]] OverrideControl override_control_of(const ModalState& modal);

// Feed laws (actions_feed_law.cc)
// What the values of a law in this block depend on.
[[nodiscard]] LawSurroundings law_surroundings(const ActiveBlock& block);
// What the surroundings of a law must be; false, with the block failed at `word`, when they are
// not. `what`: "`n_n` = 500".
[[nodiscard]] bool allows_feed_law(ActiveBlock& block, const WordName& word);
[[nodiscard]] bool spindle_takes_law(ActiveBlock& block, const WordName& word,
                                     const std::string& what);
// The law is the modal one from here on; FeedLaw{}: none is.
void set_feed_law(ActiveBlock& block, FeedLaw law);
void end_feed_law(ActiveBlock& block);

// Spindles (actions_spindle.cc)
void limit_speed(ActiveBlock& block);  // G92 S
// The spindle that $ names, 0 (master) without; fails the block when there is none.
[[nodiscard]] std::optional<int> named_spindle(ActiveBlock& block);
[[nodiscard]] double speed_of_spindle(const ActiveBlock& block, int spindle);
[[nodiscard]] bool spindle_turns(const ActiveBlock& block, int spindle);
[[nodiscard]] bool spindle_has_position(const ActiveBlock& block, int spindle);
void turn_spindle(ActiveBlock& block, int spindle, SpindleAction action);
// Fails the block when the spindle stands.
void check_spindle_turns(ActiveBlock& block, int spindle, CodeNumber code);
// Q of a thread, the angle of the spindle where it begins; fails the block beyond a turn.
[[nodiscard]] double thread_start_angle_deg(ActiveBlock& block);

// Spindles that are axes for a while (actions_spindle_axis.cc)
// Whether a code of the block takes the word H1=, H2=.
[[nodiscard]] bool is_word_of_spindle_axis(const BlockCodes& codes, const NamedWord& word);
[[nodiscard]] bool is_spindle_now(const ActiveBlock& block, AxisIndex axis);
void refuse_axis_that_is_spindle(ActiveBlock& block, AxisIndex axis);
// Fails the block when one of its axis words means an axis that is a spindle now.
void refuse_axes_that_are_spindles(ActiveBlock& block);
// Fails the block, and returns true, when the spindle (0: master, -1: any) is an axis now.
bool refuse_spindle_that_is_axis(ActiveBlock& block, int spindle, const WordName& word);

// Thread cycle of lathe channels (actions_thread_cycle.cc)
void cut_thread_in_passes(ActiveBlock& block, CodeNumber code);  // G76

// Table input (actions_table.cc)
// An axis word as it is written, without the halving of diameter mode: what goes into tables.
[[nodiscard]] double table_value(const ActiveBlock& block, AxisIndex axis);

// Writing of rows of the tables: requests, which the machine answers.
// `parameter` is its name in the tool table.
void write_tool(ActiveBlock& block, int tool, std::string_view parameter, double value,
                int edge = 1);
// Of the channel's own table.
void write_offset(ActiveBlock& block, int page, std::string_view parameter, int axis, double value);

// Fails the block when the table does not have the tool.
[[nodiscard]] std::optional<int> table_tool(ActiveBlock& block, int number);

// G10 of the Fanuc dialect.
void write_fanuc_table(ActiveBlock& block);

// Reference points (actions_reference.cc)
// Where the axes stand in M; not under TCP.
[[nodiscard]] AxisValues machine_position(const ActiveBlock& block);

// Parts that all changes of the frame share.

// Parts of a saved state.
void restore_feed_law(ActiveBlock& block, const ModalState& saved);  // and F
void restore_work_offset(ActiveBlock& block, const ModalState& saved);
void restore_shifts(ActiveBlock& block, const ModalState& saved);  // G52, G92, G68, G51, G51.1
void restore_spindle_mode(ActiveBlock& block, const ModalState& saved);
void restore_length(ActiveBlock& block, const ToolLength& saved);
void restore_overhang(ActiveBlock& block, const ModalState& saved);
// Makes work offset `number` of the tables the active one, as far as it exists there.
void take_work_offset(ModalState& modal, const Tables& tables, int number);
// The same for axes that stand at `position_B`, or will: where a table carries the offset (G54.2).
void take_work_offset(ModalState& modal, const Tables& tables, int number,
                      const AxisValues& position_B);
// Under G54.2 the work offset goes where the table has carried it, or will with the axes at
// `position_B`; the point stays where it is in B.
void follow_table(ActiveBlock& block);
void follow_table(ActiveBlock& block, const AxisValues& position_B);
// Tells the channel the frame after a change; the point stays where it is in B.
void publish_frame(ActiveBlock& block, const WorkFrame& before, int work_offset_before);
void publish_frame(ActiveBlock& block, const WorkFrame& before);

// Tool overhang (actions_overhang.cc)
struct ToolOverhang {
  int axis = -1;  // of the channel; -1: the one of the tool table
  double value_mm = 0.0;
};
// The counter of the axis changes by the difference of the overhangs; no motion.
void set_overhang(ActiveBlock& block, const ToolOverhang& overhang);
[[nodiscard]] double overhang_in_force(const BlockSurroundings& around);

// Tilted planes
// The programmed point is the tool tip, led through the rotary axes, from here on or no longer: as
// the plane and the code of the tool length say (actions_length.cc).
void follow_alignment(ActiveBlock& block);
// Ends `move` with these angles; false: an axis is a spindle now, and the block has failed.
bool turn_axes(ActiveBlock& block, const Alignment& found, Move& move);
// Fails the block: a plane is begun and not said to its end (actions_rotation.cc).
void fail_open_plane(ActiveBlock& block, const WordName& word);

// Tool length (actions_length.cc)
// Length compensation of an edge from here on; edge 0: none.
void use_tool_offset(ActiveBlock& block, int tool, int edge);
// The length as its row of the table is now.
void take_row(ToolLength& length, const Tables& tables);

// Radius compensation (actions_compensation.cc)
// Fails the block when radius compensation is active and forbids one of its codes, the modally
// active motion among them.
void refuse_while_compensated(ActiveBlock& block, const BlockCodes& codes);

// Tool whose radius counts: D, else the last D of the Fanuc dialect or the active edge. Nothing,
// with the block failed, when the table does not have it.
[[nodiscard]] std::optional<Tool> tool_of_radius(ActiveBlock& block, CodeNumber code);

// Parts of a motion shared by its kinds.

// False, with the block failed, when axis words are programmed that are not `allowed`.
[[nodiscard]] bool only_axes(ActiveBlock& block, CodeNumber code, AxisSet allowed);
// The ends of the programmed axes, absolute in W (M under G53); others stay where they are.
void resolve_ends(const ActiveBlock& block, Move& move);
// Feed and path mode; fails the block when a feed is missing.
void resolve_feed(ActiveBlock& block, Move& move);
// The same, in a block without a feed law of its own.
void resolve_modal_feed(ActiveBlock& block, Move& move);
// The motion that goes on behind a drilling cycle, or is active.
[[nodiscard]] CodeNumber motion_behind_cycle(const ModalState& modal);
// Puts the programmed point to the end of `move`.
void advance_position(ActiveBlock& block, const Move& move);

}  // namespace stanok::lang
