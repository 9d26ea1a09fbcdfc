#include "client/offline/process/identify/identify_command.h"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "client/offline/process/forecast_job.h"
#include "client/offline/process/identify/identify_report.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "client/terminal/result_files.h"
#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "protocol/contract/fields_json.h"

namespace stanok::client {
namespace {

using jobs::GrindLogRequest;

constexpr double usual_efficiency_of_wheel = 0.85;

struct IdentifyOptions {
  std::string log;
  std::vector<std::string> stock;
  int channel = 1;
  int spindle = 1;
  double coefficient_n = 0.0;
  std::string out;
  std::string picture;
  bool json = false;
  std::string grinding;  // process file; empty: a turning cut
  double touch_mm = std::numeric_limits<double>::quiet_NaN();
  double force_ratio = 0.4;
  double wheel_speed_m_per_s = 35.0;
  std::optional<double> efficiency;  // of the drive
  std::string cut;                   // tool and material of a milling cut
  int tool = 0;
};

// Z:RADIUS:HARDNESS, or the file that has them.
jobs::StockTable stock_of(const IdentifyOptions& options) {
  const bool is_file =
      options.stock.size() == 1 && options.stock.front().find(':') == std::string::npos;
  if (is_file) return jobs::read_stock_table(options.stock.front());
  std::string text;
  for (const std::string& step : options.stock) text += (text.empty() ? "" : ",") + step;
  const auto stock = jobs::stock_of_text(text);
  if (!stock) {
    throw CLI::ValidationError(
        "--stock", "`" + text +
                       "` is neither a file nor Z:RADIUS or Z:RADIUS:HARDNESS in mm and HB with "
                       "falling Z, as 0:32:200,-20:33:240");
  }
  return *stock;
}

// What was found: into the file that was asked for, as a picture, and on standard output. A fit
// that is refused has no file.
int tell(const IdentifyOptions& options, const jobs::Identification& found) {
  const bool is_refused = found.verdict.is_refused();
  if (!options.out.empty() && !is_refused) write_text_file(options.out, found.text);
  if (!options.picture.empty()) draw_picture(found, options.picture);
  if (options.json) {
    write_json(protocol::fields_json(jobs::identification_fields(found)));
  } else {
    write_data(to_text(found));
  }
  return is_refused ? exit_failed : 0;
}

int run_grinding(const IdentifyOptions& options) {
  const process::DesignRequest sheet = config::read_grinding_file(options.grinding);
  GrindLogRequest reading{
      .channel = options.channel,
      .spindle = options.spindle - 1,
      .allowance_mm = sheet.allowance_mm,
      .watts_per_newton = options.force_ratio * options.wheel_speed_m_per_s /
                          options.efficiency.value_or(usual_efficiency_of_wheel)};
  if (std::isfinite(options.touch_mm)) reading.touch_mm = options.touch_mm;
  return tell(options,
              jobs::identify(jobs::LoggedPlunge{.log = options.log,
                                                .reading = reading,
                                                .sheet = sheet.process,
                                                .process_text = text_of_file(options.grinding)}));
}

int run_milling(const IdentifyOptions& options) {
  const process::CuttingProcess cut = config::read_chatter_file(options.cut);
  if (cut.kind != process::CutKind::milling)
    throw std::runtime_error(options.cut +
                             " does not describe a milling cut; write kind = \"milling\"");
  return tell(options,
              jobs::identify(jobs::LoggedMilling{.log = options.log,
                                                 .reading = {.channel = options.channel,
                                                             .spindle = options.spindle - 1,
                                                             .cut = cut,
                                                             .tool = options.tool},
                                                 .cut_text = text_of_file(options.cut),
                                                 .efficiency = options.efficiency.value_or(1.0)}));
}

int run_identify(const IdentifyOptions& options) {
  if (!options.grinding.empty()) return run_grinding(options);
  if (!options.cut.empty()) return run_milling(options);
  if (options.stock.empty()) {
    throw CLI::RequiredError(
        "--stock of a turning cut, --cut of a milling cut, or --grinding of a plunge cycle");
  }
  return tell(options,
              jobs::identify(jobs::LoggedTurning{.log = options.log,
                                                 .reading = {.channel = options.channel,
                                                             .spindle = options.spindle - 1,
                                                             .stock = stock_of(options)},
                                                 .coefficient_n = options.coefficient_n}));
}

}  // namespace

void add_identify_command(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<IdentifyOptions>();
  CLI::App* command =
      noun.add_subcommand("identify",
                          "find idle power, sensor lag and cutting force of the material from the "
                          "log of a turning, milling or grinding cut (grinding: also the "
                          "stiffness); exit code 1: the model does not fit the log");
  command->add_option("LOG", options->log, "log of a cut")->required()->type_name("FILE");
  CLI::Option* const stock = command->add_option(
      "--stock", options->stock,
      "turning: the bar before the cut, in the frame of the program: its radius, mm, and hardness, "
      "HB, from each Z on; or a CSV file with z,radius,hardness, or a machine file with its stock");
  stock->type_name("Z:RADIUS[:HARDNESS]|FILE")->delimiter(',');
  command->add_option("--channel", options->channel, "channel of the cut")
      ->check(CLI::Range(1, 16));
  command->add_option("--spindle", options->spindle, "number of the spindle in the machine, from 1")
      ->check(CLI::Range(1, 16));
  command
      ->add_option("--coefficient", options->coefficient_n,
                   "C of the material, N at 1 mm depth and 1 mm per turn; if given, the efficiency "
                   "is found too")
      ->check(CLI::PositiveNumber);
  CLI::Option* const grinding =
      command
          ->add_option("--grinding", options->grinding,
                       "a plunge cycle of this process file; --spindle is that of the wheel")
          ->type_name("FILE")
          ->excludes(stock);
  command
      ->add_option(
          "--touch", options->touch_mm,
          "X of the program at which the wheel touches the part, mm; default: the allowance")
      ->needs(grinding);
  command
      ->add_option("--force-ratio", options->force_ratio,
                   "ratio of the tangential to the normal force of the wheel; default 0.4")
      ->check(CLI::Range(0.05, 2.0))
      ->needs(grinding);
  command
      ->add_option("--wheel-speed", options->wheel_speed_m_per_s,
                   "surface speed of the wheel, m/s; default 35")
      ->check(CLI::Range(1.0, 200.0))
      ->needs(grinding);
  CLI::Option* const cut =
      command
          ->add_option("--cut", options->cut,
                       "milling: tool and material (TOML, as of `process lobes`); the log has the "
                       "workpiece")
          ->type_name("FILE")
          ->excludes(stock)
          ->excludes(grinding);
  command
      ->add_option("--tool", options->tool,
                   "milling: number of the tool whose cuts are evaluated; default: all")
      ->check(CLI::PositiveNumber)
      ->needs(cut);
  command
      ->add_option("--efficiency", options->efficiency,
                   "efficiency of the drive; grinding: of the wheel drive, default 0.85; milling: "
                   "converts forces at the drive to forces at the cut, default 1")
      ->check(CLI::Range(0.1, 1.0))
      ->excludes(stock);
  command
      ->add_option("--out", options->out,
                   "file to write: the [process] section; with --cut or --grinding, that file with "
                   "the new values")
      ->type_name("FILE");
  command->add_option("--picture", options->picture, "draw power and residual, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = run_identify(*options); });
}

}  // namespace stanok::client
