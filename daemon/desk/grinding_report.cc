// ProgramDesk::grinding: the cycle that is designed from a process file, or what a control file
// does. The computation is that of `stanok grind design` and `verify`; the answer has what its
// pictures need.

#include "config/files/grinding_file.h"
#include "config/text/config_error.h"
#include "daemon/desk/program_desk.h"
#include "jobs/grinding/grind_cycle.h"
#include "jobs/grinding/grinding_samples.h"
#include "process/grinding/control_file.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using process::DesignRequest;
using protocol::Failure;
using protocol::FailureKind;

constexpr double um_per_mm = 1000.0;
constexpr std::size_t samples_max = 600;

Unexpected<Failure> wrong_sheet(const config::ConfigFault& fault, const std::string& name) {
  const int line = static_cast<int>(fault.line);
  const int column = static_cast<int>(fault.column);
  const Place place{name, line, column, line, column};
  return Unexpected<Failure>({FailureKind::program_error, "E9102", fault.text, 0, place});
}

json findings_json(const process::Findings& findings) {
  json list = json::array();
  for (const process::Finding& finding : findings)
    list.push_back({{"code", finding.code}, {"text", finding.text}});
  return list;
}

json samples_json(const DesignRequest& request, const process::PlungeRun& run) {
  return jobs::thinned(jobs::grinding_samples(request.process, run), samples_max,
                       jobs::grinding_overview());
}

json boundary_json(const DesignRequest& request) {
  const process::Boundary boundary(request.process);
  json corners = json::array();
  for (const double H : {request.allowance_mm, request.process.critical_allowance_mm, 0.0})
    corners.push_back({H, boundary.at(H)});
  return corners;
}

json law_json(const process::InfeedLaw& law) {
  json rows = json::array();
  for (const process::InfeedRow& row : law) rows.push_back({row.x_mm, row.feed_mm_per_s});
  return rows;
}

json time_or_null(const std::optional<double>& time_s) {
  return time_s ? json(*time_s) : json(nullptr);
}

json answer(const std::string& name, const jobs::GrindCycle& cycle) {
  const auto& [request, design, corners] = cycle;
  const process::Verification& verification = design.verification;
  const process::PlungeRun& run = verification.run;
  const double constant_s = design.constant_safe_time_s;
  return {{"program", name},
          {"ok", !process::has_errors(verification.findings)},
          {"findings", findings_json(verification.findings)},
          {"time_s", run.time_s},
          {"least_time_s", design.least_time_s},
          {"constant_time_s", constant_s > 0.0 ? json(constant_s) : json(nullptr)},
          {"three_step_time_s", time_or_null(jobs::three_step_time_s(design))},
          {"continuous_time_s", time_or_null(jobs::continuous_time_s(design))},
          {"ratio_max", verification.boundary.ratio},
          {"burn_ratio_max", verification.burn.ratio},
          {"residual_um", um_per_mm * run.residual_mm},
          {"roundness_um", um_per_mm * run.out_of_roundness_mm()},
          {"force_max_n", run.force_max_n},
          {"spark_out_rev", design.spark_out_revolutions},
          {"boundary", boundary_json(request)},
          {"law", law_json(design.law)},
          {"samples", samples_json(request, run)}};
}

json refusal(const std::string& name, const process::Findings& findings) {
  return {{"program", name}, {"ok", false}, {"findings", findings_json(findings)}};
}

CommandResult designed(const StoredProgram& program, const std::string& name) {
  try {
    const auto cycle = jobs::designed_cycle(config::read_grinding_file(program.path), {});
    return cycle ? answer(name, *cycle) : refusal(name, cycle.error());
  } catch (const config::ConfigError& error) {
    return wrong_sheet(error.faults().front(), name);
  }
}

CommandResult verified(const StoredProgram& program, const std::string& name) {
  auto file = process::read_control_text(program.text, name);
  if (!file) return Unexpected<Failure>(failure_of_diagnostic(file.error().front()));
  DesignRequest request;
  request.allowance_mm = file->allowance_mm();
  request.process = file->process;
  return answer(name, jobs::assessed_cycle(request, file->law));
}

}  // namespace

void ProgramDesk::grinding(int session, const json& parameters, Answer answer) {
  checks_.cancel(session);
  checks_.submit(
      session,
      [folder = folder(),
       name = parameters["program"].get<std::string>()](const std::stop_token&) -> CommandResult {
        const auto program = folder.read(name);
        if (!program) return Unexpected<Failure>(program.error());
        const bool is_sheet = program->path.extension() == ".toml";
        return is_sheet ? designed(*program, name) : verified(*program, name);
      },
      std::move(answer));
}

}  // namespace stanok::daemon
