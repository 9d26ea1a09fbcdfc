#include "client/offline/process/identify_command.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "client/offline/process/identify_report.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "client/terminal/result_files.h"

namespace stanok::client {
namespace {

struct IdentifyOptions {
  std::string log;
  std::vector<std::string> stock;
  int channel = 1;
  int spindle = 1;
  double coefficient_n = 0.0;
  std::string out;
  std::string picture;
  bool json = false;
};

std::optional<StockStep> stock_step(const std::string& text) {
  StockStep step;
  const char* const end = text.data() + text.size();
  const auto z = std::from_chars(text.data(), end, step.z_mm);
  if (z.ec != std::errc{} || z.ptr == end || *z.ptr != ':') return std::nullopt;
  const auto radius = std::from_chars(z.ptr + 1, end, step.radius_mm);
  if (radius.ec != std::errc{} || radius.ptr != end || !(step.radius_mm > 0.0)) return std::nullopt;
  return step;
}

std::vector<StockStep> stock_of(const IdentifyOptions& options) {
  std::vector<StockStep> stock;
  for (const std::string& text : options.stock) {
    const auto step = stock_step(text);
    if (!step || (!stock.empty() && !(step->z_mm < stock.back().z_mm))) {
      throw CLI::ValidationError(
          "--stock", "`" + text + "` is not Z:RADIUS in mm with falling Z, as 0:32,-20:33");
    }
    stock.push_back(*step);
  }
  return stock;
}

int run_identify(const IdentifyOptions& options) {
  const CutLog log =
      read_cut_log(options.log, options.channel, options.spindle - 1, stock_of(options));
  const auto fit = process::fit_turning(log.record);
  if (!fit) throw std::runtime_error(fit.error());
  const IdentifyReport report{.log = log, .fit = *fit, .coefficient_n = options.coefficient_n};
  if (!options.out.empty()) write_text_file(options.out, process_section(report));
  if (!options.picture.empty()) draw_picture(report, options.picture);
  if (options.json) {
    write_json(to_json(report));
  } else {
    write_data(to_text(report));
  }
  return 0;
}

}  // namespace

void add_identify_command(CLI::App& noun, int& exit_code) {
  const auto options = std::make_shared<IdentifyOptions>();
  CLI::App* command = noun.add_subcommand(
      "identify",
      "idle power, cutting coefficient, exponent and lag from the log of a turning cut");
  command->add_option("LOG", options->log, "log of a cut")->required()->type_name("FILE");
  command
      ->add_option("--stock", options->stock,
                   "the bar before the cut, in the frame of the program: from Z on this radius, mm")
      ->required()
      ->type_name("Z:RADIUS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--channel", options->channel, "channel of the lathe")
      ->check(CLI::Range(1, 16));
  command->add_option("--spindle", options->spindle, "spindle of the machine, from 1 on")
      ->check(CLI::Range(1, 16));
  command
      ->add_option("--coefficient", options->coefficient_n,
                   "C of the material, N at 1 mm depth and 1 mm per turn: tells the efficiency")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", options->out, "[process] section to write")->type_name("FILE");
  command->add_option("--picture", options->picture, "power and residual, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = run_identify(*options); });
}

}  // namespace stanok::client
