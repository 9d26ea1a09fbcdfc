// The overhang of a tool (#tool_overhang): how far it reaches along the radial axis.
//
// The tool table says how far it does; a programmed value moves the counter of the axis by the
// difference, the axes stay where they are. The shift lies in the frame W -> B, outside all
// rotations, for it belongs to the tool. A change of the tool, M2, M30 and reset end it.
#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

double table_overhang(const BlockSurroundings& around) {
  const auto tool = around.tables.tool_edge(around.modal.tool.active, around.modal.tool.edge);
  return tool ? tool->overhang_mm : 0.0;
}

}  // namespace

double overhang_in_force(const BlockSurroundings& around) {
  return table_overhang(around) + around.modal.tool.overhang_shift_mm;
}

void set_overhang(ActiveBlock& block, const ToolOverhang& overhang) {
  const WorkFrame before = block.modal.frame();
  block.modal.tool.overhang_axis = overhang.axis;
  block.modal.tool.overhang_shift_mm =
      overhang.axis < 0 ? 0.0 : overhang.value_mm - table_overhang(block);
  publish_frame(block, before);
}

void restore_overhang(ActiveBlock& block, const ModalState& saved) {
  const WorkFrame before = block.modal.frame();
  block.modal.tool.overhang_axis = saved.tool.overhang_axis;
  block.modal.tool.overhang_shift_mm = saved.tool.overhang_shift_mm;
  publish_frame(block, before);
}

}  // namespace stanok::lang
