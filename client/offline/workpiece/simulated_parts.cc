#include "client/offline/workpiece/simulated_parts.h"

#include "client/terminal/output.h"

namespace stanok::client {

FileNames names_of(const std::vector<channels::RunReport>& runs) {
  return [runs](const simulation::Origin& origin) {
    for (const channels::RunReport& run : runs) {
      if (run.channel != origin.channel || run.run != origin.run) continue;
      return origin.file < run.files.size() ? run.files[origin.file] : run.program;
    }
    return std::string();
  };
}

std::vector<NamedWorkpiece> finished_workpieces(const runtime::SimulatedWorkpieces& simulated,
                                                const FileNames& name_of) {
  std::vector<NamedWorkpiece> finished;
  for (const auto& feed : simulated.feeds()) {
    feed->follower().flush();
    for (const auto& workpiece : feed->follower().workpieces()) {
      finished.push_back({workpiece.get(), title_of(*workpiece, name_of, feed->channel()),
                          removal_of(*workpiece)});
    }
  }
  return finished;
}

namespace {

// As the rays have it: quick, and a little coarser than by the surface.
std::vector<NamedWorkpiece> workpieces_so_far(const runtime::SimulatedWorkpieces& simulated,
                                              const FileNames& name_of) {
  std::vector<NamedWorkpiece> all;
  for (const auto& feed : simulated.feeds()) {
    for (const auto& workpiece : feed->follower().workpieces()) {
      const simulation::CuttingReport& report = workpiece->report();
      all.push_back({workpiece.get(),
                     title_of(*workpiece, name_of, feed->channel()),
                     {.volume_mm3 = report.removed_mm3(), .blocks = report.blocks()}});
    }
  }
  return all;
}

}  // namespace

void add_workpiece_options(CLI::App& command, WorkpieceOptions& options) {
  command
      .add_option("--workpiece-out", options.files.stl,
                  "write what is left of the blank of #workpiece as STL")
      ->type_name("FILE");
  command
      .add_option("--picture", options.files.picture,
                  "write a PNG of the workpiece, seen from four sides")
      ->type_name("FILE");
  command
      .add_option("--workpiece-report", options.files.report,
                  "write a JSON report: findings, and volume and removal rate of every block")
      ->type_name("FILE");
  command
      .add_option("--workpiece-memory", options.memory_mib, "maximum memory of a workpiece, MiB")
      ->capture_default_str()
      ->check(CLI::Range(1, 1 << 20));
}

SimulatedParts::SimulatedParts(const config::MachineFile& file, const WorkpieceOptions& options)
    : files_(options.files),
      simulated_(std::make_shared<runtime::SimulatedWorkpieces>(
          file, options.memory_mib << 20U,
          [this](int channel, const std::string& code, const std::string& text) {
            complain(channel, code, text);
            refused_ = refused_ || code.front() == 'E';
          })) {}

bool SimulatedParts::finish(const std::vector<channels::RunReport>& runs, RunWas run) {
  names_ = names_of(runs);
  if (run == RunWas::interrupted) {
    workpieces_ = workpieces_so_far(*simulated_, names_);
    if (!files_.stl.empty() || !files_.picture.empty())
      write_message("interrupted: STL and picture are not written\n");
    files_.stl.clear();
    files_.picture.clear();
  } else {
    workpieces_ = finished_workpieces(*simulated_, names_);
  }
  if (workpieces_.empty() && !refused_ && files_.is_wanted())
    complain(0, "E9201", "no program has announced a workpiece with #workpiece");
  const std::vector<std::string> failures = write_files(workpieces_, files_, names_);
  for (const std::string& failure : failures) complain(0, "E9204", failure);
  if (!files_.is_wanted()) return !refused_;
  return !workpieces_.empty() && !refused_ && failures.empty();
}

nlohmann::ordered_json SimulatedParts::json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const NamedWorkpiece& named : workpieces_) {
    json.push_back(to_json(named, names_));
    json.back()["program"] = named.title;
  }
  return json;
}

}  // namespace stanok::client
