#include "client/interpret_command.h"

#include <chrono>
#include <cstdio>
#include <ctime>

#include "client/diagnostic_output.h"
#include "client/job_options.h"
#include "client/record_text.h"
#include "config/machine_file.h"
#include "runtime/dry_run.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

constexpr std::size_t write_threshold = 1 << 16;  // bytes gathered before they are written
constexpr int exit_program_error = 6;

struct InterpretOptions {
  JobOptions job;
  std::string program;
  bool quiet = false;
};

double processor_time_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

int scheme_of(const JobOptions& options) {
  for (const auto& [channel, scheme] : scheme_choices(options)) {
    if (channel == options.channel) return scheme;
  }
  return -1;
}

int run(const InterpretOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto machine = config::read_machine_file(options.job.machine_file);
  const LocatedProgram program = locate(options.program);
  const runtime::ProgramFiles files(search_roots({program}, options.job));
  runtime::DryRun dry_run(machine.machine, options.job.channel, scheme_of(options.job), files);
  std::string text;
  const auto write_out = [&] {
    std::fwrite(text.data(), 1, text.size(), stdout);
    text.clear();
  };
  const auto print_record = [&](const lang::Command& command, const motion::PathBlock* block) {
    append_record(text, command, block, dry_run.channel().words);
    if (text.size() > write_threshold) write_out();
  };
  const auto nothing = [](const lang::Command&, const motion::PathBlock*) {};
  const auto result = dry_run.run(program.name, runtime::Reachability::unchecked,
                                  options.quiet ? runtime::RecordSink(nothing) : print_record,
                                  [](const lang::Request&, const lang::Command&) {});
  write_out();
  for (const Diagnostic& diagnostic : result.diagnostics) print(diagnostic);
  if (options.quiet) {
    const double cpu_s = processor_time_s();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    std::printf(R"({"kind":"summary","blocks":%lu,"cpu_s":%.6f,"wall_s":%.6f,"blocks_per_s":%.0f})",
                static_cast<unsigned long>(result.blocks), cpu_s, wall.count(),
                static_cast<double>(result.blocks) / cpu_s);
    std::printf("\n");
  }
  return has_errors(result.diagnostics) ? exit_program_error : 0;
}

}  // namespace

void add_interpret_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InterpretOptions>();
  CLI::App* command =
      app.add_subcommand("interpret", "print a program's records after block preparation");
  command->add_option("PROGRAM", options->program, "part program")->required();
  add_job_options(*command, options->job);
  command->add_flag("--quiet", options->quiet, "print the summary only");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace stanok::client
