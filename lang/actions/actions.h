// The actions of the code table: what each G and M code, F, S and T do to the modal state, and the
// commands they give. One function serves a family of codes and is told which of them it is.
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

// Feed, speed, tool and machine functions (actions_machine.cc)
void take_feed(ActiveBlock& block, CodeNumber);
// F alone, while no feed law is modal.
void set_feed(ActiveBlock& block);
void take_tool(ActiveBlock& block, CodeNumber);
void select_feed_mode(ActiveBlock& block, CodeNumber code);  // G93 G94 G95
void select_path_mode(ActiveBlock& block, CodeNumber code);  // G60 G61 G61.1 G64
void dwell(ActiveBlock& block, CodeNumber code);             // G4
// False, with the block failed, when `letter` does not hold a dwell of `seconds`.
[[nodiscard]] bool check_dwell(ActiveBlock& block, char letter, double seconds);
void change_tool(ActiveBlock& block, CodeNumber code);          // M6
void set_tool_number(ActiveBlock& block, CodeNumber code);      // M61
void switch_coolant(ActiveBlock& block, CodeNumber code);       // M7 M8 M9
void switch_overrides(ActiveBlock& block, CodeNumber code);     // M48 M49
void switch_override(ActiveBlock& block, CodeNumber code);      // M50 M51 M52 M53
void stop_program(ActiveBlock& block, CodeNumber code);         // M0 M1 M60
void end_program(ActiveBlock& block, CodeNumber code);          // M2 M30
void call_program(ActiveBlock& block, CodeNumber code);         // M98 M198
void return_from_program(ActiveBlock& block, CodeNumber code);  // M99 M17
// M100 to M899 that the machine file declares as outputs.
void send_machine_function(ActiveBlock& block, CodeNumber code);
// Saved modal state (actions_state.cc)
void save_state(ActiveBlock& block, CodeNumber code);           // M70 M73
void drop_state(ActiveBlock& block, CodeNumber code);           // M71
void restore_saved_state(ActiveBlock& block, CodeNumber code);  // M72
// For codes whose whole effect is that they are the active code of their group.
void only_modal(ActiveBlock& block, CodeNumber code);

// What the modal state says about the overrides, as a command.
[[nodiscard]] OverrideControl override_control_of(const ModalState& modal);

// Feed laws (actions_feed_law.cc)
void take_feed_law(ActiveBlock& block, CodeNumber);  // S_n, dS, dl, ...
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

// Inputs and outputs (actions_signal.cc)
void switch_output(ActiveBlock& block, CodeNumber code);      // M62 M63 M64 M65
void set_analog_output(ActiveBlock& block, CodeNumber code);  // M67 M68
void wait_for_input(ActiveBlock& block, CodeNumber code);     // M66

// Spindles (actions_spindle.cc)
void take_speed(ActiveBlock& block, CodeNumber);                // S, S2=
void switch_spindle(ActiveBlock& block, CodeNumber code);       // M3 M4 M5
void orient_spindle(ActiveBlock& block, CodeNumber code);       // M19
void select_spindle_mode(ActiveBlock& block, CodeNumber code);  // G96 G97
void limit_speed(ActiveBlock& block);                           // G92 S
// The spindle that $ names, 0 (master) without; fails the block when there is none.
[[nodiscard]] std::optional<int> named_spindle(ActiveBlock& block);
[[nodiscard]] double speed_of_spindle(const ActiveBlock& block, int spindle);
[[nodiscard]] bool spindle_turns(const ActiveBlock& block, int spindle);
[[nodiscard]] bool spindle_has_position(const ActiveBlock& block, int spindle);
void turn_spindle(ActiveBlock& block, int spindle, SpindleAction action);
// Fails the block when the spindle stands.
void check_spindle_turns(ActiveBlock& block, int spindle, CodeNumber code);

// Spindles that are axes for a while (actions_spindle_axis.cc)
void make_axis_of_spindle(ActiveBlock& block, CodeNumber code);  // M902
void make_spindle_of_axis(ActiveBlock& block, CodeNumber code);  // M903
// Whether a code of the block takes the word H1=, H2=.
[[nodiscard]] bool is_word_of_spindle_axis(const BlockCodes& codes, const NamedWord& word);
[[nodiscard]] bool is_spindle_now(const ActiveBlock& block, std::size_t axis);
void refuse_axis_that_is_spindle(ActiveBlock& block, std::size_t axis);
// Fails the block when one of its axis words means an axis that is a spindle now.
void refuse_axes_that_are_spindles(ActiveBlock& block);
// Fails the block, and returns true, when the spindle (0: master, -1: any) is an axis now.
bool refuse_spindle_that_is_axis(ActiveBlock& block, int spindle, const WordName& word);

// Threads by single blocks (actions_thread.cc)
void cut_thread(ActiveBlock& block, CodeNumber code);   // G33 G32
void tap_rigidly(ActiveBlock& block, CodeNumber code);  // G33.1

// Cycles of lathe channels (actions_turning.cc, actions_thread_cycle.cc, actions_roughing.cc)
void rough_contour(ActiveBlock& block, CodeNumber code);         // G71 G72; G71 on a mill: mm
void finish_contour(ActiveBlock& block, CodeNumber code);        // G70; on a mill: inch
void turn_once(ActiveBlock& block, CodeNumber code);             // G77 G78 G79
void cut_thread_in_passes(ActiveBlock& block, CodeNumber code);  // G76

// Frames (actions_frame.cc)
void select_work_offset(ActiveBlock& block, CodeNumber code);  // G54 ... G59.3 G54.1
void shift_locally(ActiveBlock& block, CodeNumber code);       // G52
void shift_axes(ActiveBlock& block, CodeNumber code);          // G92 G92.1 G92.2 G92.3

// Rotation, scaling and mirror (actions_rotation.cc, actions_scaling.cc)
void rotate_system(ActiveBlock& block, CodeNumber code);    // G68
void cancel_rotation(ActiveBlock& block, CodeNumber code);  // G69
void scale_axes(ActiveBlock& block, CodeNumber code);       // G51
void cancel_scaling(ActiveBlock& block, CodeNumber code);   // G50
void mirror_axes(ActiveBlock& block, CodeNumber code);      // G51.1
void cancel_mirror(ActiveBlock& block, CodeNumber code);    // G50.1

// Table input (actions_table.cc)
// An axis word as it is written, without the halving of diameter mode: what goes into tables.
[[nodiscard]] double table_value(const ActiveBlock& block, std::size_t axis);
void write_table(ActiveBlock& block, CodeNumber code);  // G10

// Reference points (actions_reference.cc)
void go_to_reference_point(ActiveBlock& block, CodeNumber code);  // G28 G30
void store_reference_point(ActiveBlock& block, CodeNumber code);  // G28.1 G30.1
// Where the axes stand in M; not under TCP.
[[nodiscard]] AxisValues machine_position(const ActiveBlock& block);

// Transformations (actions_transformation.cc)
void select_polar_face(ActiveBlock& block, CodeNumber code);      // G12.1
void select_cylinder(ActiveBlock& block, CodeNumber code);        // G7.1
void cancel_transformation(ActiveBlock& block, CodeNumber code);  // G13.1

// Parts that all changes of the frame share.

// Parts of a saved state.
void restore_feed_law(ActiveBlock& block, const ModalState& saved);  // and F
void restore_work_offset(ActiveBlock& block, const ModalState& saved);
void restore_shifts(ActiveBlock& block, const ModalState& saved);  // G52, G92, G68, G51, G51.1
void restore_spindle_mode(ActiveBlock& block, const ModalState& saved);
void restore_length(ActiveBlock& block, const ToolLength& saved);
void restore_overhang(ActiveBlock& block, const ModalState& saved);
// The frame as it is now, as a command.
[[nodiscard]] FrameChange frame_of(const ModalState& modal);
// Makes work offset `number` of the tables the active one, as far as it exists there.
void take_work_offset(ModalState& modal, const Tables& tables, int number);
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

// Tool length (actions_length.cc)
void compensate_length(ActiveBlock& block, CodeNumber code);  // G43 G43.1 G43.2 G43.4 G44 G49
// Length compensation of an edge from here on; edge 0: none.
void use_tool_offset(ActiveBlock& block, int tool, int edge);
// The tool table may have changed.
void read_tool_length_again(ActiveBlock& block);

// Radius compensation (actions_compensation.cc)
void select_compensation(ActiveBlock& block, CodeNumber code);  // G40 G41 G41.1 G42 G42.1
// Fails the block when radius compensation is active and forbids one of its codes, the modally
// active motion among them.
void refuse_while_compensated(ActiveBlock& block, const BlockCodes& codes);

// Motion (actions_motion.cc, actions_arc.cc)
void stop_at_block_end(ActiveBlock& block, CodeNumber code);        // G9
void move_in_cubic(ActiveBlock& block, CodeNumber code);            // G5 (actions_spline.cc)
void move_in_quadratic(ActiveBlock& block, CodeNumber code);        // G5.1
void collect_nurbs_point(ActiveBlock& block, CodeNumber code);      // G5.2
void end_nurbs(ActiveBlock& block, CodeNumber code);                // G5.3
void accept_high_speed(ActiveBlock& block, CodeNumber code);        // G5 P, G5.1 Q
void probe(ActiveBlock& block, CodeNumber code);                    // G38.2 ... (actions_probe.cc)
void use_machine_coordinates(ActiveBlock& block, CodeNumber code);  // G53
void move_straight(ActiveBlock& block, CodeNumber code);            // G0 G1
void move_in_arc(ActiveBlock& block, CodeNumber code);              // G2 G3

// Drilling and boring cycles (actions_cycle.cc)
void drill_hole(ActiveBlock& block, CodeNumber code);      // G73 G74 G76 G81 to G86 G89
void bore_or_thread(ActiveBlock& block, CodeNumber code);  // G76: by the kind of the channel

// Parts of a motion shared by its kinds.

// False, with the block failed, when axis words are programmed that are not `allowed`.
[[nodiscard]] bool only_axes(ActiveBlock& block, CodeNumber code, AxisSet allowed);
// The ends of the programmed axes, absolute in W (M under G53); others stay where they are.
void resolve_ends(const ActiveBlock& block, Move& move);
// Feed and path mode; fails the block when a feed is missing.
void resolve_feed(ActiveBlock& block, Move& move);
// The same, in a block without a feed law of its own.
void resolve_modal_feed(ActiveBlock& block, Move& move);
// Tool length along an axis, as far as it lies between the axis and the programmed point, mm.
[[nodiscard]] double length_along(const ActiveBlock& block, const AxisDescription& axis);
// Puts the programmed point to the end of `move`.
void advance_position(ActiveBlock& block, const Move& move);

}  // namespace stanok::lang
