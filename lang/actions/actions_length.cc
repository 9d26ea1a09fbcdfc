// Actions of tool length compensation: G43, G43.1, G43.2, G43.4, G43.5, G44, G49, and the offset of
// a T word on lathe channels; of the alignment of the tool with a tilted plane: G53.1, G53.6.
//
// The length in force stays as it was put there until the next code of the group, whatever is
// written into the tool table meanwhile. While the tool is aligned with a plane the programmed
// point is its tip as under G43.4, whatever code of the group is active: only so the coordinates of
// the plane stand where the workpiece is.
//
// On Fanuc controls a length is added to the end of the block that says it, in G91, too: what comes
// into force is a part of the way of that block. Source: operator's manual B-64304EN, tool length
// offset, with its example of boring. Elsewhere an increment counts from where the tool stands.
#include <algorithm>
#include <cmath>
#include <string>

#include "lang/actions/actions.h"
#include "lang/orientation/set_up_angles.h"
#include "lang/orientation/tool_orientation.h"

namespace stanok::lang {
namespace {

void change_length(ActiveBlock& block, const ToolLength& wanted) {
  ToolLength after = block.tables.in_force(wanted);
  if (block.modal.frames.plane.is_aligned) after.mode = LengthMode::tip;
  const ToolLength before = block.tables.in_force(block.modal.tool.length);
  if (before == after) return;
  block.modal.tool.length = after;
  block.queue.emit(after);
  if (before.mode == LengthMode::tip || after.mode == LengthMode::tip) {
    block.queue.emit(ProgramRequest{});
    block.awaits_position = true;
    return;
  }
  AxisValues distance_B{};
  for (std::size_t k = 0; k < block.channel.axes.size(); ++k) {
    distance_B[k] =
        length_along(block, k, before.offset_mm) - length_along(block, k, after.offset_mm);
  }
  block.modal.shift_position(distance_B);
}

bool is_incremental_block(const ActiveBlock& block) {
  return block.words.g.has(g(91)) || (block.modal.incremental() && !block.words.g.has(g(90)));
}

// By G43, G44 and G49, and H under them.
void change_length_of_block(ActiveBlock& block, const ToolLength& after) {
  const AxisValues before_W = block.modal.position_W;
  change_length(block, after);
  const bool travels =
      block.words.rules.is_fanuc() && block.flow.moves && is_incremental_block(block);
  if (!travels || block.awaits_position) return;
  for (const AxisIndex axis : block.modal.geometry) {
    if (axis.exists())
      block.end.length_travel_W[axis] = before_W[axis] - block.modal.position_W[axis];
  }
}

// Edge whose length counts: that of the tool H names, the active one without H. For LinuxCNC H0
// names the tool in the spindle, too.
struct LengthSource {
  int tool = 0;
  int edge = 1;
};

std::optional<LengthSource> length_source(ActiveBlock& block) {
  LengthSource source{block.modal.tool.active, std::max(block.modal.tool.edge, 1)};
  if (block.has('H')) {
    const auto named = block.integer('H', 0, 99999999);
    if (!named) return std::nullopt;
    const bool in_spindle = *named == 0 && block.words.rules.is_linuxcnc();
    if (!in_spindle) source = {*named, 1};
  }
  if (source.tool == 0 || block.tables.tool_edge(source.tool, source.edge)) return source;
  block.fail("E5021", {block.has('H') ? 'H' : 'G', block.has('H') ? -1 : 430, {}},
             "the tool table has no tool " + std::to_string(source.tool), "unknown tool");
  return std::nullopt;
}

using Offset = std::array<double, 3>;

ToolLength length_of_row(const ActiveBlock& block, const LengthSource& source, CodeNumber code,
                         const Offset& base) {
  ToolLength length;
  length.mode = leads_tip(code) ? LengthMode::tip : LengthMode::length;
  length.tool = source.tool;
  length.edge = source.edge;
  length.base_mm = base;
  if (source.tool != 0)
    length.row = code == g(44) ? ToolLength::Row::subtracted : ToolLength::Row::added;
  take_row(length, block.tables);
  return length;
}

void set_by_axis_words(ActiveBlock& block) {
  ToolLength length;
  length.mode = LengthMode::length;
  length.tool = block.modal.tool.active;
  length.offset_mm = block.modal.tool.length.offset_mm;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.channel_words.geometry_axis(k);
    if (is_programmed(block, axis)) length.offset_mm[k] = table_value(block, axis);
  }
  change_length(block, length);
}

// The first rotary axis that turns tool or workpiece without being taken into account for the tip.
std::optional<AxisIndex> axis_not_led(const ActiveBlock& block) {
  const AxisSet led = block.tables.leading_axes();
  const AxisSet taking_part = block.tables.axes_of_scheme();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    const bool turns = block.channel.axes[i].rotary && (taking_part & axis_bit(i)) != 0 &&
                       !is_spindle_now(block, i);
    if (turns && (led & axis_bit(i)) == 0) return i;
  }
  return std::nullopt;
}

bool can_lead_tip(ActiveBlock& block, CodeNumber code) {
  const auto axis = axis_not_led(block);
  if (!axis) return true;
  const std::string word = block.channel.axes[*axis].word;
  block
      .fail("E4353", {'G', code, {}},
            "`" + code_text('G', code) + "` cannot lead the tool tip: the kinematic scheme does " +
                "not take " + word + " into account",
            "the tip is not led")
      .help.emplace_back("select a scheme of type head_table, head_head or table_table that has " +
                         word + " with `#kinematics`, or use `G43`");
  return false;
}

LengthMode mode_of(CodeNumber code) {
  if (code == g(49)) return LengthMode::off;
  return leads_tip(code) ? LengthMode::tip : LengthMode::length;
}

std::optional<FirstRotary> wanted_branch(ActiveBlock& block) {
  const auto p = block.has('P') ? block.integer('P', 0, 2) : std::optional(0);
  if (!p) return std::nullopt;
  return *p == 0 ? FirstRotary::nearest : *p == 1 ? FirstRotary::positive : FirstRotary::negative;
}

// The rotary axes turned to where the tool is square to the plane; nothing when it cannot be.
std::optional<Move> turn_to_plane(ActiveBlock& block, CodeNumber code, FirstRotary first) {
  const ModalState& modal = block.modal;
  const bool forced = first != FirstRotary::nearest;
  const Rotation plane_B = modal.frames.base_rotation() * modal.frames.plane.rotation;
  OrientationWish wish{
      .word = {'G', code, {}},
      .first = first,
      .purpose = "align the tool with the plane, whose normal is",
      .said_by = Group::rotation,
      .remedy = forced ? "leave P out, or clamp the workpiece differently"
                       : "clamp the workpiece differently, or machine the plane in several parts"};
  wish.tool_B = components(plane_B.turned(Vector3<double>{0.0, 0.0, 1.0}));
  const auto found = reachable_angles(block, wish);
  if (!found) return std::nullopt;
  Move move;
  move.end = modal.position_W;
  move.path = modal.path;
  move.stop_at_end = block.end.stops;
  move.aligns_tool = true;
  if (!turn_axes(block, *found, move)) return std::nullopt;
  return move;
}

}  // namespace

// The base stays, and the row is added.
void take_row(ToolLength& length, const Tables& tables) {
  length.offset_mm = length.base_mm;
  length.version = tables.version();
  const auto tool = tables.tool_edge(length.tool, length.edge);
  if (length.row == ToolLength::Row::none || !tool) return;
  const double sign = length.row == ToolLength::Row::subtracted ? -1.0 : 1.0;
  for (std::size_t k = 0; k < length.offset_mm.size(); ++k)
    length.offset_mm[k] += sign * tool->length_mm[k];
}

bool turn_axes(ActiveBlock& block, const Alignment& found, Move& move) {
  move.words = static_cast<AxisSet>(move.words | found.axes);
  const AxisValues zero_B = block.modal.frame().offset;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if ((found.axes & axis_bit(i)) == 0) continue;
    if (is_spindle_now(block, i)) {
      refuse_axis_that_is_spindle(block, i);
      return false;
    }
    const double angle_W = found.angles_B[i] - zero_B[i];
    if (std::abs(angle_W - move.end[i]) > position_noise) move.end[i] = angle_W;
  }
  return true;
}

void follow_alignment(ActiveBlock& block) {
  ToolLength length = block.modal.tool.length;
  length.mode = mode_of(block.modal.code(Group::length));
  change_length(block, length);
}

// The linear axes stand (G53.1), or go so that the tip stands (G53.6). Each needs its own mode of
// the tool length, for which it waits before it turns the axes.
void align_tool(ActiveBlock& block, CodeNumber code) {
  const bool keeps_tip = code == g(53, 6);
  TiltedPlane& plane = block.modal.frames.plane;
  if (!plane.is_on) {
    block
        .fail("E4350", {'G', code, {}}, "`" + code_text('G', code) + "` needs a tilted plane",
              "no plane")
        .help.emplace_back("program the plane with `G68.2` first");
    return;
  }
  if (excluded_by_mode(
          block, code,
          {Exclusion::radius_compensation, Exclusion::transformation, Exclusion::drilling_cycle})) {
    return;
  }
  const bool under_tcp = mode_of(block.modal.code(Group::length)) == LengthMode::tip;
  if (!keeps_tip && under_tcp && excluded_by_mode(block, code, {Exclusion::tcp})) return;
  const auto first = wanted_branch(block);
  if (!first) return;
  const auto move = turn_to_plane(block, code, *first);
  if (!move) return;
  const bool leads_tip = block.modal.tool.length.mode == LengthMode::tip;
  if (keeps_tip != leads_tip) {
    plane.is_aligned = keeps_tip;
    follow_alignment(block);
    --block.done.actions;  // the axes turn when the position is known
    return;
  }
  advance_position(block, *move);
  block.queue.emit(*move);
  note_turned_tool(block);
  plane.is_aligned = true;
  follow_alignment(block);
}

void use_tool_offset(ActiveBlock& block, int tool, int edge) {
  const bool known = tool != 0 && edge != 0 && block.tables.tool_edge(tool, edge);
  change_length(block, known ? length_of_row(block, {tool, edge}, g(43), {}) : ToolLength{});
  block.set_modal(Group::length, known ? g(43) : g(49));
}

void compensate_length(ActiveBlock& block, CodeNumber code) {
  if (leads_tip(code) &&
      (excluded_by_mode(block, code, {Exclusion::carried_offset}) || !can_lead_tip(block, code)))
    return;
  if (code == g(49)) return change_length_of_block(block, ToolLength{});
  if (code == g(43, 1)) return set_by_axis_words(block);
  if (code == g(43, 2) && !block.has('H')) {
    block.fail("E4007", {'G', g(43, 2), {}}, "`G43.2` needs H, the tool whose length is added",
               "no H");
    return;
  }
  const auto source = length_source(block);
  if (!source) return;
  const Offset base = code == g(43, 2) ? block.modal.tool.length.offset_mm : Offset{};
  change_length_of_block(block, length_of_row(block, *source, code, base));
}

void restore_length(ActiveBlock& block, const ToolLength& saved) {
  change_length(block, saved);
}

}  // namespace stanok::lang
