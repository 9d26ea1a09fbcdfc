#include "jobs/dry_run/program_advice.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace stanok::jobs {
namespace {

Diagnostic warning_of(std::string_view code, std::string message, std::string help) {
  Diagnostic warning;
  warning.code = code;
  warning.severity = Severity::warning;
  warning.message = std::move(message);
  warning.help.push_back(std::move(help));
  return warning;
}

std::string speed_text(double speed_rev_per_min) {
  return std::to_string(std::llround(speed_rev_per_min));
}

}  // namespace

std::optional<Diagnostic> ProgramAdvice::advice(const lang::Command& command) {
  if (const auto* spindle = std::get_if<lang::SpindleCommand>(&command.payload))
    return at_spindle(*spindle);
  if (const auto* change = std::get_if<lang::ToolChange>(&command.payload)) {
    if (change->tool != 0) cuts_with_spindle_ = true;
    return std::nullopt;
  }
  if (const auto* end = std::get_if<lang::ProgramEnd>(&command.payload)) return at_end(*end);
  const auto* move = std::get_if<lang::Move>(&command.payload);
  return move == nullptr ? std::nullopt : at_move(*move);
}

std::optional<Diagnostic> ProgramAdvice::at_spindle(const lang::SpindleCommand& spindle) {
  using lang::SpindleAction;
  const bool starts = spindle.action == SpindleAction::clockwise ||
                      spindle.action == SpindleAction::counter_clockwise;
  if (starts) cuts_with_spindle_ = spindle_turns_ = true;
  if (spindle.action == SpindleAction::stop) spindle_turns_ = false;
  if (told_speed_ || channel_.spindles.empty()) return std::nullopt;
  const int id = spindle.spindle > 0 ? spindle.spindle : channel_.spindles.front();
  const auto row = std::find_if(machine_.spindles.begin(), machine_.spindles.end(),
                                [id](const channels::SpindleConfig& one) { return one.id == id; });
  const bool known = row != machine_.spindles.end() && row->speed_max > 0.0;
  if (!known || spindle.speed_rev_per_min <= row->speed_max) return std::nullopt;
  told_speed_ = true;
  return warning_of("W413",
                    "S" + speed_text(spindle.speed_rev_per_min) + " is above the " +
                        speed_text(row->speed_max) + " rev/min of spindle " + std::to_string(id),
                    "the spindle turns at most at `speed_max` of the machine file; correct S, and "
                    "with it F");
}

std::optional<Diagnostic> ProgramAdvice::at_move(const lang::Move& move) {
  const bool cuts = move.kind != lang::MoveKind::rapid && !spindle_turns_ && cuts_with_spindle_;
  if (!cuts || told_standing_) return std::nullopt;
  told_standing_ = true;
  return warning_of("W411", "a move at feed while no spindle turns",
                    "if the tool cuts here, start the spindle before, e.g. `S1000 M3`");
}

std::optional<Diagnostic> ProgramAdvice::at_end(const lang::ProgramEnd& end) {
  if (!end.compensated) return std::nullopt;
  return warning_of("W412", "radius compensation is still active where the program ends",
                    "leave the contour with `G40` before");
}

}  // namespace stanok::jobs
