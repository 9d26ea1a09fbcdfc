// Action of table input, G10, in the Fanuc dialect.
//
//   G10 L2 P1..P6 X Y Z     work offsets G54 to G59          G10 L20 P1..P300   those of G54.1 P
//   G10 L10 P R   length    L11 its wear    L12 radius    L13 its wear             (mills)
//   G10 P X Z R Q   wear of tool P; P10001 and on: its geometry                    (lathes)
//
// With G91 the values are added to what the table has. X of a lathe is a diameter. Source: Fanuc
// operator's manuals B-63944EN (7.2.2, 14.2) and B-64304EN-1 (5.1.6).
#include <array>
#include <string>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

const WordName code_g10{'G', g(10), {}};

// Rows of the offset table: G54 to G59, and behind G59.3 those of G54.1 P1 and on.
constexpr int page_of_g54 = 1;
constexpr int pages_of_g54 = 6;
constexpr int page_of_g54_1 = 10;
constexpr int pages_of_g54_1 = 300;

enum class OffsetTable : std::uint8_t { g54, g54_1 };

void fail_kind(ActiveBlock& block, const std::string& kinds) {
  block.fail("E4008", {'L', -1, {}}, "`G10` has " + kinds + " in the dialect fanuc",
             "no such kind");
}

bool refuse_unused(ActiveBlock& block, LetterSet used) {
  for (const char letter : {'R', 'I', 'J', 'Q'}) {
    if (!block.has(letter) || (used & letter_bit(letter)) != 0) continue;
    block.fail("E4003", {letter, -1, {}}, std::string("this `G10` does not use `") + letter + "`",
               "unused word");
    return true;
  }
  return false;
}

// The row of the offset table that L and P name.
std::optional<int> offset_row(ActiveBlock& block, OffsetTable table) {
  const bool additional = table == OffsetTable::g54_1;
  const auto number = block.integer('P', 0, additional ? pages_of_g54_1 : pages_of_g54);
  if (!number) return std::nullopt;
  if (*number == 0) {
    block
        .fail("E5001", {'P', -1, {}}, "there is no external work offset",
              "on Fanuc controls P0 is the external work offset")
        .help.emplace_back("write each work offset itself; `P1` is G54");
    return std::nullopt;
  }
  const int row = (additional ? page_of_g54_1 : page_of_g54) + *number - 1;
  if (block.tables.work_offset(row)) return row;
  block.fail("E5001", {'P', -1, {}}, "there is no work offset " + std::to_string(row),
             "unknown work offset");
  return std::nullopt;
}

void write_fanuc_offset(ActiveBlock& block, OffsetTable table) {
  if (refuse_unused(block, 0)) return;
  const auto row = offset_row(block, table);
  if (!row) return;
  const AxisValues before = *block.tables.work_offset(*row);
  const bool added = block.modal.code(Group::distance) == g(91);
  if (block.programmed == 0)
    block.fail("E4007", code_g10, "`G10` has nothing to write", "no value");
  for (std::size_t i = 0; i < block.channel.axes.size() && !block.failed(); ++i) {
    if (!is_programmed(block, i)) continue;
    write_offset(block, *row, block.channel.axes[i].word, static_cast<int>(i),
                 added ? before[i] + block.values[i] : block.values[i]);
  }
}

// What the table has is not known here with its wear apart.
bool refuse_increments(ActiveBlock& block) {
  if (block.modal.code(Group::distance) != g(91)) return false;
  block.fail("E4016", code_g10, "`G10` cannot add to the values of a tool", "increments")
      .help.emplace_back("write the absolute value with `G90`");
  return true;
}

// L10 to L13, in this order; L1 is L11 as on older controls.
constexpr std::array<std::string_view, 4> mill_values{"length", "wear_length", "radius",
                                                      "wear_radius"};

void write_mill_tool(ActiveBlock& block, std::string_view value) {
  if (refuse_unused(block, letters_of("R")) || refuse_increments(block)) return;
  if (block.programmed != 0) {
    block.fail("E4003", code_g10, "this `G10` takes its value from R, not from axis words",
               "unused axis word");
    return;
  }
  const auto number = block.integer('P', 1, 99999999);
  const auto tool = number ? table_tool(block, *number) : std::nullopt;
  if (!tool) return;
  if (!block.has('R')) {
    block.fail("E4007", code_g10, "`G10` needs R, the value of the tool", "no R");
  } else if (value == "radius" && block.value('R') < 0.0) {
    block.fail("E4008", {'R', -1, {}}, "the radius of a tool must not be negative", "negative");
  } else {
    write_tool(block, *tool, value, block.length('R'));
  }
}

constexpr int geometry_first = 10000;

void write_lathe_tool(ActiveBlock& block) {
  if (refuse_unused(block, letters_of("RQ")) || refuse_increments(block)) return;
  const auto number = block.integer('P', 1, 99999999);
  if (!number) return;
  const bool geometry = *number > geometry_first;
  const auto tool = table_tool(block, geometry ? *number - geometry_first : *number);
  if (!tool) return;
  const AxisIndex x = block.modal.geometry[0];
  const AxisIndex z = block.modal.geometry[2];
  const auto has = [&](AxisIndex axis) {
    return axis.exists() && (block.programmed & axis_bit(axis)) != 0;
  };
  if (has(x)) write_tool(block, *tool, geometry ? "length_x" : "wear_length_x", block.values[x]);
  if (has(z)) write_tool(block, *tool, geometry ? "length" : "wear_length", block.values[z]);
  if (block.has('R'))
    write_tool(block, *tool, geometry ? "radius" : "wear_radius", block.length('R'));
  if (!block.has('Q')) return;
  const auto tip = block.integer('Q', 0, 9);
  if (tip) write_tool(block, *tool, "orientation", *tip);
}

}  // namespace

void write_fanuc_table(ActiveBlock& block) {
  const bool lathe = block.channel.kind == ChannelKind::lathe;
  if (!block.has('P')) {
    block.fail("E4007", code_g10, "`G10` needs P, the row of the table", "no P");
    return;
  }
  if (!block.has('L')) {
    if (lathe) return write_lathe_tool(block);
    block.fail("E4007", code_g10, "`G10` needs L, the kind of value", "no L");
    return;
  }
  const double kind = block.value('L');
  if (kind == 2.0) return write_fanuc_offset(block, OffsetTable::g54);
  if (kind == 20.0) return write_fanuc_offset(block, OffsetTable::g54_1);
  if (lathe) return fail_kind(block, "the kinds L2 and L20, and none for tools");
  if (kind == 1.0) return write_mill_tool(block, mill_values[1]);
  for (std::size_t i = 0; i < mill_values.size(); ++i) {
    if (kind == 10.0 + static_cast<double>(i)) return write_mill_tool(block, mill_values[i]);
  }
  fail_kind(block, "the kinds L2, L20 and L10 to L13");
}

}  // namespace stanok::lang
