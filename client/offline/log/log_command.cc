#include "client/offline/log/log_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/offline/log/chosen_channels.h"
#include "client/offline/log/export_command.h"
#include "client/offline/log/log_text.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"
#include "client/terminal/text_table.h"
#include "jobs/logs/log_fields.h"
#include "jobs/logs/situation_fields.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/json_text.h"
#include "recording/plot/log_plot.h"
#include "recording/read/log_contents.h"
#include "recording/read/log_play.h"
#include "recording/read/situation_walk.h"
#include "recording/stream/lcm_publisher.h"
#include "runtime/replay.h"

namespace stanok::client {
namespace {

struct LogOptions {
  std::string file;
  std::string out;
  int channel = 0;  // 0: not given
  std::string lcm;
  double speed = 1.0;
  bool json = false;
};

int print_contents(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  if (options.json) {
    write_json(protocol::fields_json(jobs::log_fields(contents)));
  } else {
    write_data(text_of(contents, Terminal(STDOUT_FILENO)));
  }
  return contents.is_sound() && !contents.is_cut() ? 0 : exit_failed;
}

// One line of JSON, or one row, for each that comes into effect.
int print_situations(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  warn_when_damaged(contents, options.file);
  auto walk = value_or_throw(recording::SituationWalk::open(options.file, options.channel));
  if (options.json) {
    while (const auto situation = walk.next())
      write_json(protocol::fields_json(jobs::situation_fields(*situation, contents)));
    return 0;
  }
  TextTable table({"t [s]", "channel", "situation", "offset", "tool", "length [mm]", "codes"});
  while (const auto situation = walk.next()) table.add_row(situation_row(*situation, contents));
  write_data(table.text(Terminal(STDOUT_FILENO)));
  return 0;
}

int plot(const LogOptions& options) {
  const auto contents = value_or_throw(recording::read_contents(options.file));
  const auto channels = chosen_channels(contents, options.channel);
  warn_when_damaged(contents, options.file);
  for (const int channel : channels) {
    const auto pictures =
        value_or_throw(recording::plot_channel(options.file, contents, channel, options.out));
    for (const std::string& picture : pictures) write_data(picture + "\n");
  }
  return 0;
}

const char* verdict_of(const runtime::ReplayResult& result) {
  if (result.difference) return "differs";
  if (result.is_damaged) return "damaged";
  if (result.lost_cycle) return "records_lost";
  return result.is_cut ? "cut" : "same";
}

int exit_code_of_replay(const runtime::ReplayResult& result) {
  if (result.difference || result.is_damaged) return exit_failed;
  if (result.lost_cycle) return exit_log_with_losses;
  return result.is_cut ? exit_log_was_cut : 0;
}

nlohmann::json gaps_json(const runtime::ReplayResult& result) {
  nlohmann::json gaps = nlohmann::json::array();
  for (const runtime::SetpointGap& gap : result.gaps)
    gaps.push_back({{"first", gap.first}, {"last", gap.last}});
  return gaps;
}

nlohmann::json replay_json(const runtime::ReplayResult& result) {
  nlohmann::json json{{"ok", result.is_same()},           {"verdict", verdict_of(result)},
                      {"cycles", result.cycles},          {"setpoints", result.setpoints},
                      {"complete", result.is_complete()}, {"covered", result.has_checks},
                      {"gaps", gaps_json(result)},        {"remarks", result.remarks},
                      {"lost_from_cycle", nullptr},       {"difference", nullptr}};
  if (result.lost_cycle) json["lost_from_cycle"] = *result.lost_cycle;
  if (result.difference) {
    const runtime::SetpointDifference& first = *result.difference;
    json["difference"] = {{"cycle", first.cycle},       {"channel", first.channel},
                          {"field", first.field},       {"recorded", first.recorded},
                          {"repeated", first.repeated}, {"ulps", first.units_in_last_place}};
  }
  return json;
}

int verify(const LogOptions& options) {
  const bool shows_progress = isatty(STDERR_FILENO) != 0;
  const auto result = runtime::replay(options.file, [&](double part) {
    if (shows_progress) write_message_with_orders(fmt::format("\r\033[K{:3.0f} %", 100.0 * part));
  });
  if (shows_progress) write_message_with_orders("\r\033[K");
  for (const std::string& remark : result.remarks) write_message("warning: " + remark + "\n");
  if (options.json) {
    write_json(replay_json(result));
  } else if (result.difference) {
    const runtime::SetpointDifference& first = *result.difference;
    write_data(fmt::format(
        "differs in cycle {}, channel {}, {}: recorded {:.17g}, repeated {:.17g} ({} ULPs)\n",
        first.cycle, first.channel, first.field, first.recorded, first.repeated,
        first.units_in_last_place));
  } else {
    write_data(fmt::format("{} setpoints of {} cycles are the same, bit for bit\n",
                           result.setpoints, result.cycles));
  }
  return exit_code_of_replay(result);
}

int play(const LogOptions& options) {
  recording::LcmPublisher bus(options.lcm);
  if (!bus.good())
    throw std::runtime_error("LCM " + bus.status().url + " cannot be opened; see --lcm");
  catch_interrupts();
  const auto result = value_or_throw(
      recording::play(options.file, options.speed, bus, [] { return is_interrupted(); }));
  write_message(fmt::format("{} messages of {:.3f} s on {}\n", result.messages, result.recorded_s,
                            bus.status().url));
  for (const recording::Damage& damage : result.damage) {
    write_message(
        fmt::format("warning: {} at byte {}: {} bytes were left out\n",
                    damage.kind == recording::DamageKind::cut ? "the log is cut" : "damage",
                    damage.offset, damage.bytes));
  }
  if (is_interrupted()) return exit_interrupted;
  return result.damage.empty() ? 0 : exit_failed;
}

}  // namespace

void add_log_commands(CLI::App& app, int& exit_code) {
  CLI::App& noun = noun_command(app, "log", "log files and recorder");
  const auto add = [&](const char* verb, const char* help, int (*job)(const LogOptions&)) {
    const auto options = std::make_shared<LogOptions>();
    CLI::App* command = noun.add_subcommand(verb, help);
    command->add_option("FILE", options->file, "LCM log")->type_name("FILE")->required();
    command->callback([options, job, &exit_code] { exit_code = job(*options); });
    return std::pair(command, options);
  };
  const auto [info, info_options] =
      add("info", "show what a log file contains and what is damaged", &print_contents);
  info->add_flag("--json", info_options->json, "print JSON");

  const auto [situations, situation_options] =
      add("situations",
          "show what determines the meaning of program words (offset, tool, codes), and since when",
          &print_situations);
  situations->add_option("--channel", situation_options->channel, "channel; default: all")
      ->check(CLI::PositiveNumber);
  situations->add_flag("--json", situation_options->json, "print one line of JSON for each change");

  add_export_command(noun, exit_code);

  const auto [pictures, plot_options] =
      add("plot", "draw path, speed and axes of a log file (PNG and SVG, with gnuplot)", &plot);
  pictures->add_option("--out", plot_options->out, "folder for the pictures")
      ->type_name("FOLDER")
      ->required();
  pictures->add_option("--channel", plot_options->channel, "channel of the machine; default: all")
      ->check(CLI::PositiveNumber);

  const auto [again, verify_options] = add(
      "verify", "repeat the run of a log from its inputs and compare every setpoint bit for bit",
      &verify);
  again->add_flag("--json", verify_options->json, "print JSON");

  const auto [bus, play_options] = add("play", "publish a log on the LCM bus again", &play);
  bus->add_option("--speed", play_options->speed, "1: as recorded; 0: as fast as possible")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  bus->add_option("--lcm", play_options->lcm,
                  "LCM URL; default: LCM_DEFAULT_URL, or the local multicast group")
      ->type_name("URL");
}

}  // namespace stanok::client
