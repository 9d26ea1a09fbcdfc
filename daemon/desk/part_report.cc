// A program run on a virtual clock, and what it leaves of its blank.

#include "daemon/desk/part_report.h"

#include <algorithm>

#include "daemon/desk/process/process_answers.h"
#include "daemon/report/status_report.h"
#include "protocol/contract/base64.h"
#include "simulation/offcuts.h"
#include "simulation/picture/part_picture.h"
#include "simulation/removed_volume.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
using simulation::Workpiece;

constexpr int picture_width = 640;  // pixels
constexpr int picture_height = 480;

// The one that was cut last.
Workpiece* newest_workpiece(const runtime::SimulatedWorkpieces& simulated) {
  Workpiece* newest = nullptr;
  for (const auto& feed : simulated.feeds()) {
    feed->follower().flush();
    if (Workpiece* const cut = feed->follower().at_work()) newest = cut;
  }
  return newest;
}

void add_part(json& answer, const Workpiece& workpiece) {
  simulation::Mesh mesh = simulation::surface_of(workpiece.material());
  simulation::take_off_offcuts(mesh);
  answer["picture"] = protocol::base64(simulation::view_of_part(
      mesh, workpiece.blank(), workpiece.material().grid(), picture_width, picture_height));
  answer["removed_mm3"] = simulation::removal_of(workpiece).volume_mm3;
  answer["blank_mm3"] = simulation::volume_of(workpiece.blank());
  answer["findings"] = workpiece.report().findings().size();
}

CommandResult picture_of(const runtime::SimulationOptions& asked, const std::stop_token& stop) {
  const std::string& program = asked.programs.front().program;
  std::string refusal;
  runtime::SimulationOptions options = asked;
  options.workpieces = std::make_shared<runtime::SimulatedWorkpieces>(
      asked.file, workpiece_bytes_max, [&](int, const std::string& code, const std::string& text) {
        if (refusal.empty() && code.front() == 'E') refusal = code + ": " + text;
      });
  for (const auto& feed : options.workpieces->feeds()) feed->take_what_fits();
  const auto gives_up = gives_up_when(stop);
  const auto result = runtime::simulate(options, {}, gives_up);
  const auto error = std::ranges::find_if(result.load_diagnostics, [](const auto& told) {
    return told.diagnostic.severity == Severity::error;
  });
  if (error != result.load_diagnostics.end())
    return Unexpected<Failure>(failure_of_diagnostic(error->diagnostic));
  if (!result.refusals.empty()) {
    return Unexpected<Failure>(
        Failure{FailureKind::refused, "", program + ": " + result.refusals.front(), 0, {}});
  }
  if (!refusal.empty()) return nothing_told(refusal);
  json answer{{"program", program},
              {"ok", result.ok},
              {"complete", !gives_up() && !result.until_reached},
              {"time_s", result.machine_time_s},
              {"picture", nullptr},
              {"removed_mm3", nullptr},
              {"blank_mm3", nullptr},
              {"findings", nullptr},
              {"alarm", result.alarms.empty() ? json(nullptr) : alarm_json(result.alarms.front())}};
  if (const Workpiece* const cut = newest_workpiece(*options.workpieces)) add_part(answer, *cut);
  return answer;
}

}  // namespace

BackgroundWork::Work part_after(runtime::SimulationOptions options) {
  return [options = std::move(options)](const std::stop_token& stop) {
    return picture_of(options, stop);
  };
}

}  // namespace stanok::daemon
