#include "client/offline/workpiece/workpiece_observer.h"

namespace stanok::client {
namespace {

FileNames names_of(const std::vector<channels::RunReport>& runs) {
  return [runs](const simulation::Origin& origin) {
    for (const channels::RunReport& run : runs) {
      if (run.channel != origin.channel || run.run != origin.run) continue;
      return origin.file < run.files.size() ? run.files[origin.file] : run.program;
    }
    return std::string();
  };
}

}  // namespace

void add_workpiece_options(CLI::App& command, WorkpieceOptions& options) {
  command
      .add_option("--workpiece-out", options.files.stl,
                  "STL of what is left of the blank of #workpiece")
      ->type_name("FILE");
  command
      .add_option("--picture", options.files.picture, "PNG of the workpiece, seen from four sides")
      ->type_name("FILE");
  command
      .add_option("--workpiece-report", options.files.report,
                  "JSON: findings, and volume and removal rate of every block")
      ->type_name("FILE");
  command.add_option("--workpiece-memory", options.memory_mib, "MiB that a workpiece may take")
      ->capture_default_str()
      ->check(CLI::Range(1, 1 << 20));
}

WorkpieceObserver::WorkpieceObserver(const channels::MachineConfig& machine,
                                     const WorkpieceOptions& options)
    : files_(options.files), cycle_s_(machine.cycle_us * 1e-6) {
  for (const channels::ChannelConfig& channel : machine.channels) {
    const auto on_complaint = [this, id = channel.id](const std::string& code,
                                                      const std::string& text) {
      complain(id, code, text);
      refused_ = refused_ || code.front() == 'E';
    };
    feeds_.push_back(std::make_unique<runtime::ChannelFeed>(
        machine, channel, options.memory_mib << 20U, on_complaint));
  }
}

void WorkpieceObserver::observe(const channels::CycleOutput& output) {
  const double time_s = static_cast<double>(output.cycle) * cycle_s_;
  for (std::size_t k = 0; k < feeds_.size(); ++k) {
    const channels::ChannelOutput& channel = output.channels[k];
    if (channel.axis_count == 0) continue;
    feeds_[k]->take(runtime::sample_of(channel, time_s), channel.tool_row, channel.workpiece);
  }
}

bool WorkpieceObserver::finish(const std::vector<channels::RunReport>& runs) {
  names_ = names_of(runs);
  for (const auto& feed : feeds_) {
    feed->follower().flush();
    for (const auto& workpiece : feed->follower().workpieces()) {
      workpieces_.push_back({workpiece.get(), title_of(*workpiece, names_, feed->channel())});
    }
  }
  if (workpieces_.empty() && !refused_)
    complain(0, "E9201", "no program has announced a workpiece with #workpiece");
  const std::vector<std::string> failures = write_files(workpieces_, files_, names_);
  for (const std::string& failure : failures) complain(0, "E9204", failure);
  return !workpieces_.empty() && !refused_ && failures.empty();
}

nlohmann::ordered_json WorkpieceObserver::json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const NamedWorkpiece& named : workpieces_) {
    json.push_back(to_json(*named.workpiece, names_));
    json.back()["program"] = named.title;
  }
  return json;
}

}  // namespace stanok::client
