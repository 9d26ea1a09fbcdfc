#include "client/offline/check/check_command.h"

#include <memory>

#include "client/offline/check/check_library.h"
#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"

namespace stanok::client {
namespace {

struct CheckOptions {
  CheckWanted wanted;
  std::vector<std::string> programs;
  LibraryOptions library;
};

int run_check(const CheckOptions& options) {
  const Candidates candidates = candidates_of(options.programs);
  return run_library(candidates, options.library, check_work(options.wanted),
                     check_output(options.wanted, candidates.named));
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "find errors in programs without running them");
  command->add_option("PROGRAM", options->programs, "part programs, or folders of them")
      ->type_name("FILE")
      ->required();
  command->add_flag("--estimate", options->wanted.estimate,
                    "also print time and figures of each block under a feed law; with --json, "
                    "print an object that includes the tilted planes");
  add_job_options(*command, options->wanted.job);
  add_steps_option(*command, options->wanted.job);
  command
      ->add_option("--limit", options->wanted.job.limit,
                   "check at most this many blocks of a program (W820)")
      ->check(CLI::PositiveNumber)
      ->type_name("BLOCKS");
  add_library_options(*command, options->library);
  command->callback([options, &exit_code] { exit_code = run_check(*options); });
}

}  // namespace stanok::client
