// Actions of tool length compensation: G43, G43.1, G43.2, G43.4, G44, G49, and the offset of a T
// word on lathe channels.
//
// The length in force is a base (what G43.2 found there) and the length of one edge, which is read
// again when the tool table may have changed.
#include <algorithm>
#include <string>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

void change_length(ActiveBlock& block, const ToolLength& after) {
  const ToolLength before = block.modal.tool.length;
  if (before.mode == after.mode && before.tool == after.tool &&
      before.offset_mm == after.offset_mm) {
    return;
  }
  block.modal.tool.length = after;
  block.queue.emit(after);
  if (before.mode == LengthMode::tip || after.mode == LengthMode::tip) {
    block.queue.emit(Request{});
    block.awaits_position = true;
    return;
  }
  AxisValues distance_B{};
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.channel_words.geometry_axis(k);
    if (axis.exists()) distance_B[axis] = before.offset_mm[k] - after.offset_mm[k];
  }
  block.modal.shift_position(distance_B);
}

// Edge whose length counts: that of the tool H names, the active one without H.
struct LengthSource {
  int tool = 0;
  int edge = 1;
};

std::optional<LengthSource> length_source(ActiveBlock& block) {
  LengthSource source{block.modal.tool.active, std::max(block.modal.tool.edge, 1)};
  if (block.has('H')) {
    const auto named = block.integer('H', 0, 99999999);
    if (!named) return std::nullopt;
    source = {*named, 1};
  }
  if (source.tool == 0 || block.tables.tool_edge(source.tool, source.edge)) return source;
  block.fail("E5021", {block.has('H') ? 'H' : 'G', block.has('H') ? -1 : 430, {}},
             "the tool table has no tool " + std::to_string(source.tool), "unknown tool");
  return std::nullopt;
}

using Offset = std::array<double, 3>;

// `base` and the length of the tool, which G44 subtracts.
Offset offset_of(const ActiveBlock& block, const LengthSource& source, CodeNumber code,
                 const Offset& base) {
  const auto tool = block.tables.tool_edge(source.tool, source.edge);
  if (source.tool == 0 || !tool) return base;
  Offset offset = base;
  for (std::size_t k = 0; k < offset.size(); ++k) {
    offset[k] += code == g(44) ? -tool->length_mm[k] : tool->length_mm[k];
  }
  return offset;
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

}  // namespace

void use_tool_offset(ActiveBlock& block, int tool, int edge) {
  ToolLength length;
  const bool known = tool != 0 && edge != 0 && block.tables.tool_edge(tool, edge);
  block.modal.tool.length_base_mm = {};
  block.modal.tool.length_edge = std::max(edge, 1);
  if (known) {
    length.mode = LengthMode::length;
    length.tool = tool;
    length.offset_mm = offset_of(block, {tool, edge}, g(43), {});
  }
  change_length(block, length);
  block.set_modal(Group::length, known ? g(43) : g(49));
}

void compensate_length(ActiveBlock& block, CodeNumber code) {
  if (code == g(49)) return change_length(block, ToolLength{});
  if (code == g(43, 1)) return set_by_axis_words(block);
  if (code == g(43, 2) && !block.has('H')) {
    block.fail("E4007", {'G', g(43, 2), {}}, "`G43.2` needs H, the tool to be added", "no H");
    return;
  }
  const auto source = length_source(block);
  if (!source) return;
  ModalState& modal = block.modal;
  modal.tool.length_base_mm = code == g(43, 2) ? modal.tool.length.offset_mm : Offset{};
  modal.tool.length_edge = source->edge;
  ToolLength length;
  length.mode = code == g(43, 4) ? LengthMode::tip : LengthMode::length;
  length.tool = source->tool != 0 ? source->tool : modal.tool.active;
  length.offset_mm = offset_of(block, *source, code, modal.tool.length_base_mm);
  change_length(block, length);
}

void restore_length(ActiveBlock& block, const ToolLength& saved) {
  block.modal.tool.length_base_mm = {};
  block.modal.tool.length_edge = 1;
  change_length(block, saved);
}

void read_tool_length_again(ActiveBlock& block) {
  const ModalState& modal = block.modal;
  const CodeNumber code = modal.code(Group::length);
  if (modal.tool.length.mode == LengthMode::off || code == g(43, 1)) return;
  if (!block.tables.tool_edge(modal.tool.length.tool, modal.tool.length_edge)) return;
  ToolLength length = modal.tool.length;
  length.offset_mm =
      offset_of(block, {length.tool, modal.tool.length_edge}, code, modal.tool.length_base_mm);
  change_length(block, length);
}

}  // namespace stanok::lang
