#include "client/offline/process/program_speeds.h"

#include <set>
#include <stdexcept>
#include <variant>

#include "client/terminal/diagnostic_output.h"
#include "jobs/dry_run/dry_run.h"
#include "runtime/program_files.h"

namespace stanok::client {

std::vector<double> speeds_of_program(const std::string& program, const JobOptions& job) {
  const config::MachineFile machine = machine_file_of(job);
  const LocatedProgram located = locate(program);
  const runtime::ProgramFiles files(search_roots({located}, job),
                                    runtime::program_format(machine.machine));
  jobs::DryRun dry_run(machine.machine, job.channel, scheme_of(job), files);
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
  const auto result = dry_run.run(located.name, jobs::Reachability::unchecked, take,
                                  [](const lang::Request&, const lang::Command&) {});
  for (const Diagnostic& diagnostic : result.diagnostics) print(diagnostic);
  if (has_errors(result.diagnostics)) throw std::runtime_error(program + " has errors");
  return {speeds.begin(), speeds.end()};
}

}  // namespace stanok::client
