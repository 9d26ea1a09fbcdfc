#include "client/offline/batch/batch_plan.h"

#include <algorithm>

#include "client/offline/check/check_library.h"
#include "client/offline/library/record.h"
#include "client/offline/simulate/simulate_library.h"

namespace stanok::client {
namespace {

using nlohmann::json;

constexpr int plan_format = 2;
constexpr std::size_t chunk_least = 100;
constexpr std::size_t chunks_most = 1000;

json job_record(const JobOptions& job) {
  return {{"machine", job.machine_file}, {"channel", job.channel}, {"schemes", job.schemes},
          {"root", job.program_root},    {"steps", job.steps},     {"limit", job.limit}};
}

JobOptions job_of(const json& record) {
  JobOptions job;
  job.machine_file = record.at("machine");
  job.channel = record.at("channel");
  job.schemes = record.at("schemes").get<std::vector<std::string>>();
  job.program_root = record.at("root");
  job.steps = record.at("steps");
  job.limit = record.at("limit");
  return job;
}

json programs_record(const Candidates& candidates) {
  json programs = json::array();
  for (const Candidate& program : candidates.programs)
    programs.push_back(json::array({program.path, program.folder.string()}));
  return programs;
}

Candidates candidates_in(const json& record) {
  Candidates candidates;
  candidates.named =
      record.at("folders").get<bool>() ? ProgramsNamed::by_folders : ProgramsNamed::by_files;
  for (const json& program : record.at("programs"))
    candidates.programs.push_back({program.at(0), program.at(1).get<std::string>()});
  return candidates;
}

LibrarySimulation simulation_of(const BatchPlan& plan) {
  return {
      .job = plan.job, .limit_s = plan.limit_s, .drives = plan.drives, .pictures = plan.pictures};
}

}  // namespace

std::size_t BatchPlan::chunks() const {
  return (candidates.programs.size() + chunk - 1) / chunk;
}

Candidates BatchPlan::programs_of(std::size_t chunk_index) const {
  const auto& all = candidates.programs;
  const std::size_t first = std::min(chunk_index * chunk, all.size());
  const std::size_t end = std::min(first + chunk, all.size());
  const auto begin = all.begin();
  return {.programs = {begin + static_cast<std::ptrdiff_t>(first),
                       begin + static_cast<std::ptrdiff_t>(end)},
          .named = candidates.named};
}

std::size_t usual_chunk(std::size_t programs) {
  return std::max(chunk_least, (programs + chunks_most - 1) / chunks_most);
}

std::string plan_record(const BatchPlan& plan) {
  return bytes_of({{"format", plan_format},
                   {"task", static_cast<int>(plan.task)},
                   {"job", job_record(plan.job)},
                   {"limit_s", plan.limit_s},
                   {"drives", plan.drives},
                   {"pictures", plan.pictures},
                   {"jobs", plan.library.jobs},
                   {"cache", plan.library.cache},
                   {"directory", plan.directory},
                   {"context", plan.context},
                   {"chunk", plan.chunk},
                   {"folders", plan.candidates.named == ProgramsNamed::by_folders},
                   {"programs", programs_record(plan.candidates)}});
}

std::optional<BatchPlan> plan_of(std::string_view bytes) {
  const auto found = record_in(bytes);
  if (!found) return std::nullopt;
  const json& record = *found;
  try {
    if (record.at("format") != plan_format) return std::nullopt;
    BatchPlan plan;
    plan.task = static_cast<BatchTask>(record.at("task").get<int>());
    plan.job = job_of(record.at("job"));
    plan.limit_s = record.at("limit_s");
    plan.drives = record.at("drives");
    plan.pictures = record.at("pictures");
    plan.library = {.jobs = record.at("jobs"), .cache = record.at("cache"), .is_isolated = true};
    plan.directory = record.at("directory");
    plan.context = record.at("context");
    plan.chunk = std::max(record.at("chunk").get<std::size_t>(), std::size_t{1});
    plan.candidates = candidates_in(record);
    return plan;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

LibraryWork work_of(const BatchPlan& plan) {
  if (plan.task == BatchTask::simulate) return simulation_work(simulation_of(plan));
  return check_work({.job = plan.job});
}

LibraryOutput output_of(const BatchPlan& plan, BatchText text) {
  BatchPlan shown = plan;
  shown.job.json = text == BatchText::json;
  if (plan.task == BatchTask::simulate) return simulation_output(simulation_of(shown));
  return check_output({.job = shown.job}, plan.candidates.named);
}

}  // namespace stanok::client
