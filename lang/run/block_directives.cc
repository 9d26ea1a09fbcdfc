#include "lang/run/block_directives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "lang/actions/modal_restore.h"
#include "lang/actions/saved_state.h"
#include "lang/feed_law/feed_law_curve.h"
#include "lang/run/block_runner.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

// Values are positive; an oscillation of 0 N ends one, and the clamps ascend.
bool are_possible(const ForceControl& command) {
  if (command.kind == ForceControl::Kind::force) {
    return command.force_n > 0.0 && command.feed_min >= 0.0 &&
           (command.feed_max == 0.0 || command.feed_min < command.feed_max);
  }
  if (command.kind == ForceControl::Kind::oscillate)
    return command.oscillation_n >= 0.0 && command.oscillation_hz > 0.0;
  if (command.kind == ForceControl::Kind::depth) return command.depth_mm >= 0.0;
  return command.level_um >= 0.0 && command.reduced_mass_kg >= 0.0 && command.oscillation_hz >= 0.0;
}

// The arguments of #workpiece.
enum WorkpieceArgument : std::size_t {
  type,
  resolution,
  machining,
  size_x,
  size_y,
  size_z,
  zero_x,
  zero_y,
  zero_z,
};
// With a file, behind the machining.
enum FileArgument : std::size_t { file_zero_x = 3, file_scale = 6 };
constexpr int file_type = 2;

}  // namespace

BlockDirectives::BlockDirectives(Vm& vm, RunStage& run, BlockState& state, PendingAnswer& pending,
                                 ChannelRequests& requests)
    : vm_(vm), run_(run), state_(state), pending_(pending), requests_(requests) {}

bool BlockDirectives::execute(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::message:
      send_message(instruction);
      return true;
    case Op::feed_law:
      set_feed_law(instruction);
      return true;
    case Op::adaptive:
      order_force_control(instruction);
      return true;
    case Op::tool_overhang:
      ask_overhang(instruction);
      return true;
    case Op::orientation:
      state_.modal.tool.turning = static_cast<TurningWay>(instruction.extra);
      return true;
    case Op::workpiece:
      announce_workpiece(instruction);
      return true;
    case Op::save_gvector:
      save_gvector();
      return true;
    case Op::restore_gvector:
      restore_gvector(instruction);
      return true;
    case Op::channel_error:
      vm_.stack().push(value_of(pending_.channel_error()));
      return true;
    default:
      return false;
  }
}

void BlockDirectives::send_message(const Instruction& instruction) {
  state_.begin_commands(vm_.instruction_origin());
  const Value text = vm_.stack().pop();
  state_.queue.emit(Message{text_of(text), static_cast<Message::Kind>(instruction.extra)});
}

// #feedlaw (off) and #feedlaw (curve, ways, feeds, speeds); the other laws are blocks.
void BlockDirectives::set_feed_law(const Instruction& instruction) {
  state_.begin_commands(vm_.instruction_origin());
  ActiveBlock block = state_.block_at(vm_.span().line);
  if (instruction.count == 0) return end_feed_law(block);
  std::array<std::vector<double>, 3> numbers;
  if (!pop_curve(instruction, numbers)) return;
  const bool has_speeds = !numbers[2].empty();
  auto law = read_feed_curve(law_surroundings(block), {numbers[0], numbers[1], numbers[2]});
  if (!law) return fail_feed_law(std::move(law).error());
  const bool allowed = allows_feed_law(block, {}) &&
                       (!has_speeds || spindle_takes_law(block, {}, "speeds of a curve"));
  if (!allowed) return fail_feed_law(std::move(*block.faults.first));
  lang::set_feed_law(block, std::move(*law));
}

// The arrays are on the stack: two or three.
bool BlockDirectives::pop_curve(const Instruction& instruction,
                                std::array<std::vector<double>, 3>& numbers) {
  std::array<Value, 3> arrays;
  for (std::size_t i = instruction.count; i-- > 0;) {
    arrays[i] = vm_.stack().pop();
    if (arrays[i].object->columns == 0) continue;
    vm_.fail("E3004", "the arrays of a curve have one dimension, this has two", "two");
    return false;
  }
  for (std::size_t i = 0; i < instruction.count; ++i) {
    for (const Value& element : arrays[i].object->elements) numbers[i].push_back(element.number);
  }
  return true;
}

void BlockDirectives::fail_feed_law(BlockFault fault) {
  const Span& span = vm_.span();
  vm_.fail_with(diagnostic_of(std::move(fault), vm_.file().source, span, {}));
  run_.blame_block(span.line);
}

// #adaptive: the values are on the stack in their order, in units of the machine.
void BlockDirectives::order_force_control(const Instruction& instruction) {
  ForceControl command;
  command.kind = static_cast<ForceControl::Kind>(instruction.extra);
  std::array<double, 3> values{};
  for (std::size_t i = instruction.count; i-- > 0;) values.at(i) = vm_.stack().pop_number();
  switch (command.kind) {
    case ForceControl::Kind::off:
    case ForceControl::Kind::vibration_off:
      break;
    case ForceControl::Kind::force:
      command.force_n = values[0];
      command.feed_min = values[1] * state_.length_unit();
      command.feed_max = values[2] * state_.length_unit();
      command.per_revolution = state_.modal.feed_mode() == FeedMode::per_revolution;
      break;
    case ForceControl::Kind::oscillate:
      command.oscillation_n = values[0];
      command.oscillation_hz = values[1];
      break;
    case ForceControl::Kind::vibration_on:
      command.level_um = values[0];
      command.reduced_mass_kg = values[1];
      command.oscillation_hz = values[2];
      break;
    case ForceControl::Kind::depth:
      command.depth_mm = values[0] * state_.length_unit();
      break;
  }
  if (!state_.channel.has_force_control) {
    const bool is_mill = state_.channel.kind == ChannelKind::mill;
    return vm_.fail("E6060",
                    is_mill
                        ? "force control is not possible on a mill: it takes the cutting radius "
                          "from the X axis"
                        : "force control needs a power sensor of the channel's spindle",
                    "not in this channel");
  }
  if (!are_possible(command))
    return vm_.fail("E6061", "force control does not accept these values", "values not accepted");
  state_.begin_commands(vm_.instruction_origin());
  state_.queue.emit(command);
}

// The arguments are on the stack: nothing, the value, or value and axis.
std::optional<ToolOverhang> BlockDirectives::pop_overhang(const Instruction& instruction) {
  ToolOverhang overhang;
  if (instruction.count == 0) return overhang;
  overhang.axis = state_.channel_words.geometry_axis(0).number();
  if (instruction.count == 2)
    overhang.axis = static_cast<int>(std::lround(vm_.stack().pop_number()));
  overhang.value_mm = vm_.stack().pop_number() * state_.length_unit();
  const bool is_linear = overhang.axis >= 0 && !state_.channel.axes[overhang.axis].rotary;
  if (is_linear) return overhang;
  vm_.fail("E4306", "a tool overhang needs a linear axis of the channel", "no such axis");
  return std::nullopt;
}

// Checked at once, in force when the axes stand.
void BlockDirectives::ask_overhang(const Instruction& instruction) {
  const auto overhang = pop_overhang(instruction);
  if (!overhang) return;
  if (state_.modal.tool.active == 0) {
    return vm_.fail("E5012", "there is no active tool whose overhang could be set", "no tool");
  }
  pending_.expect_overhang(*overhang);
  requests_.ask(ProgramRequest{});
}

void BlockDirectives::finish_overhang() {
  state_.begin_commands(vm_.instruction_origin());
  ActiveBlock block = state_.block_at(vm_.span().line);
  set_overhang(block, pending_.overhang());
}

// #workpiece and #workpiece_pos: for displays and simulation; they do not act on motion. Sizes,
// zero and position are program units; the resolution of the display is in mm.
void BlockDirectives::announce_workpiece(const Instruction& instruction) {
  std::vector<double> arguments(instruction.count);
  for (std::size_t i = arguments.size(); i-- > 0;) arguments[i] = vm_.stack().pop_number();
  state_.begin_commands(vm_.instruction_origin());
  if (instruction.extra == 1) return place_workpiece(arguments);
  if (instruction.extra == 2)
    return announce_file(vm_.file().texts[instruction.operand], arguments);
  if (!check_workpiece(arguments)) return;
  const double unit = state_.length_unit();
  WorkpieceShape shape;
  shape.type = static_cast<int>(arguments[type]);
  shape.machining_type = static_cast<int>(arguments[machining]);
  shape.screen_resolution_mm = arguments[resolution];
  for (std::size_t k = 0; k < 3; ++k) {
    shape.size_mm[k] = arguments[size_x + k] * unit;
    shape.zero_mm[k] = arguments[zero_x + k] * unit;
  }
  state_.queue.emit(WorkpieceAnnouncement{shape, {}});
}

// The blank of an STL file; its scale is in mm whatever the units of the program.
void BlockDirectives::announce_file(const std::string& name, const std::vector<double>& arguments) {
  const FoundBlank& found = vm_.program().blanks.at({vm_.frames().back().file, name});
  WorkpieceShape shape;
  shape.type = file_type;
  shape.machining_type = static_cast<int>(arguments[machining]);
  shape.screen_resolution_mm = arguments[resolution];
  shape.scale = arguments.size() > file_scale ? arguments[file_scale] : 1.0;
  shape.fingerprint = found.file.fingerprint;
  for (std::size_t k = 0; k < 3; ++k) {
    shape.size_mm[k] = shape.scale * (found.file.high[k] - found.file.low[k]);
    shape.zero_mm[k] = arguments[file_zero_x + k] * state_.length_unit();
  }
  if (check_file(arguments, shape.size_mm))
    state_.queue.emit(WorkpieceAnnouncement{shape, found.path});
}

// What is smaller than a few rays or larger than any machine is in another unit.
bool BlockDirectives::check_file(const std::vector<double>& arguments,
                                 const std::array<double, 3>& size_mm) {
  constexpr double cells_min = 2.0;
  constexpr double size_max_mm = 1e5;
  if (arguments[type] != file_type)
    return refuse_workpiece("a blank from a file has type 2", "type");
  if (arguments.size() > file_scale && !(arguments[file_scale] > 0.0))
    return refuse_workpiece("the scale must be above 0; it is the mm per unit of the file",
                            "scale");
  if (!check_display(arguments)) return false;
  const auto [smallest, largest] = std::minmax_element(size_mm.begin(), size_mm.end());
  if (*smallest >= cells_min * arguments[resolution] && *largest <= size_max_mm) return true;
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "the blank of the file is %g x %g x %g mm, %s",
                size_mm[0], size_mm[1], size_mm[2],
                *largest > size_max_mm ? "larger than 100 m" : "less than two resolutions thin");
  Diagnostic fault = vm_.diagnostic("E3021", text.data(), "blank of a file");
  fault.help.emplace_back(
      "STL files have no unit: give the mm per unit of the file as the last argument (25.4 for "
      "inches, 1000 for m), or another resolution");
  vm_.fail_with(std::move(fault));
  return false;
}

bool BlockDirectives::check_display(const std::vector<double>& arguments) {
  if (!(arguments[resolution] > 0.0))
    return refuse_workpiece("the screen resolution must be above 0 mm", "resolution");
  if (arguments[machining] != 0.0 && arguments[machining] != 1.0)
    return refuse_workpiece("the machining type is 0, milling, or 1, turning", "machining type");
  return true;
}

bool BlockDirectives::refuse_workpiece(const char* message, const char* label) {
  vm_.fail("E3021", message, label);
  return false;
}

void BlockDirectives::place_workpiece(const std::vector<double>& arguments) {
  WorkpiecePosition position;
  for (std::size_t k = 0; k < 3; ++k) {
    position.position_mm[k] = arguments[k] * state_.length_unit();
    position.angles_deg[k] = arguments[k + 3];
  }
  state_.queue.emit(position);
}

bool BlockDirectives::check_workpiece(const std::vector<double>& arguments) {
  const double kind = arguments[type];
  if (kind == file_type) {
    return refuse_workpiece(
        "type 2 names a file: `#workpiece (2, resolution, machining, \"file.stl\", zero_X, zero_Y, "
        "zero_Z)`",
        "type");
  }
  if (kind != 0.0 && kind != 1.0)
    return refuse_workpiece("the type is 0, a box, 1, a cylinder, or 2, an STL file", "type");
  if (!check_display(arguments)) return false;
  if (arguments[size_x] <= 0.0 || arguments[size_z] <= 0.0)
    return refuse_workpiece("sizes must be above 0", "size");
  if (kind == 0.0 && arguments[size_y] <= 0.0)
    return refuse_workpiece("sizes must be above 0", "size");
  const bool hollow_fits = arguments[size_y] >= 0.0 && arguments[size_y] < arguments[size_x];
  if (kind == 1.0 && !hollow_fits)
    return refuse_workpiece("the inner diameter must be between 0 and the diameter",
                            "inner diameter");
  return true;
}

// save_gvector (parts)
void BlockDirectives::save_gvector() {
  const double parts = vm_.stack().pop_number();
  if (!is_integer(parts) || parts < 0.5 || parts > state_all + 0.5) {
    return vm_.fail("E3009", "save_gvector takes a sum of GV_MODAL to GV_COOLANT",
                    "not such a sum");
  }
  vm_.stack().push(
      value_of(saved_state_text(state_.modal, static_cast<StateParts>(std::lround(parts)))));
}

// restore_gvector (text): a sync point; the state is restored with the answer.
void BlockDirectives::restore_gvector(const Instruction& instruction) {
  const Value text = vm_.stack().pop();
  const auto saved = read_saved_state(text_of(text));
  if (!saved) {
    return vm_.fail("E3022", "this text is not a saved state", "damaged, or of another version");
  }
  ProgramRequest request;
  request.statement = instruction.count != 0;
  pending_.expect_restoring({*saved, request.statement});
  requests_.ask(std::move(request));
}

void BlockDirectives::finish_restoring() {
  const PendingAnswer::Restoring& restoring = pending_.restoring();
  StateParts parts = restoring.saved.parts;
  if ((parts & state_modal) != 0) parts |= state_motion;
  const ModalState& state = restoring.saved.state;
  const std::string_view reason = reason_against_restoring(state_.modal, state, parts);
  if (reason.empty()) {
    state_.begin_commands(vm_.instruction_origin());
    ActiveBlock block = state_.block_at(vm_.span().line);
    restore_state(block, state, parts);
  }
  vm_.stack().push(value_of(reason.empty()));
  if (reason.empty()) return;
  pending_.set_channel_error(reason);
  if (restoring.is_statement)
    vm_.fail("E4014", "the saved state cannot be restored", std::string(reason));
}

}  // namespace stanok::lang
