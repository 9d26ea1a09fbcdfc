// Actions of probing.
//
// G38.2 to G38.5 and G31, which is G38.3 for one block: a line that ends where the probe changes.
// The program waits for what was found, which BlockRunner keeps for $probe and #5061.
//
// G37, automatic measuring of a tool: it goes to a place where it should touch the tool setter, and
// by what it misses that place the wear of the offset in force is corrected.
//
//   at rapid to `before` before the place, at the measuring feed to `within` behind it
//
//   new wear = wear + (where it touched - the place), X of a lathe as a radius
//
// M78 and M79 of Haas are alarms when the last of them touched something, or nothing.
//
// Source: Fanuc operator's manuals B-64304EN-2, "Automatic tool length measurement (G37)", and
// B-64304EN-1, "Automatic tool offset (G36, G37)": the offset that changes is that of the wear, and
// a touch outside of the range is an alarm, by which nothing is written.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

// Shortest travel in which a probe can change, mm or deg.
constexpr double probing_travel_min = 0.01;

double longest_travel(const AxisValues& from, const AxisValues& to) {
  double way = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) way = std::max(way, std::abs(to[i] - from[i]));
  return way;
}

const WordName code_g37 = {'G', g(37), {}};

// What the wear along X, Y and Z is called in the tool table.
constexpr std::array<std::string_view, 3> wears{"wear_length_x", "", "wear_length"};

// Mills measure along the tool, lathes along X or Z.
AxisSet measured_axes(const ActiveBlock& block) {
  const GeometryAxes& geometry = block.modal.geometry;
  AxisSet axes = axis_bit(geometry[2]);
  if (block.channel.kind == ChannelKind::lathe)
    axes = static_cast<AxisSet>(axes | axis_bit(geometry[0]));
  return axes;
}

// The geometry axis (0 X, 2 Z) along which the block measures.
std::optional<std::size_t> measured_axis(ActiveBlock& block) {
  if (!only_axes(block, g(37), measured_axes(block))) return std::nullopt;
  if (std::popcount(block.programmed) != 1) {
    block.fail("E4016", code_g37, "`G37` measures along one axis", "two axes")
        .help.emplace_back("measure along the other axis with a separate `G37`");
    return std::nullopt;
  }
  return is_programmed(block, block.modal.geometry[2]) ? 2U : 0U;
}

bool has_offset(ActiveBlock& block) {
  const ToolLength& length = block.modal.tool.length;
  const CodeNumber code = block.modal.code(Group::length);
  const bool plain = code == g(43) && length.mode == LengthMode::length && length.tool != 0;
  if (plain && block.tables.tool_edge(length.tool, length.edge)) return true;
  BlockFault& fault =
      block.fail("E4325", code_g37, "there is no tool offset for `G37` to correct", "no offset");
  fault.notes.push_back(block.modal.origin_of(Group::length));
  fault.help.emplace_back(block.channel.kind == ChannelKind::lathe
                              ? "call the tool with its offset first, e.g. `T0101`"
                              : "program `G43` with H first, e.g. `G43 H1`");
  return false;
}

void go_and_touch(ActiveBlock& block, AxisIndex axis) {
  const ToolMeasuring& measuring = block.channel.tool_measuring;
  Move move;
  resolve_ends(block, move);
  const double place = move.end[axis];
  const double way = place - block.modal.position_W[axis];
  if (std::abs(way) < measuring.within_mm) {
    block.fail("E4321", code_g37, "`G37` begins so close that the tool could already touch",
               "begin farther away");
    return;
  }
  const double direction = way > 0.0 ? 1.0 : -1.0;
  move.path = block.modal.path;
  move.stop_at_end = true;
  if (std::abs(way) > measuring.before_mm) {
    move.end[axis] = place - direction * measuring.before_mm;
    advance_position(block, move);
    block.queue.emit(move);
  }
  ProbeMove touch;
  touch.line = move;
  touch.line.kind = MoveKind::line;
  touch.line.feed = measuring.feed_mm_per_min;
  touch.line.end[axis] = place + direction * measuring.within_mm;
  advance_position(block, touch.line);
  block.queue.emit(touch);
  ProgramRequest result;
  result.kind = RequestKind::probe_result;
  result.statement = true;
  block.queue.emit(result);
}

void correct_wear(ActiveBlock& block, std::size_t geometry) {
  if (block.probe.rehearsed) return;
  const AxisIndex axis = block.modal.geometry[geometry];
  Move wanted;
  resolve_ends(block, wanted);
  const double touched = block.modal.map.to_work(axis, block.probe.position[axis]);
  const double error = touched - wanted.end[axis];
  const double within = block.channel.tool_measuring.within_mm;
  if (std::abs(error) > within) {
    block.fail("E4324", code_g37,
               "the tool touched " + law_number_text(std::abs(error)) +
                   " mm from the position of `G37`; the limit is " + law_number_text(within) +
                   " mm",
               "the offset was not changed");
    return;
  }
  const ModalTool& tool = block.modal.tool;
  const auto edge = block.tables.tool_edge(tool.length.tool, tool.length.edge);
  if (!edge) return;
  write_tool(block, tool.length.tool, wears[geometry], edge->wear_mm[geometry] + error,
             tool.length.edge);
  ToolLength corrected = tool.length;
  corrected.offset_mm[geometry] += error;
  restore_length(block, corrected);
}

// G31 over no way, or over less than a probe can change in. It is no error on Fanuc and Haas
// controls: macros go by the centre offset of their stylus, which may be 0. Nothing is found.
void go_without_probing(ActiveBlock& block, Move& line, double travel) {
  resolve_feed(block, line);
  if (block.failed()) return;
  advance_position(block, line);
  if (travel > position_noise) block.queue.emit(line);
  const ModalState& modal = block.modal;
  block.probe = {};
  block.probe.tool_length_mm = modal.tool.length.offset_mm;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i)
    block.probe.position[i] = modal.map.to_program(i, modal.position_W[i]);
}

}  // namespace

void probe(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::inverse_time})) {
    return;
  }
  ProbeMove move;
  if (code == g(31) && block.has('P')) {
    const auto input = block.integer('P', 1, skip_inputs_last);
    if (!input) return;
    move.input = *input;
  }
  move.line.kind = MoveKind::line;
  move.until_contact = code == g(31) || code == g(38, 2) || code == g(38, 3);
  move.alarm_when_missed = code == g(38, 2) || code == g(38, 4);
  resolve_ends(block, move.line);
  const double travel = longest_travel(block.modal.position_W, move.line.end);
  if (travel < probing_travel_min) {
    if (code == g(31) && block.words.rules.is_fanuc())
      return go_without_probing(block, move.line, travel);
    block.fail("E4321", {'G', code, {}}, "a probing move needs a length",
               "the end is the current position");
    return;
  }
  resolve_feed(block, move.line);
  if (block.failed()) return;
  advance_position(block, move.line);
  block.queue.emit(move);
  ProgramRequest result;
  result.kind = RequestKind::probe_result;
  result.statement = move.alarm_when_missed;
  block.queue.emit(result);
}

// In two parts: in the block of the probing move itself the answer comes when the axes stand. It
// may stand in a later block, too (Haas mill operator's manual, M78 and M79).
void check_skip(ActiveBlock& block, CodeNumber code) {
  if (block.done.parts == 0) {
    block.done.parts = 1;
    block.awaits_position = true;
    --block.done.actions;
    return;
  }
  const bool wanted = code == m(79);
  if (block.probe.rehearsed || block.probe.found == wanted) return;
  const WordName word = {'M', code, {}};
  if (wanted) {
    block.fail("E4320", word, "the probe touched nothing",
               "alarm if the skip signal was not found");
  } else {
    block
        .fail("E4324", word, "the probe touched something where nothing should be",
              "alarm if the skip signal was found")
        .help.emplace_back("check what is in the way, and the length of the probe");
  }
}

// In two parts: where the tool touched is known when the axes stand.
void measure_tool_length(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code,
                       {Exclusion::radius_compensation, Exclusion::tcp, Exclusion::transformation,
                        Exclusion::drilling_cycle, Exclusion::rotation, Exclusion::scaling,
                        Exclusion::mirror})) {
    return;
  }
  const auto geometry = measured_axis(block);
  if (!geometry || !has_offset(block)) return;
  if (block.done.parts == 1) return correct_wear(block, *geometry);
  if (block.modal.incremental()) {
    block.fail("E4016", code_g37, "`G37` needs an absolute position", "G91 is active")
        .notes.push_back(block.modal.origin_of(Group::distance));
    return;
  }
  go_and_touch(block, block.modal.geometry[*geometry]);
  if (block.failed()) return;
  block.done.parts = 1;
  block.awaits_position = true;
  --block.done.actions;
}

}  // namespace stanok::lang
