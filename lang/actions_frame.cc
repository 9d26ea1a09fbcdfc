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

// Tells the channel the frame after a change; the point stays where it is in B.
void publish_frame(ActiveBlock& block, const AxisValues& offset_before, int number_before) {
  block.modal.reexpress_position(offset_before);
  const bool changed =
      block.modal.offset() != offset_before || block.modal.work_offset_number != number_before;
  if (changed) block.queue.emit(frame_of(block.modal));
}

// `offset_before` of an operation that leaves the number of the work offset alone.
void publish_frame(ActiveBlock& block, const AxisValues& offset_before) {
  publish_frame(block, offset_before, block.modal.work_offset_number);
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
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = block.channel_words.geometry_axis(k);
    if (axis < 0) continue;
    block.modal.position_W[static_cast<std::size_t>(axis)] +=
        before.offset_mm[k] - after.offset_mm[k];
  }
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

void write_offset_page(ActiveBlock& block, int page, const AxisValues& values) {
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_programmed(block, i)) continue;
    Request request;
    request.kind = RequestKind::offset_table_write;
    request.text = block.channel.axes[i].word;
    request.number = page;
    request.index = static_cast<int>(i);
    request.value = values[i];
    block.queue.emit(request);
  }
}

// Page of the offset table that the P of G10 means; P0 is the active one.
std::optional<int> table_page(ActiveBlock& block) {
  if (!block.has('P')) {
    block.fail("E4007", {'G', 100, {}}, "`G10` needs P, the number of the work offset", "no P");
    return std::nullopt;
  }
  const auto page = block.integer('P', 0, 309);
  if (!page) return std::nullopt;
  const int number = *page == 0 ? block.modal.work_offset_number : *page;
  if (block.tables.work_offset(number)) return number;
  block.fail("E5001", {'P', -1, {}}, "there is no work offset " + std::to_string(number),
             "unknown work offset");
  return std::nullopt;
}

}  // namespace

FrameChange frame_of(const ModalState& modal) {
  FrameChange frame;
  frame.work_offset = modal.work_offset_number;
  frame.offset = modal.offset();
  frame.rotation_plane = modal.plane();
  return frame;
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
  const auto offset = block.tables.work_offset(number);
  if (!offset) {
    block.fail("E5001", {'G', code, {}},
               "the machine has no work offset `" + code_text('G', code) + "`",
               "unknown work offset");
    return;
  }
  const AxisValues before = block.modal.offset();
  const int number_before = block.modal.work_offset_number;
  block.modal.work_offset = *offset;
  block.modal.work_offset_number = number;
  publish_frame(block, before, number_before);
}

void shift_locally(ActiveBlock& block, CodeNumber) {
  const AxisValues before = block.modal.offset();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) block.modal.local_shift[i] = block.values[i];
  }
  publish_frame(block, before);
}

// G92 X..: the point where the axes stand is called X.. from here on.
void shift_axes(ActiveBlock& block, CodeNumber code) {
  const AxisValues before = block.modal.offset();
  if (code == 920) {
    if (block.programmed == 0) {
      block.fail("E4007", {'G', 920, {}}, "`G92` needs an axis word", "");
      return;
    }
    for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
      const double shift = block.modal.axis_shift_active ? block.modal.axis_shift[i] : 0.0;
      block.modal.axis_shift[i] =
          is_programmed(block, i) ? shift + block.modal.position_W[i] - block.values[i] : shift;
    }
    block.modal.axis_shift_active = true;
  } else {
    if (code == 921) block.modal.axis_shift = {};
    block.modal.axis_shift_active = code != 922;
  }
  publish_frame(block, before);
  for (std::size_t i = 0; code == 920 && i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) block.modal.position_W[i] = block.values[i];
  }
}

void write_table(ActiveBlock& block, CodeNumber) {
  const double kind = block.has('L') ? block.value('L') : 0.0;
  if (kind != 2.0 && kind != 20.0) {
    block.fail("E2090", {block.has('L') ? 'L' : 'G', block.has('L') ? -1 : 100, {}},
               "of `G10` only L2 and L20 are supported in this release", "");
    return;
  }
  const auto page = table_page(block);
  if (!page) return;
  AxisValues values = block.values;
  if (kind == 20.0) {
    // The table value with which the point would stand at the programmed coordinates.
    const AxisValues offset = block.modal.offset();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double shifts = offset[i] - block.modal.work_offset[i];
      values[i] = block.modal.position_W[i] + offset[i] - shifts - values[i];
    }
  }
  write_offset_page(block, *page, values);
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
