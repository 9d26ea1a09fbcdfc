#include "client/offline/process/process_command.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "client/offline/process/lobes_report.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "config/files/chatter_file.h"

namespace stanok::client {
namespace {

struct LobesOptions {
  std::string input;
  std::string speeds = "1000:20000";
  int count = 800;
  std::vector<std::string> cuts;
  std::string method = "zeroth-order";
  std::string picture;
  std::string csv;
  bool json = false;
};

// Two positive numbers with a mark between them; nothing: the text is something else.
std::optional<std::pair<double, double>> two_numbers(const std::string& text, char mark) {
  const std::size_t middle = text.find(mark);
  if (middle == std::string::npos) return std::nullopt;
  const auto read = [](std::string_view part, double& value) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc{} && end == part.data() + part.size() && value > 0.0 && value < 1e9;
  };
  std::pair<double, double> numbers;
  const std::string_view view(text);
  if (!read(view.substr(0, middle), numbers.first)) return std::nullopt;
  if (!read(view.substr(middle + 1), numbers.second)) return std::nullopt;
  return numbers;
}

LobesRequest request_of(const LobesOptions& options) {
  LobesRequest request;
  const auto speeds = two_numbers(options.speeds, ':');
  if (!speeds || !(speeds->first < speeds->second))
    throw CLI::ValidationError("--speeds",
                               "`" + options.speeds + "` is not FROM:TO in rev/min, as 2000:20000");
  request.speed_from = speeds->first;
  request.speed_to = speeds->second;
  request.count = options.count;
  request.method = options.method == "semi-discretisation" ? LobesMethod::semi_discretisation
                                                           : LobesMethod::zeroth_order;
  for (const std::string& text : options.cuts) {
    const auto cut = two_numbers(text, ':');
    if (!cut)
      throw CLI::ValidationError(
          "--cut", "`" + text + "` is not SPEED:DEPTH in rev/min and mm, as 9000:1.5");
    request.programmed.push_back({.speed_rev_per_min = cut->first, .depth_mm = cut->second});
  }
  request.process = config::read_chatter_file(options.input);
  return request;
}

int run_lobes(const LobesOptions& options) {
  const LobesStudy study = study_lobes(request_of(options));
  if (!options.picture.empty()) draw_picture(study, options.picture);
  if (!options.csv.empty()) {
    std::ofstream stream(options.csv, std::ios::binary);
    stream << to_csv(study);
    stream.close();
    if (!stream)
      throw std::runtime_error("cannot write " + options.csv + "; check folder and permissions");
  }
  if (options.json) {
    write_json(to_json(study));
  } else {
    write_data(to_text(study));
  }
  const bool is_stable = std::ranges::all_of(study.cuts, &PlannedCut::is_stable);
  return is_stable ? 0 : exit_failed;
}

std::string picture_name_fault(const std::string& name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  return extension == ".svg" || extension == ".png" ? "" : "a picture ends in .svg or .png";
}

// The operator commands have the noun as well.
CLI::App* noun_of(CLI::App& app) {
  for (CLI::App* noun : app.get_subcommands({})) {
    if (noun->get_name() == "process") return noun;
  }
  return app.add_subcommand("process", "what a cut may be");
}

}  // namespace

void add_process_commands(CLI::App& app, int& exit_code) {
  CLI::App* noun = noun_of(app);
  const auto options = std::make_shared<LobesOptions>();
  CLI::App* command =
      noun->add_subcommand("lobes", "depths of cut up to which a cut does not chatter, by speed");
  command->add_option("FILE", options->input, "cut and vibrations (TOML)")
      ->required()
      ->type_name("FILE");
  command->add_option("--speeds", options->speeds, "range of speeds, rev/min")
      ->type_name("FROM:TO");
  command->add_option("--count", options->count, "speeds in the range")
      ->check(CLI::Range(2, 100000));
  command
      ->add_option("--cut", options->cuts,
                   "a planned cut, rev/min and mm: judged and marked; exit code 1 when it chatters")
      ->type_name("SPEED:DEPTH")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option(
          "--method", options->method,
          "zeroth-order: the mean over a tooth; semi-discretisation: each tooth, for small "
          "widths of cut")
      ->check(CLI::IsMember({"zeroth-order", "semi-discretisation"}));
  command->add_option("--picture", options->picture, "picture of the lobes, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->add_option("--csv", options->csv, "the limits as CSV")->type_name("FILE");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = run_lobes(*options); });
}

}  // namespace stanok::client
