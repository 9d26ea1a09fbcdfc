// Action of table input, G10: tools (L1, L10, L11) and work offsets (L2, L20).
//
// L1 and L2 write what the words say; L10, L11 and L20 write the value with which the point where
// the axes stand has the programmed coordinates. Values that go into a table as they are count as
// radii in diameter mode, too; coordinates do not.
#include <cmath>
#include <string>

#include "lang/actions/actions.h"
#include "lang/block/tool_value.h"

namespace stanok::lang {
namespace {

constexpr int work_offset_max = 309;
constexpr int fixture_offset = 9;  // G59.3, the system of L11

const WordName g10{'G', g(10), {}};

struct ToolTableWord {
  char letter;
  std::string_view parameter;  // its name in the tool table
};
constexpr ToolTableWord tool_words[] = {
    {'R', "radius"}, {'I', "angle_front"}, {'J', "angle_back"}, {'Q', "orientation"}};
constexpr std::array<std::string_view, 3> length_parameters{"length_x", "length_y", "length"};

// Words that this kind of G10 has no use for are errors.
bool check_words(ActiveBlock& block, int kind, LetterSet used) {
  for (const char letter : {'R', 'I', 'J', 'Q'}) {
    if (!block.has(letter) || (used & letter_bit(letter)) != 0) continue;
    block.fail("E4003", {letter, -1, {}},
               "`G10 L" + std::to_string(kind) + "` does not use `" + letter + "`", "unused word");
    return false;
  }
  if (block.programmed != 0 || (block.words.letters & used) != 0) return true;
  block.fail("E4007", g10, "`G10` has nothing to write", "no value");
  return false;
}

// Page of the offset table; P0 is the active one.
std::optional<int> table_page(ActiveBlock& block) {
  const auto page = block.integer('P', 0, work_offset_max);
  if (!page) return std::nullopt;
  const int number = *page == 0 ? block.modal.frames.work_offset_number : *page;
  if (block.tables.work_offset(number)) return number;
  block.fail("E5001", {'P', -1, {}}, "there is no work offset " + std::to_string(number),
             "unknown work offset");
  return std::nullopt;
}

std::optional<int> table_tool(ActiveBlock& block) {
  const auto number = block.integer('P', 1, 99999999);
  return number ? table_tool(block, *number) : std::nullopt;
}

// Where the point that stands has to lie in the base so that, in the system `frame`, it has the
// programmed coordinates; the others stay as they are in that system.
AxisValues wanted_base(const ActiveBlock& block, const WorkFrame& frame) {
  const ModalState& modal = block.modal;
  const WorkFrame active = modal.frame();
  AxisValues point = frame == active
                         ? modal.position_W
                         : frame.work_from_base(active.base_from_work(modal.position_W));
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) point[i] = modal.map.to_work(i, block.values[i]);
  }
  return frame.base_from_work(point);
}

void write_work_offset(ActiveBlock& block) {
  const auto page = table_page(block);
  if (!page) return;
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_programmed(block, i)) continue;
    write_offset(block, *page, block.channel.axes[i].word, static_cast<int>(i),
                 table_value(block, i));
  }
  if (block.has('R')) write_offset(block, *page, "R", rotation_of_offset, block.value('R'));
}

// In a turned system a coordinate along one of its axes lies along several axes of the base: each
// of them whose offset changes is written.
void write_work_offset_here(ActiveBlock& block) {
  if (excluded_by_mode(block, g(10), {Exclusion::transformation, Exclusion::carried_offset}))
    return;
  const auto page = table_page(block);
  if (!page) return;
  ModalState there = block.modal;
  take_work_offset(there, block.tables, *page);
  const AxisValues point_B = block.modal.frame().base_from_work(block.modal.position_W);
  const AxisValues wanted_B = wanted_base(block, there.frame());
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    const bool moved = std::abs(point_B[i] - wanted_B[i]) > position_noise;
    if (!is_programmed(block, i) && !moved) continue;
    write_offset(block, *page, block.channel.axes[i].word, static_cast<int>(i),
                 there.frames.work_offset[i] + point_B[i] - wanted_B[i]);
  }
}

bool check_lengths(ActiveBlock& block) {
  AxisSet lengths = 0;
  for (const AxisIndex axis : block.modal.geometry) {
    lengths = static_cast<AxisSet>(lengths | axis_bit(axis));
  }
  return only_axes(block, g(10), lengths);
}

// R, I, J and Q, which mean the same in L1, L10 and L11.
void write_tool_words(ActiveBlock& block, int tool) {
  for (const ToolTableWord& word : tool_words) {
    if (!block.has(word.letter)) continue;
    double value = block.value(word.letter);
    if (word.letter == 'R') value = block.length('R');
    if (word.letter == 'R' && value < 0.0) {
      block.fail("E4008", {'R', -1, {}}, "the radius of a tool must not be negative", "negative");
      return;
    }
    if (word.letter == 'Q' && !block.integer('Q', 0, 9)) return;
    write_tool(block, tool, word.parameter, value);
  }
}

// `lengths` along X, Y, Z, of which those of the axes `written` are.
void write_tool_row(ActiveBlock& block, int tool, const AxisValues& lengths, AxisSet written) {
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.modal.geometry[k];
    if ((written & axis_bit(axis)) == 0) continue;
    write_tool(block, tool, length_parameters[k], lengths[axis]);
  }
  write_tool_words(block, tool);
}

void write_tool_values(ActiveBlock& block) {
  const auto tool = table_tool(block);
  if (!tool || !check_lengths(block)) return;
  AxisValues lengths{};
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) lengths[i] = table_value(block, i);
  write_tool_row(block, *tool, lengths, block.programmed);
}

// The system in which the point has the programmed coordinates: the active one (L10), or G59.3
// without G52, G92 and rotation (L11).
enum class LengthSystem { active, fixture };

// The length with which the point has the programmed coordinates.
void write_tool_length_here(ActiveBlock& block, LengthSystem system) {
  const bool in_fixture = system == LengthSystem::fixture;
  if (block.programmed == 0) {
    const std::string name = in_fixture ? "`G10 L11`" : "`G10 L10`";
    BlockFault& fault =
        block.fail("E4016", {'L', -1, {}}, name + " without an axis word", "no length");
    fault.notes.push_back({"on Fanuc controls R is then a length; here it is the radius", {}});
    fault.help.emplace_back("write the length with `G10 L1 P1 Z120.5`, the radius with `L1` and R");
    return;
  }
  if (excluded_by_mode(block, g(10),
                       {Exclusion::tcp, Exclusion::transformation, Exclusion::carried_offset}))
    return;
  const auto tool = table_tool(block);
  if (!tool || !check_lengths(block)) return;
  WorkFrame frame = block.modal.frame();
  if (in_fixture) {
    ModalState fixture;
    fixture.geometry = block.modal.geometry;
    take_work_offset(fixture, block.tables, fixture_offset);
    frame = fixture.frame();
  }
  const AxisValues point_B = block.modal.frame().base_from_work(block.modal.position_W);
  const AxisValues wanted_B = wanted_base(block, frame);
  const MachineReading reading = block.tables.machine_reading();
  AxisSet written = block.programmed;
  AxisValues lengths = machine_position(block);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = reading.in_base(i, lengths[i]) - wanted_B[i];
    if (std::abs(point_B[i] - wanted_B[i]) > position_noise)
      written = static_cast<AxisSet>(written | axis_bit(i));
  }
  write_tool_row(block, *tool, lengths, written);
}

}  // namespace

void write_tool(ActiveBlock& block, int tool, std::string_view parameter, double value, int edge) {
  ProgramRequest request;
  request.kind = RequestKind::tool_table_write;
  request.channel = tool_value_number(parameter);
  request.number = tool;
  request.index = edge;
  request.text = parameter;
  request.value = value;
  block.queue.emit(request);
}

void write_offset(ActiveBlock& block, int page, std::string_view parameter, int axis,
                  double value) {
  ProgramRequest request;
  request.kind = RequestKind::offset_table_write;
  request.channel = 1;  // the channel's own table
  request.number = page;
  request.index = axis;
  request.text = parameter;
  request.value = value;
  block.queue.emit(request);
}

std::optional<int> table_tool(ActiveBlock& block, int number) {
  if (block.tables.tool(number)) return number;
  block.fail("E5002", {'P', -1, {}}, "the tool table has no tool " + std::to_string(number),
             "unknown tool");
  return std::nullopt;
}

double table_value(const ActiveBlock& block, AxisIndex axis) {
  const bool halved = block.modal.diameters() && block.channel.axes[axis].geometry == 0;
  return halved ? 2.0 * block.values[axis] : block.values[axis];
}

void write_table(ActiveBlock& block, CodeNumber) {
  if (block.words.rules.is_fanuc()) return write_fanuc_table(block);
  for (const char letter : {'L', 'P'}) {
    if (block.has(letter)) continue;
    block.fail("E4007", g10, std::string("`G10` needs ") + letter,
               letter == 'L' ? "no L, the kind of value" : "no P, the row of the table");
    return;
  }
  const LetterSet tool_letters = letters_of("RIJQ");
  const double kind = block.value('L');
  if (kind == 1.0 && check_words(block, 1, tool_letters)) return write_tool_values(block);
  if (kind == 2.0 && check_words(block, 2, letters_of("R"))) return write_work_offset(block);
  if (kind == 10.0 && check_words(block, 10, tool_letters)) {
    return write_tool_length_here(block, LengthSystem::active);
  }
  if (kind == 11.0 && check_words(block, 11, tool_letters)) {
    return write_tool_length_here(block, LengthSystem::fixture);
  }
  if (kind == 20.0 && check_words(block, 20, 0)) return write_work_offset_here(block);
  if (block.failed()) return;
  block.fail("E4008", {'L', -1, {}}, "`G10` has the kinds L1, L2, L10, L11 and L20",
             "no such kind");
}

}  // namespace stanok::lang
