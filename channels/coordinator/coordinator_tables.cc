// Operators change the tables: only while no program runs, which may have read ahead.
#include "channels/coordinator/coordinator.h"

namespace stanok::channels {

// number = tool, value_2 = edge (0: 1), text = the name of the value.
Coordinator::Verdict Coordinator::set_tool(const OperatorEvent& event) RT_SAFE {
  const int edge = event.value_2 < 1.0 ? 1 : static_cast<int>(event.value_2);
  const int value = tool_value_named(event.text.view());
  if (value == 0 || !stores_.tables->has_place(event.number, edge))
    return refusal("E5021", "there is no such tool, edge or value");
  if (!stores_.tables->set_tool_value(event.number, edge, value, event.value, Writer::person))
    return refusal("E5020", "the value is out of range");
  return success();
}

// text = work offset and axis of the machine, "G54.1 P2 X"; R is the rotation.
Coordinator::Verdict Coordinator::set_offset(const OperatorEvent& event) RT_SAFE {
  const std::string_view text = event.text.view();
  const std::size_t blank = text.rfind(' ');
  if (blank == std::string_view::npos) return refusal("E5021", "an axis is missing");
  std::string_view offset = text;
  offset.remove_suffix(text.size() - blank);
  std::string_view axis_name = text;
  axis_name.remove_prefix(blank + 1);
  const int number = work_offset_number(offset);
  const int axis = stores_.tables->column(axis_name);
  if (number == 0 || axis < 0) return refusal("E5021", "there is no such work offset or axis");
  if (!stores_.tables->set_offset(number, axis, event.value, Writer::person))
    return refusal("E5020", "the offset could not be written");
  return success();
}

}  // namespace stanok::channels
