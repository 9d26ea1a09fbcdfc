#include "client/offline/log/export_command.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>

#include "base/system_error.h"
#include "client/offline/log/chosen_channels.h"
#include "client/terminal/output.h"
#include "jobs/log_tables/log_tables.h"
#include "jobs/log_tables/process_rows.h"
#include "recording/read/log_export.h"

namespace stanok::client {
namespace {

struct ExportOptions {
  std::string file;
  std::string csv;
  std::string npz;
  int channel = 0;  // 0: not given
  bool process = false;
};

int only_channel(const recording::LogContents& contents, int channel) {
  const auto channels = chosen_channels(contents, channel);
  if (channels.size() > 1) {
    throw std::runtime_error("the log has setpoints of channels " + channel_list(contents) +
                             "; choose one with --channel");
  }
  return channels.front();
}

// Opening it would empty the log before it is read.
void expect_other_file(const std::string& table, const std::string& log) {
  std::error_code is_missing;
  if (std::filesystem::equivalent(table, log, is_missing))
    throw std::runtime_error(table + " is the log itself; write to another file");
}

std::int64_t export_csv(const ExportOptions& options, const recording::LogContents& contents,
                        int channel) {
  expect_other_file(options.csv, options.file);
  const bool to_stdout = options.csv == "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> csv(
      to_stdout ? stdout : std::fopen(options.csv.c_str(), "w"),
      to_stdout ? &std::fflush : &std::fclose);
  if (csv == nullptr)
    throw std::runtime_error("cannot write " + options.csv + ": " + system_error_text(errno));
  return value_or_throw(
      options.process ? jobs::write_process_csv(options.file, channel, csv.get())
                      : recording::export_setpoints(options.file, contents, channel, csv.get()));
}

std::int64_t export_npz(const ExportOptions& options, const recording::LogContents& contents,
                        int channel) {
  if (options.npz == "-") {
    throw std::runtime_error(
        "an .npz file is written at several places; give --npz a file, not the standard output");
  }
  expect_other_file(options.npz, options.file);
  return value_or_throw(
      options.process ? jobs::write_process_npz(options.file, channel, options.npz)
                      : jobs::write_setpoints_npz(options.file, contents, channel, options.npz));
}

int export_log(const ExportOptions& options) {
  if (options.csv.empty() && options.npz.empty()) throw CLI::RequiredError("--csv or --npz");
  const auto contents = value_or_throw(recording::read_contents(options.file));
  const int channel = only_channel(contents, options.channel);
  if (options.process && !jobs::has_process_rows(contents, channel)) {
    throw std::runtime_error(fmt::format(
        "the log has no process data of channel {}; stanok log info lists what it contains",
        channel));
  }
  warn_when_damaged(contents, options.file);
  std::int64_t rows = 0;
  if (!options.csv.empty()) rows = export_csv(options, contents, channel);
  if (!options.npz.empty()) rows = export_npz(options, contents, channel);
  write_message(fmt::format("{} rows\n", rows));
  return 0;
}

}  // namespace

void add_export_command(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      noun.add_subcommand("export", "write the setpoints or the process data of a log as a table");
  command->add_option("FILE", options->file, "LCM log")->type_name("FILE")->required();
  command->add_option("--csv", options->csv, "CSV file to write; -: standard output")
      ->type_name("FILE");
  command
      ->add_option("--npz", options->npz,
                   "file to write for numpy.load: an array for each column, a matrix for those of "
                   "the axes; needs little memory, however long the log is")
      ->type_name("FILE");
  command->add_flag("--process", options->process,
                    "write feed law, feed, spindle, power, force and vibration instead of "
                    "setpoints, every 50 ms");
  command->add_option("--channel", options->channel, "channel of the machine")
      ->check(CLI::PositiveNumber);
  command->callback([options, &exit_code] { exit_code = export_log(*options); });
}

}  // namespace stanok::client
