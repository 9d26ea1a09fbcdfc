#include "lang/block/active_block.h"

#include <cmath>

#include "lang/text/number.h"

namespace stanok::lang {

BlockFault& ActiveBlock::fail(std::string_view code, WordName word, std::string message,
                              std::string label) {
  std::optional<BlockFault>& told = faults.first ? faults.later : faults.first;
  told = fault_at(code, std::move(word), std::move(message), std::move(label));
  return *told;
}

double length_along(const BlockSurroundings& around, AxisIndex axis,
                    const std::array<double, 3>& lengths_mm) {
  const int geometry = around.channel.axes[axis].geometry;
  const bool takes_part = (around.tables.axes_of_scheme() & axis.bit()) != 0;
  if (geometry < 0 || geometry > 2 || !takes_part) return 0.0;
  return lengths_mm[AxisIndex(geometry).place()];
}

std::optional<int> ActiveBlock::integer(char letter, int smallest, int largest) {
  const double number = value(letter);
  if (is_integer(number) && number >= smallest - 0.5 && number <= largest + 0.5) {
    return static_cast<int>(std::lround(number));
  }
  fail("E4008", {letter, -1, {}},
       std::string("`") + letter + "` must be a whole number from " + std::to_string(smallest) +
           " to " + std::to_string(largest),
       "out of range");
  return std::nullopt;
}

}  // namespace stanok::lang
