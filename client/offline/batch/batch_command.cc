#include "client/offline/batch/batch_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/offline/batch/batch_folder.h"
#include "client/offline/batch/batch_plan.h"
#include "client/offline/batch/batch_state.h"
#include "client/offline/batch/batch_wait.h"
#include "client/offline/batch/chunk_run.h"
#include "client/offline/batch/slurm.h"
#include "client/offline/simulate/part_pictures.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"

namespace stanok::client {
namespace {

struct BatchOptions {
  std::string work;
  std::vector<std::string> programs;
  BatchTask task = BatchTask::check;
  JobOptions job;
  double limit = 0.0;  // blocks or seconds; 0: none
  bool drives = false;
  std::string pictures;
  LibraryOptions library;
  std::size_t chunk = 0;  // 0: the usual one
  Engine engine;
  bool names_engine = false;
  std::size_t task_index = 0;
  bool waits = false;
};

BatchPlan plan_of_options(const BatchOptions& options) {
  BatchPlan plan{.task = options.task,
                 .job = options.job,
                 .drives = options.drives,
                 .pictures = options.pictures,
                 .library = options.library,
                 .directory = std::filesystem::current_path().string(),
                 .candidates = candidates_of(options.programs)};
  if (options.limit > 0.0 && options.task == BatchTask::simulate) plan.limit_s = options.limit;
  if (options.limit > 0.0 && options.task == BatchTask::check)
    plan.job.limit = static_cast<std::uint64_t>(options.limit);
  if (!plan.pictures.empty()) {
    if (plan.task == BatchTask::check)
      throw CLI::ValidationError("--pictures", "belongs to --task simulate");
    check_pictures(plan.candidates, plan.pictures);
  }
  plan.library.is_isolated = true;
  plan.chunk = options.chunk > 0 ? options.chunk : usual_chunk(plan.candidates.programs.size());
  plan.context = work_of(plan).context();
  return plan;
}

int do_here(const BatchFolder& folder, const BatchPlan& plan,
            const std::vector<std::size_t>& chunks) {
  catch_interrupts();
  const ChunkRun run(folder, plan);
  for (const std::size_t chunk : chunks) {
    if (folder.is_cancelled()) throw std::runtime_error("the batch was cancelled");
    const int code = run.run(chunk);
    if (code != 0) return code;
  }
  return 0;
}

void tell_submitted(const BatchOptions& options, const BatchState& state,
                    const std::vector<std::size_t>& chunks, const std::string& number) {
  if (options.job.json) {
    nlohmann::ordered_json json = state_json(state);
    json["submitted"] = chunks;
    if (!number.empty()) json["job"] = number;
    write_json(json);
    return;
  }
  if (!number.empty())
    write_data(fmt::format("{} chunks submitted as job {}\n", chunks.size(), number));
  write_data(state_text(state));
}

int submit(const BatchOptions& options) {
  BatchFolder folder(options.work);
  if (!options.programs.empty()) {
    if (options.job.machine_file.empty()) throw CLI::RequiredError("--machine");
    folder.lay_down(plan_of_options(options));
  }
  const BatchPlan plan = folder.plan();
  // Who submits again need not say again who works.
  const bool goes_on = options.programs.empty() && !options.names_engine;
  const Engine engine = goes_on ? folder.engine() : options.engine;
  folder.choose(engine);
  folder.allow();
  const auto chunks = chunks_to_do(state_of(folder, plan));
  for (const std::size_t chunk : chunks) folder.forget_fault(chunk);
  std::string number;
  if (engine.kind == EngineKind::slurm) {
    if (!chunks.empty()) number = submit_chunks(folder, plan, chunks);
  } else if (const int code = do_here(folder, plan, chunks); code != 0) {
    return code;
  }
  tell_submitted(options, state_of(folder, plan), chunks, number);
  return 0;
}

int status(const BatchOptions& options) {
  const BatchFolder folder(options.work);
  const BatchPlan plan = folder.plan();
  const BatchState state = options.waits ? wait_for(folder, plan) : state_of(folder, plan);
  if (is_interrupted()) return exit_interrupted;
  if (options.job.json) {
    write_json(state_json(state));
  } else {
    write_data(state_text(state));
  }
  const bool has_gone_wrong = !state.failed.empty() || !state.missing.empty();
  return has_gone_wrong ? exit_failed : 0;
}

std::vector<PieceResult> results_of(const BatchFolder& folder, const BatchPlan& plan,
                                    std::size_t chunk) {
  auto found = folder.results(chunk);
  if (found && found->size() == plan.programs_of(chunk).programs.size()) return std::move(*found);
  throw std::runtime_error(
      fmt::format("chunk {} of {} has no results; `stanok batch status {}` tells why", chunk,
                  plan.chunks(), folder.path().string()));
}

int results(const BatchOptions& options) {
  const BatchFolder folder(options.work);
  const BatchPlan plan = folder.plan();
  // Nothing is printed where something is missing, and the results of all need not be in memory.
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk)
    static_cast<void>(results_of(folder, plan, chunk));
  if (!plan.pictures.empty()) std::filesystem::current_path(plan.directory);
  const LibraryOutput output =
      output_of(plan, options.job.json ? BatchText::json : BatchText::table);
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk) {
    const auto found = results_of(folder, plan, chunk);
    const auto programs = plan.programs_of(chunk).programs;
    for (std::size_t k = 0; k < programs.size(); ++k)
      output.take(programs[k], found[k].bytes, found[k].death);
  }
  return output.finish();
}

int cancel(const BatchOptions& options) {
  const BatchFolder folder(options.work);
  const BatchPlan plan = folder.plan();
  folder.cancel();
  if (folder.engine().kind == EngineKind::slurm) cancel_tasks(folder.name());
  if (options.job.json) {
    write_json(state_json(state_of(folder, plan)));
  } else {
    write_data("cancelled; what is done stays. `stanok batch submit --work " + options.work +
               "` goes on with it\n");
  }
  return 0;
}

void add_engine_options(CLI::App& command, BatchOptions& options) {
  const std::map<std::string, EngineKind> engines{{"local", EngineKind::local},
                                                  {"slurm", EngineKind::slurm}};
  command
      .add_option("--engine", options.engine.kind,
                  "where to work: on this computer (local, until the work is done), or on a "
                  "cluster (slurm)")
      ->transform(CLI::CheckedTransformer(engines).description(""))
      ->type_name("local|slurm");
  command
      .add_option("--sbatch", options.engine.options,
                  "option passed on to sbatch (--sbatch=--partition=cam); may be repeated")
      ->type_name("OPTION");
  command
      .add_option("--chunk", options.chunk,
                  "programs per chunk, best about 30 s of work (default: 100, or as many as make a "
                  "thousand chunks)")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
}

void add_submit(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<BatchOptions>();
  CLI::App* command = noun.add_subcommand(
      "submit",
      "divide programs into chunks and process them; when repeated, only those that are not done");
  command
      ->add_option("PROGRAM", options->programs,
                   "part programs, or folders of them; none: the batch that is in the folder")
      ->type_name("FILE");
  command
      ->add_option("--work", options->work,
                   "folder of the batch, the same on every computer involved")
      ->type_name("FOLDER")
      ->required();
  const std::map<std::string, BatchTask> tasks{{"check", BatchTask::check},
                                               {"simulate", BatchTask::simulate}};
  command->add_option("--task", options->task, "what to do with each program (check)")
      ->transform(CLI::CheckedTransformer(tasks).description(""))
      ->type_name("check|simulate");
  add_job_options(*command, options->job);
  command->get_option("--machine")->required(false);
  add_steps_option(*command, options->job);
  command
      ->add_option(
          "--limit", options->limit,
          "end a program after this many blocks (check), or seconds of machine time (simulate)")
      ->check(CLI::PositiveNumber)
      ->type_name("BLOCKS|SECONDS");
  command->add_flag("--drives", options->drives,
                    "run the simulated drives; without this option, drives are ideal (simulate)");
  command
      ->add_option("--pictures", options->pictures,
                   "folder to which `batch results` writes a picture of what each program leaves "
                   "of its blank: NAME.nc.png (simulate)")
      ->type_name("FOLDER");
  add_library_options(*command, options->library);
  add_engine_options(*command, *options);
  command->callback([options, command, &exit_code] {
    options->names_engine = command->count("--engine") > 0;
    exit_code = submit(*options);
  });
}

}  // namespace

void add_batch_commands(CLI::App& app, int& exit_code) {
  CLI::App& noun =
      noun_command(app, "batch", "process libraries of programs on one computer or a cluster");
  add_submit(noun, exit_code);
  const auto add = [&](const char* verb, const char* help, int (*job)(const BatchOptions&)) {
    const auto options = std::make_shared<BatchOptions>();
    CLI::App* command = noun.add_subcommand(verb, help);
    command->add_option("FOLDER", options->work, "folder of the batch")
        ->type_name("FOLDER")
        ->required();
    command->add_flag("--json", options->job.json, "print JSON");
    command->callback([options, job, &exit_code] { exit_code = job(*options); });
    return std::pair(command, options);
  };
  const auto [state, of_state] =
      add("status", "show how many chunks are done, running, waiting and failed", &status);
  state->add_flag("--wait", of_state->waits,
                  "wait until all chunks have ended; lost chunks are submitted again");
  add("results", "print what `check` or `simulate` would print for the programs", &results);
  add("cancel", "start no more chunks, and end those that are running", &cancel);
  const auto options = std::make_shared<BatchOptions>();
  CLI::App* task =
      noun.add_subcommand("run", "process one chunk here, as a task of a cluster does");
  task->add_option("FOLDER", options->work, "folder of the batch")->type_name("FOLDER")->required();
  task->add_option("CHUNK", options->task_index, "number of the chunk, from 0")->required();
  task->callback([options, &exit_code] {
    exit_code = run_task(BatchFolder(options->work), options->task_index);
  });
}

}  // namespace stanok::client
