#include "jobs/lobes/program_speeds.h"

#include <set>
#include <variant>

#include "jobs/dry_run/dry_run.h"

namespace stanok::jobs {

ProgramSpeeds program_speeds(const ProgramSpeedsRequest& request) {
  DryRun dry_run(request.machine, request.channel, request.scheme, request.files);
  std::set<double> speeds;
  double speed = 0.0;
  const auto take = [&](const lang::Command& command, const motion::PathBlock*) {
    if (const auto* const spindle = std::get_if<lang::SpindleCommand>(&command.payload)) {
      using Action = lang::SpindleAction;
      const bool is_constant = spindle->cutting_speed_m_per_min == 0.0;
      if (spindle->action == Action::stop || spindle->action == Action::orient) {
        speed = 0.0;
      } else if (spindle->spindle == 0 && is_constant) {
        speed = spindle->speed_rev_per_min;
      }
    } else if (const auto* const move = std::get_if<lang::Move>(&command.payload)) {
      if (move->kind != lang::MoveKind::rapid && speed > 0.0) speeds.insert(speed);
    }
  };
  DryRunResult result = dry_run.run(request.program, Reachability::unchecked, take,
                                    [](const lang::ProgramRequest&, const lang::Command&) {});
  const bool is_program = !has_errors(result.diagnostics);
  ProgramSpeeds found{.diagnostics = std::move(result.diagnostics), .rev_per_min = {}};
  if (is_program) found.rev_per_min.assign(speeds.begin(), speeds.end());
  return found;
}

}  // namespace stanok::jobs
