#include "client/log_command.h"

#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "client/log_text.h"
#include "client/noun_command.h"
#include "recording/log_contents.h"
#include "recording/log_export.h"
#include "recording/log_plot.h"

namespace stanok::client {
namespace {

constexpr int exit_failed = 1;

struct LogOptions {
  std::string file;
  std::string out;
  int channel = 0;  // 0: not given
  bool json = false;
};

template <class Value>
Value value_or_throw(Expected<Value, recording::LogError> result) {
  if (!result) throw std::runtime_error(result.error().text);
  return std::move(*result);
}

std::string channel_list(const recording::LogContents& contents) {
  std::string list;
  for (const auto& [channel, name] : contents.setpoint_channels) {
    list += (list.empty() ? "" : ", ") + std::to_string(channel);
  }
  return list.empty() ? "none" : list;
}

// The channels to work on: the one that was asked for, or all with set-points.
std::vector<int> chosen_channels(const recording::LogContents& contents, int channel) {
  std::vector<int> channels;
  for (const auto& [number, name] : contents.setpoint_channels) {
    if (channel == 0 || number == channel) channels.push_back(number);
  }
  if (channels.empty()) {
    throw std::runtime_error("no set-points of " +
                             (channel == 0 ? "any channel" : "channel " + std::to_string(channel)) +
                             "; channels with set-points: " + channel_list(contents));
  }
  return channels;
}

void warn_when_damaged(const recording::LogContents& contents, const std::string& file) {
  if (contents.is_sound()) return;
  std::fprintf(stderr, "warning: %s is damaged; what can be read is used (stanok log info %s)\n",
               file.c_str(), file.c_str());
}

int print_contents(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  const std::string text =
      options.json ? to_json(contents).dump() + "\n" : text_of(contents, Terminal(STDOUT_FILENO));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return contents.is_sound() ? 0 : exit_failed;
}

int export_csv(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  const auto channels = chosen_channels(contents, options.channel);
  if (channels.size() > 1) {
    throw std::runtime_error("the log has set-points of channels " + channel_list(contents) +
                             "; choose one with --channel");
  }
  warn_when_damaged(contents, options.file);
  const bool to_stdout = options.out == "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> csv(
      to_stdout ? stdout : std::fopen(options.out.c_str(), "w"),
      to_stdout ? &std::fflush : &std::fclose);
  if (csv == nullptr) throw std::runtime_error("cannot write " + options.out);
  const auto rows = value_or_throw(
      recording::export_setpoints(options.file, contents, channels.front(), csv.get()));
  std::fprintf(stderr, "%lld rows\n", static_cast<long long>(rows));
  return 0;
}

int plot(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  const auto channels = chosen_channels(contents, options.channel);
  warn_when_damaged(contents, options.file);
  for (const int channel : channels) {
    const auto pictures =
        value_or_throw(recording::plot_channel(options.file, contents, channel, options.out));
    for (const std::string& picture : pictures) std::printf("%s\n", picture.c_str());
  }
  return 0;
}

// Known, not made yet: answered instead of a message about a wrong command line.
void add_later_command(CLI::App& noun, const std::string& verb, int& exit_code) {
  CLI::App* command = noun.add_subcommand(verb)->group("")->allow_extras();
  command->callback([verb, &exit_code] {
    std::fprintf(stderr, "stanok: log %s: not supported in this release\n", verb.c_str());
    exit_code = exit_failed;
  });
}

}  // namespace

void add_log_commands(CLI::App& app, int& exit_code) {
  CLI::App& noun = noun_command(app, "log", "log files and recorder");
  const auto add = [&](const char* verb, const char* help, int (*job)(const LogOptions&)) {
    const auto options = std::make_shared<LogOptions>();
    CLI::App* command = noun.add_subcommand(verb, help);
    command->add_option("FILE", options->file, "LCM log")->required();
    command->callback([options, job, &exit_code] { exit_code = job(*options); });
    return std::pair(command, options);
  };
  const auto [info, info_options] =
      add("info", "what a log file holds, and its damage", &print_contents);
  info->add_flag("--json", info_options->json, "print JSON");

  const auto [csv, csv_options] = add("export", "set-points of a log file as CSV", &export_csv);
  csv->add_option("--csv", csv_options->out, "file to write; - is the standard output")->required();
  csv->add_option("--channel", csv_options->channel, "channel of the machine")
      ->check(CLI::PositiveNumber);

  const auto [pictures, plot_options] =
      add("plot", "pictures of a log file: path, speed, axes (PNG and SVG, by gnuplot)", &plot);
  pictures->add_option("--out", plot_options->out, "directory for the pictures")->required();
  pictures->add_option("--channel", plot_options->channel, "channel of the machine; else all")
      ->check(CLI::PositiveNumber);

  add_later_command(noun, "play", exit_code);
  add_later_command(noun, "verify", exit_code);
}

}  // namespace stanok::client
