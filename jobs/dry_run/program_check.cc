// check_program: from the first program into those that it dispatches, and beyond errors of a text.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "jobs/dry_run/blanked_files.h"
#include "jobs/dry_run/dry_run.h"

namespace stanok::jobs {
namespace {

constexpr std::uint64_t steps_behind_errors = 1'000'000;  // of a text whose faulty lines are blank

// W213 is the sum of the errors that are not shown, E2042 says that the text is for something else.
bool may_say_more(const Diagnostics& diagnostics) {
  return std::ranges::none_of(
      diagnostics, [](const Diagnostic& one) { return one.code == "W213" || one.code == "E2042"; });
}

// Walks from the first program into the programs that it dispatches, each pair of channel, scheme
// and program once.
class Check {
 public:
  Check(const channels::MachineConfig& machine, const lang::Files& files, const GivesUp& gives_up)
      : machine_(machine), files_(files), manner_{BlockFaults::are_collected, gives_up} {}

  void follow(int channel, int scheme, const std::string& program) {
    if (!visited_.insert({channel, scheme, program}).second) return;
    std::map<int, int> schemes;
    DryRun dry_run(machine_, channel, scheme, files_);
    auto result = dry_run.run(
        program, Reachability::checked, [](const lang::Command&, const motion::PathBlock*) {},
        [&](const lang::ProgramRequest& request, const lang::Command&) {
          if (request.kind == lang::RequestKind::kinematics)
            schemes[request.channel] = request.number;
          const bool dispatches = request.kind == lang::RequestKind::channel_run ||
                                  request.kind == lang::RequestKind::channel_load;
          if (!dispatches) return;
          const auto active = schemes.find(request.channel);
          follow(request.channel, active == schemes.end() ? -1 : active->second, request.text);
        },
        manner_);
    if (!result.loaded && may_say_more(result.diagnostics))
      look_behind(result.diagnostics, channel, scheme, program);
    for (Diagnostic& diagnostic : result.diagnostics) keep(std::move(diagnostic));
    found.blocks += result.blocks;
    found.laws.insert(found.laws.end(), result.laws.begin(), result.laws.end());
    found.planes.insert(found.planes.end(), result.planes.begin(), result.planes.end());
  }

  DryRunResult found;

 private:
  // A text with errors is not a program, but its other lines may have faults of their own: they are
  // followed with what is at fault blank. What is missing then may make further errors, and they
  // are blanked, too, and not told; nor is what depends on blocks that are missing.
  void look_behind(Diagnostics& diagnostics, int channel, int scheme, const std::string& program) {
    constexpr int rounds_max = 10;
    channels::MachineConfig machine = machine_;
    machine.program_bounds.steps = std::min(machine.program_bounds.steps, steps_behind_errors);
    BlankedFiles blanked(files_);
    Diagnostics errors = diagnostics;
    for (int round = 0; round < rounds_max && blanked.blank(errors); ++round) {
      DryRun dry_run(machine, channel, scheme, blanked);
      auto result = dry_run.run(
          program, Reachability::checked, [](const lang::Command&, const motion::PathBlock*) {},
          [](const lang::ProgramRequest&, const lang::Command&) {}, manner_);
      errors = std::move(result.diagnostics);
      if (!result.loaded) continue;
      for (Diagnostic& fault : errors) {
        const bool is_of_a_block = fault.code.starts_with("E4") || fault.code.starts_with("E51");
        const bool is_sure = FaultSieve::is_of_its_block(fault) ||
                             (is_of_a_block && !blanked.may_miss_before(fault.place));
        if (fault.severity == Severity::error && is_sure && !blanked.is_blank(fault.place))
          diagnostics.push_back(std::move(fault));
      }
      return;
    }
  }

  // A fault is told once; what the text warns of and the run then meets is the error.
  void keep(Diagnostic&& diagnostic) {
    const auto known = std::ranges::find_if(found.diagnostics, [&](const Diagnostic& other) {
      return other.code == diagnostic.code && other.place.file == diagnostic.place.file &&
             other.place.line == diagnostic.place.line &&
             other.place.column == diagnostic.place.column && other.message == diagnostic.message;
    });
    if (known == found.diagnostics.end())
      found.diagnostics.push_back(std::move(diagnostic));
    else if (diagnostic.severity == Severity::error)
      known->severity = Severity::error;
  }

  const channels::MachineConfig& machine_;
  const lang::Files& files_;
  RunManner manner_;
  std::set<std::tuple<int, int, std::string>> visited_;
};

}  // namespace

DryRunResult check_program(const channels::MachineConfig& machine, int channel, int scheme,
                           const std::string& program, const lang::Files& files,
                           const GivesUp& gives_up) {
  Check check(machine, files, gives_up);
  check.follow(channel, scheme, program);
  sort_by_place(check.found.diagnostics, program);
  return std::move(check.found);
}

}  // namespace stanok::jobs
