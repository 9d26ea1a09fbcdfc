#include "client/offline/interpret/interpret_command.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "client/offline/machine/job_options.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "jobs/interpret/record_fields.h"
#include "protocol/contract/fields_json.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

constexpr std::size_t write_threshold = 1 << 16;  // bytes gathered before they are written
constexpr int exit_program_error = 6;

struct InterpretOptions {
  JobOptions job;
  std::string program;
  bool quiet = false;
  std::uint32_t from_line = 0;
  int from_block = -1;
  int passes = 1;
  bool without_calculation = false;

  [[nodiscard]] bool searches() const { return from_line > 0 || from_block >= 0; }
};

double processor_time_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

jobs::Beginning beginning_of(const InterpretOptions& options) {
  jobs::Beginning beginning;
  if (options.from_line > 0) {
    beginning.target.line = options.from_line;
  } else {
    beginning.target.block_number = options.from_block;
  }
  beginning.target.passes = options.passes;
  if (options.without_calculation) beginning.calculation = jobs::Calculation::without;
  return beginning;
}

int run(const InterpretOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto machine = machine_file_of(options.job);
  const LocatedProgram program = locate(options.program);
  const runtime::ProgramFiles files(search_roots({program}, options.job),
                                    runtime::program_format(machine.machine));
  jobs::DryRun dry_run(machine.machine, options.job.channel, scheme_of(options.job), files);
  std::string text;
  const auto write_out = [&] {
    write_data(text);
    text.clear();
  };
  const auto print_record = [&](const lang::Command& command, const motion::PathBlock* block) {
    protocol::append_json_line(text, jobs::record_fields(command, block, dry_run.channel().words));
    if (text.size() > write_threshold) write_out();
  };
  const auto nothing = [](const lang::Command&, const motion::PathBlock*) {};
  const jobs::RecordSink record =
      options.quiet ? jobs::RecordSink(nothing) : jobs::RecordSink(print_record);
  const auto result =
      options.searches()
          ? dry_run.run_from(program.name, beginning_of(options), record,
                             [&](const lang::SearchState& state, const lang::Origin& target) {
                               protocol::append_json_line(
                                   text,
                                   jobs::search_fields(state, target, dry_run.channel().words));
                             })
          : dry_run.run(program.name, jobs::Reachability::unchecked, record,
                        [](const lang::ProgramRequest&, const lang::Command&) {});
  write_out();
  for (const Diagnostic& diagnostic : result.diagnostics) print(diagnostic);
  if (options.quiet) {
    const double cpu_s = processor_time_s();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    write_data(fmt::format(
        R"({{"kind":"summary","blocks":{},"cpu_s":{:.6f},"wall_s":{:.6f},"blocks_per_s":{:.0f}}})"
        "\n",
        result.blocks, cpu_s, wall.count(), static_cast<double>(result.blocks) / cpu_s));
  }
  return has_errors(result.diagnostics) ? exit_program_error : 0;
}

}  // namespace

void add_interpret_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InterpretOptions>();
  CLI::App* command =
      app.add_subcommand("interpret", "print the records of a program after block preparation");
  command->add_option("PROGRAM", options->program, "part program")->type_name("FILE")->required();
  add_job_options(*command, options->job);
  add_steps_option(*command, options->job);
  auto* const line =
      command->add_option("--from-line", options->from_line, "begin at this line (block search)");
  command->add_option("--from-block", options->from_block, "begin at block N (block search)")
      ->excludes(line);
  command
      ->add_option("--pass", options->passes,
                   "begin at this pass of the loop that contains the block; default 1")
      ->check(CLI::PositiveNumber);
  command->add_flag("--without-calculation", options->without_calculation,
                    "skip the preceding blocks instead of interpreting them");
  command->add_flag("--quiet", options->quiet, "print the summary only");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
