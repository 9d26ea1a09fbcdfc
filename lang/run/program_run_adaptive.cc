// #adaptive: the orders of a program to force control, in units of the machine.
#include <algorithm>

#include "lang/run/program_run.h"

namespace stanok::lang {
namespace {

// Values are positive; an oscillation of 0 N ends one, and the clamps ascend.
bool are_possible(const ForceControl& order) {
  if (order.kind == ForceControl::Kind::force) {
    return order.force_n > 0.0 && order.feed_min >= 0.0 &&
           (order.feed_max == 0.0 || order.feed_min < order.feed_max);
  }
  if (order.kind == ForceControl::Kind::oscillate)
    return order.oscillation_n >= 0.0 && order.oscillation_hz > 0.0;
  return order.level_um >= 0.0 && order.reduced_mass_kg >= 0.0 && order.oscillation_hz >= 0.0;
}

}  // namespace

// The values are on the stack in their order.
void ProgramRun::order_force_control(const Instruction& instruction) {
  ForceControl order;
  order.kind = static_cast<ForceControl::Kind>(instruction.extra);
  std::array<double, 3> values{};
  for (std::size_t i = instruction.count; i-- > 0;) values.at(i) = pop_number();
  const double mm = modal_.inches() ? mm_per_inch : 1.0;
  switch (order.kind) {
    case ForceControl::Kind::off:
    case ForceControl::Kind::vibration_off:
      break;
    case ForceControl::Kind::force:
      order.force_n = values[0];
      order.feed_min = values[1] * mm;
      order.feed_max = values[2] * mm;
      order.per_revolution = modal_.feed_mode() == FeedMode::per_revolution;
      break;
    case ForceControl::Kind::oscillate:
      order.oscillation_n = values[0];
      order.oscillation_hz = values[1];
      break;
    case ForceControl::Kind::vibration_on:
      order.level_um = values[0];
      order.reduced_mass_kg = values[1];
      order.oscillation_hz = values[2];
      break;
  }
  if (!channel_.has_force_control)
    return fail("E6060", "force control needs a power sensor of the channel's spindle",
                "not in this channel");
  if (!are_possible(order))
    return fail("E6061", "values that force control cannot take", "not these values");
  queue_.set_origin({frames_.back().file, span().line}, block_);
  queue_.emit(order);
}

}  // namespace stanok::lang
