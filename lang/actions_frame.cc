// Actions of work offsets, shifts of the coordinate system and tool length compensation.
#include <string>

#include "lang/actions.h"

namespace stanok::lang {
namespace {

bool is_programmed(const ActiveBlock& block, std::size_t axis) {
  return (block.programmed & axis_bit(axis)) != 0;
}

// Index of the work offset that a code selects: 1 = G54 ... 9 = G59.3.
int offset_number(CodeNumber code) {
  return code <= 590 ? (code - 540) / 10 + 1 : 6 + (code - 590);
}

void change_length(ActiveBlock& block, const ToolLength& after) {
  const ToolLength before = block.modal.length;
  if (before.mode == after.mode && before.tool == after.tool &&
      before.offset_mm == after.offset_mm) {
    return;
  }
  block.modal.length = after;
  block.queue.emit(after);
  if (before.mode == LengthMode::tip || after.mode == LengthMode::tip) {
    block.queue.emit(Request{});
    return;
  }
  AxisValues distance_B{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = block.channel_words.geometry_axis(k);
    if (axis < 0) continue;
    distance_B[static_cast<std::size_t>(axis)] = before.offset_mm[k] - after.offset_mm[k];
  }
  block.modal.shift_position(distance_B);
}

// Length of the tool that H names, the active one without H.
std::optional<Tool> compensated_tool(ActiveBlock& block) {
  int number = block.modal.tool_active;
  if (block.has('H')) {
    const auto named = block.integer('H', 0, 99999999);
    if (!named) return std::nullopt;
    number = *named;
  }
  if (number == 0) return Tool{};
  auto tool = block.tables.tool(number);
  if (!tool) {
    block.fail("E5002", {block.has('H') ? 'H' : 'G', block.has('H') ? -1 : 430, {}},
               "the tool table has no tool " + std::to_string(number), "unknown tool");
  }
  return tool;
}

}  // namespace

FrameChange frame_of(const ModalState& modal) {
  const WorkFrame frame = modal.frame();
  return {modal.work_offset_number, frame.offset, frame.rotation};
}

void take_work_offset(ModalState& modal, const Tables& tables, int number) {
  modal.work_offset_number = number;
  modal.work_offset = tables.work_offset(number).value_or(modal.work_offset);
  modal.work_offset_rotation =
      Rotation::about({0.0, 0.0, 1.0}, tables.work_offset_rotation(number));
}

void publish_frame(ActiveBlock& block, const WorkFrame& before, int work_offset_before) {
  const bool changed = block.modal.frame() != before;
  if (changed) block.modal.reexpress_position(before);
  if (changed || block.modal.work_offset_number != work_offset_before) {
    block.queue.emit(frame_of(block.modal));
  }
}

void publish_frame(ActiveBlock& block, const WorkFrame& before) {
  publish_frame(block, before, block.modal.work_offset_number);
}

void restore_work_offset(ActiveBlock& block, const ModalState& saved) {
  const AxisValues before = block.modal.offset();
  const int number_before = block.modal.work_offset_number;
  block.modal.work_offset_number = saved.work_offset_number;
  block.modal.work_offset =
      block.tables.work_offset(saved.work_offset_number).value_or(AxisValues{});
  publish_frame(block, before, number_before);
}

void restore_shifts(ActiveBlock& block, const ModalState& saved) {
  const AxisValues before = block.modal.offset();
  block.modal.local_shift = saved.local_shift;
  block.modal.axis_shift = saved.axis_shift;
  block.modal.axis_shift_active = saved.axis_shift_active;
  publish_frame(block, before);
}

void restore_length(ActiveBlock& block, const ToolLength& saved) {
  change_length(block, saved);
}

void select_work_offset(ActiveBlock& block, CodeNumber code) {
  int number = offset_number(code);
  if (code == 541) {
    if (!block.has('P')) {
      block.fail("E4007", {'G', 541, {}}, "`G54.1` needs P", "no P");
      return;
    }
    const auto page = block.integer('P', 1, 300);
    if (!page) return;
    number = 9 + *page;
  }
  if (!block.tables.work_offset(number)) {
    block.fail("E5001", {'G', code, {}},
               "the machine has no work offset `" + code_text('G', code) + "`",
               "unknown work offset");
    return;
  }
  const WorkFrame before = block.modal.frame();
  const int number_before = block.modal.work_offset_number;
  take_work_offset(block.modal, block.tables, number);
  publish_frame(block, before, number_before);
}

void shift_locally(ActiveBlock& block, CodeNumber) {
  const WorkFrame before = block.modal.frame();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) block.modal.local_shift[i] = block.values[i];
  }
  publish_frame(block, before);
}

namespace {

// The shift with which the point where the axes stand is called as the axis words say.
AxisValues shift_to_words(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  AxisValues distance_W{};
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_programmed(block, i)) continue;
    distance_W[i] = modal.position_W[i] - modal.map.to_work(i, block.values[i]);
  }
  AxisValues shift = turned(modal.rotation.rotation, modal.geometry, distance_W);
  for (std::size_t i = 0; modal.axis_shift_active && i < shift.size(); ++i) {
    shift[i] += modal.axis_shift[i];
  }
  return shift;
}

}  // namespace

// G92 X..: the point where the axes stand is called X.. from here on.
void shift_axes(ActiveBlock& block, CodeNumber code) {
  const WorkFrame before = block.modal.frame();
  if (code == 920) {
    block.modal.axis_shift = shift_to_words(block);
    block.modal.axis_shift_active = true;
  } else {
    if (code == 921) block.modal.axis_shift = {};
    block.modal.axis_shift_active = code != 922;
  }
  publish_frame(block, before);
  for (std::size_t i = 0; code == 920 && i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) {
      block.modal.position_W[i] = block.modal.map.to_work(i, block.values[i]);
    }
  }
}

void compensate_length(ActiveBlock& block, CodeNumber code) {
  ToolLength length;
  if (code == 490) {
    change_length(block, length);
    return;
  }
  length.mode = code == 434 ? LengthMode::tip : LengthMode::length;
  length.tool = block.modal.tool_active;
  if (code == 431) {
    length.offset_mm = block.modal.length.offset_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = block.channel_words.geometry_axis(k);
      if (axis < 0 || !is_programmed(block, static_cast<std::size_t>(axis))) continue;
      length.offset_mm[k] = block.values[static_cast<std::size_t>(axis)];
    }
    change_length(block, length);
    return;
  }
  const auto tool = compensated_tool(block);
  if (!tool) return;
  if (tool->number != 0) length.tool = tool->number;
  const double sign = code == 440 ? -1.0 : 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double added = code == 432 ? block.modal.length.offset_mm[k] : 0.0;
    length.offset_mm[k] = added + sign * tool->length_mm[k];
  }
  change_length(block, length);
}

}  // namespace stanok::lang
