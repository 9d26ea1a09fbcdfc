// Actions of tool radius compensation, and what it forbids while it is active.
//
// Source of the restrictions: the interpreter of LinuxCNC; the compensation itself is
// lang/block/radius_compensation.h.
#include <algorithm>
#include <cmath>
#include <string>

#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/block/axis_words.h"

namespace stanok::lang {
namespace {

// G41.1, G42.1: D is the diameter, a negative one means the other side; L the orientation.
std::optional<Tool> programmed_tool(ActiveBlock& block, CodeNumber code) {
  Tool tool;
  if (!block.has('D')) {
    block.fail("E4007", {'G', code, {}},
               "`" + code_text('G', code) + "` needs D, the diameter of the tool", "no D");
    return std::nullopt;
  }
  tool.radius_mm = block.length('D') / 2.0;
  if (block.has('L') && block.modal.plane() != Plane::zx && block.words.rules.is_linuxcnc()) {
    block
        .fail("E4003", {'L', -1, {}}, "L, the orientation of a lathe tool, needs plane G18",
              "another plane")
        .notes.push_back(block.modal.origin_of(Group::plane));
    return std::nullopt;
  }
  if (block.has('L')) {
    const auto orientation = block.integer('L', 0, 9);
    if (!orientation) return std::nullopt;
    tool.orientation = *orientation;
  }
  return tool;
}

bool has_plane_of_compensation(ActiveBlock& block, CodeNumber code) {
  const PlaneAxes plane = plane_axes(block);
  if (plane.first.exists() && plane.second.exists()) return true;
  block
      .fail("E4036", {'G', code, {}},
            "the channel lacks an axis of the plane of radius compensation",
            "the channel lacks an axis of the plane")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return false;
}

// Whether the plane is mirrored: left becomes right.
bool mirrors(const ActiveBlock& block) {
  const PlaneAxes plane = plane_axes(block);
  return block.modal.map.gain(plane.first) * block.modal.map.gain(plane.second) < 0.0;
}

// Codes that only confirm what is active change nothing.
bool confirms(const ActiveBlock& block, const Code& code) {
  const bool has_value = code.number == g(54, 1) || code.number == g(54, 2) ||
                         code.group == Group::rotation || code.group == Group::length;
  const bool off = code.number == g(49) || code.number == g(69);
  return code.group != Group::none && block.modal.code(code.group) == code.number &&
         (!has_value || off);
}

bool is_code_of_coordinates(const Code& code) {
  switch (code.group) {
    case Group::plane:
    case Group::units:
    case Group::length:
    case Group::transformation:
    case Group::scaling:
    case Group::mirror:
    case Group::work_offset:
    case Group::rotation:
    case Group::polar:
      return true;
    default:
      return code.letter == 'G' && code.group == Group::none && code.order == EffectOrder::settings;
  }
}

bool is_forbidden(const ActiveBlock& block, const Code& code) {
  const bool changes_tool = code.order == EffectOrder::tool_change;
  const bool other_motion = code.axes != AxisWords::unused && code.letter == 'G' &&
                            (code.group != Group::motion || code.number > g(3));
  const bool machine_coordinates = code.letter == 'G' && code.number == g(53);
  return changes_tool || other_motion || machine_coordinates ||
         (is_code_of_coordinates(code) && !confirms(block, code));
}

// `before` the block, `after` the code of the block that selects compensation.
struct Activity {
  bool before = false;
  bool after = false;
};

// G41 again, on the same side with the same offset: customary in loops of Fanuc programs.
bool confirms_compensation(const ActiveBlock& block, const Code& code) {
  if (!block.words.rules.is_fanuc()) return false;
  if (code.number != block.modal.code(Group::radius_compensation)) return false;
  return !block.has('D') || block.value('D') == block.modal.tool.radius_offset;
}

void refuse_code(ActiveBlock& block, const Code& code, const Activity& active) {
  const bool again = code.group == Group::radius_compensation && code.number != g(40);
  if (again && (!active.before || confirms_compensation(block, code))) return;
  const bool now = code.order < EffectOrder::radius_compensation ? active.before : active.after;
  // G150 takes the side and the tool of its block and is not compensated itself.
  if (code.action == CodeAction::mill_contour_pocket && !active.before) return;
  if (!again && (!now || !is_forbidden(block, code))) return;
  BlockFault& fault = block.fail(again ? "E4142" : "E4141", {code.letter, code.number, {}},
                                 "`" + code_text(code.letter, code.number) +
                                     "` is not allowed while radius compensation is active",
                                 "");
  if (active.before) fault.notes.push_back(block.modal.origin_of(Group::radius_compensation));
  fault.help.push_back("switch it off with `G40` first");
}

}  // namespace

std::optional<Tool> tool_of_radius(ActiveBlock& block, CodeNumber code) {
  int number = block.modal.tool.active;
  int edge = std::max(block.modal.tool.edge, 1);
  if (block.has('D')) {
    const auto named = block.integer('D', 0, 99999999);
    if (!named) return std::nullopt;
    // For LinuxCNC D0 names the tool in the spindle.
    const bool in_spindle = *named == 0 && block.words.rules.is_linuxcnc();
    if (!in_spindle) {
      number = *named;
      edge = 1;
    }
  } else if (block.words.rules.is_fanuc() && block.modal.tool.radius_offset >= 0) {
    number = block.modal.tool.radius_offset;
    edge = 1;
  }
  if (number == 0) return Tool{};
  auto tool = block.tables.tool_edge(number, edge);
  if (!tool) {
    const WordName word = block.has('D') ? WordName{'D', -1, {}} : WordName{'G', code, {}};
    block.fail("E5021", word, "the tool table has no tool " + std::to_string(number),
               "unknown tool");
  }
  return tool;
}

void refuse_while_compensated(ActiveBlock& block, const BlockCodes& codes) {
  Activity active{block.modal.compensation.on(), block.modal.compensation.on()};
  if (!active.before && !codes.has(Group::radius_compensation)) return;
  for (const Code* const code : codes) {
    if (code->group == Group::radius_compensation) active.after = code->number != g(40);
  }
  for (const Code* const code : codes) {
    if (!block.failed()) refuse_code(block, *code, active);
  }
  // T beside G40: the contour ends, then the tool changes, then the move leads away.
  if (active.before && active.after && block.has('T') && block.channel.kind == ChannelKind::lathe) {
    block
        .fail("E4141", {'T', -1, {}},
              "the tool cannot be changed while radius compensation is active",
              "T changes the tool immediately")
        .notes.push_back(block.modal.origin_of(Group::radius_compensation));
    block.faults.first->help.emplace_back("switch it off with `G40` before or in this block");
  }
  if (block.failed() || codes.has(Group::motion)) return;
  const Code* const motion = find_code('G', block.modal.code(Group::motion));
  if (motion->axes != AxisWords::unused) refuse_code(block, *motion, active);
}

void select_compensation(ActiveBlock& block, CodeNumber code) {
  RadiusCompensation& selected = block.modal.compensation;
  if (code == g(40)) {
    selected = {};
    return;
  }
  const auto tool = code == g(41, 1) || code == g(42, 1) ? programmed_tool(block, code)
                                                         : tool_of_radius(block, code);
  if (!tool || !has_plane_of_compensation(block, code)) return;
  // A negative radius in the tool table and a mirrored plane mean the other side.
  const bool left =
      ((code == g(41) || code == g(41, 1)) == (tool->radius_mm >= 0.0)) != mirrors(block);
  selected.side = left ? RadiusCompensation::Side::left : RadiusCompensation::Side::right;
  selected.radius_mm = std::abs(tool->radius_mm);
  selected.arc_leads_in = !block.words.rules.is_fanuc();
  selected.plane = block.modal.plane();
  selected.orientation = std::clamp(tool->orientation, 0, 9);
}

}  // namespace stanok::lang
