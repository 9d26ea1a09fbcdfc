#include "client/command_line/offline.h"

#include "client/command_line/explain_command.h"
#include "client/command_line/self_commands.h"
#include "client/offline/batch/batch_command.h"
#include "client/offline/check/check_command.h"
#include "client/offline/grind/grind_command.h"
#include "client/offline/history/history_command.h"
#include "client/offline/interpret/interpret_command.h"
#include "client/offline/library/cache_command.h"
#include "client/offline/log/log_command.h"
#include "client/offline/machine/machine_check_command.h"
#include "client/offline/process/process_command.h"
#include "client/offline/simulate/simulate_command.h"
#include "client/offline/tools/tool_library_commands.h"
#include "client/offline/workpiece/workpiece_follow_command.h"

namespace stanok::client {
namespace {

// An option that may be repeated takes one value each time, else it would swallow the program
// behind it.
void take_one_value_each_time(CLI::App& command) {
  for (CLI::Option* option : command.get_options())
    if (!option->get_positional()) option->allow_extra_args(false);
  for (CLI::App* subcommand : command.get_subcommands(nullptr))
    take_one_value_each_time(*subcommand);
}

}  // namespace

void add_offline_commands(CLI::App& app, int& exit_code) {
  add_check_command(app, exit_code);
  add_machine_check_command(app, exit_code);
  add_interpret_command(app, exit_code);
  add_simulate_command(app, exit_code);
  add_batch_commands(app, exit_code);
  add_cache_commands(app, exit_code);
  add_log_commands(app, exit_code);
  add_workpiece_follow_command(app, exit_code);
  add_grind_commands(app, exit_code);
  add_process_commands(app, exit_code);
  add_history_commands(app, exit_code);
  add_tool_library_commands(app, exit_code);
  add_explain_command(app, exit_code);
  add_completion_command(app);
  add_manual_command(app);
  take_one_value_each_time(app);
}

}  // namespace stanok::client
