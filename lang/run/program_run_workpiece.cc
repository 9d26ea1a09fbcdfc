// #workpiece and #workpiece_pos: for displays and simulation; they do not act on motion.
//
// Sizes, zero and position are program units; the resolution of the display is in mm.
#include "lang/run/program_run.h"

namespace stanok::lang {
namespace {

enum Argument : std::size_t {
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

}  // namespace

void ProgramRun::announce_workpiece(const Instruction& instruction) {
  std::vector<double> arguments(instruction.count);
  for (std::size_t i = arguments.size(); i-- > 0;) arguments[i] = pop_number();
  const double unit = modal_.inches() ? mm_per_inch : 1.0;
  queue_.set_origin({frames_.back().file, span().line}, block_);
  if (instruction.extra == 1) {
    WorkpiecePosition position;
    for (std::size_t k = 0; k < 3; ++k) {
      position.position_mm[k] = arguments[k] * unit;
      position.angles_deg[k] = arguments[k + 3];
    }
    return queue_.emit(position);
  }
  if (!check_workpiece(arguments)) return;
  WorkpieceAnnouncement workpiece;
  workpiece.type = static_cast<int>(arguments[type]);
  workpiece.machining_type = static_cast<int>(arguments[machining]);
  workpiece.screen_resolution_mm = arguments[resolution];
  for (std::size_t k = 0; k < 3; ++k) {
    workpiece.size_mm[k] = arguments[size_x + k] * unit;
    workpiece.zero_mm[k] = arguments[zero_x + k] * unit;
  }
  queue_.emit(workpiece);
}

bool ProgramRun::check_workpiece(const std::vector<double>& arguments) {
  const auto refuse = [&](const char* message, const char* label) {
    fail("E3021", message, label);
    return false;
  };
  const double kind = arguments[type];
  if (kind == 2.0) {
    fail("E2090", "a workpiece from a file is not supported in this release", "type 2");
    return false;
  }
  if (kind != 0.0 && kind != 1.0) return refuse("the type is 0, a box, or 1, a cylinder", "type");
  if (arguments[resolution] <= 0.0)
    return refuse("the screen resolution is above 0 mm", "resolution");
  if (arguments[machining] != 0.0 && arguments[machining] != 1.0)
    return refuse("the machining type is 0, milling, or 1, turning", "machining type");
  if (arguments[size_x] <= 0.0 || arguments[size_z] <= 0.0)
    return refuse("sizes are above 0", "size");
  if (kind == 0.0 && arguments[size_y] <= 0.0) return refuse("sizes are above 0", "size");
  const bool hollow_fits = arguments[size_y] >= 0.0 && arguments[size_y] < arguments[size_x];
  if (kind == 1.0 && !hollow_fits)
    return refuse("the inner diameter lies between 0 and the diameter", "inner diameter");
  return true;
}

}  // namespace stanok::lang
