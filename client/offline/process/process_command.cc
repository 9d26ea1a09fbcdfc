#include "client/offline/process/process_command.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <stdexcept>

#include "client/offline/machine/job_options.h"
#include "client/offline/process/identify/identify_command.h"
#include "client/offline/process/lobes_report.h"
#include "client/offline/process/optimise_command.h"
#include "client/terminal/diagnostic_output.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "client/terminal/result_files.h"
#include "config/files/chatter_file.h"
#include "jobs/lobes/lobes_fields.h"
#include "jobs/lobes/program_speeds.h"
#include "protocol/contract/fields_json.h"
#include "runtime/program_files.h"

namespace stanok::client {
namespace {

using process::LobesMethod;
using process::LobesRequest;
using process::LobesStudy;
using process::PlannedCut;

struct LobesOptions {
  std::string input;
  std::string speeds = "1000:20000";
  int count = 800;
  std::vector<std::string> cuts;
  std::string program;
  double depth_mm = 0.0;
  JobOptions job;
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

// What is wrong with the program is printed; throws std::runtime_error then.
std::vector<double> speeds_of_program(const std::string& program, const JobOptions& job) {
  const channels::MachineConfig machine = machine_file_of(job).machine;
  const LocatedProgram located = locate(program);
  const runtime::ProgramFiles files(search_roots({located}, job), runtime::program_format(machine));
  const jobs::ProgramSpeeds found = jobs::program_speeds({.machine = machine,
                                                          .channel = job.channel,
                                                          .scheme = scheme_of(job),
                                                          .program = located.name,
                                                          .files = files});
  for (const Diagnostic& diagnostic : found.diagnostics) print(diagnostic);
  if (has_errors(found.diagnostics)) throw std::runtime_error(program + " has errors");
  return found.rev_per_min;
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
  if (!options.program.empty()) {
    for (const double speed : speeds_of_program(options.program, options.job))
      request.programmed.push_back({.speed_rev_per_min = speed, .depth_mm = options.depth_mm});
  }
  request.process = config::read_chatter_file(options.input);
  return request;
}

int run_lobes(const LobesOptions& options) {
  const LobesStudy study = study_lobes(request_of(options));
  if (!options.picture.empty()) draw_picture(study, options.picture);
  if (!options.csv.empty()) write_text_file(options.csv, to_csv(study));
  if (options.json) {
    write_json(protocol::fields_json(jobs::lobes_fields(study)));
  } else {
    write_data(to_text(study));
  }
  const bool is_stable = std::ranges::all_of(study.cuts, &PlannedCut::is_stable);
  return is_stable ? 0 : exit_failed;
}

// The operator commands have the noun as well.
CLI::App* noun_of(CLI::App& app) {
  for (CLI::App* noun : app.get_subcommands({})) {
    if (noun->get_name() == "process") return noun;
  }
  return app.add_subcommand("process", "cutting process");
}

}  // namespace

void add_process_commands(CLI::App& app, int& exit_code) {
  CLI::App* noun = noun_of(app);
  const auto options = std::make_shared<LobesOptions>();
  CLI::App* command = noun->add_subcommand(
      "lobes", "calculate the depth up to which a cut does not chatter at each speed");
  command->add_option("FILE", options->input, "file with cut and vibrations (TOML)")
      ->required()
      ->type_name("FILE");
  command->add_option("--speeds", options->speeds, "range of speeds, rev/min")
      ->type_name("FROM:TO");
  command->add_option("--count", options->count, "number of speeds in the range")
      ->check(CLI::Range(2, 100000));
  command
      ->add_option(
          "--cut", options->cuts,
          "planned cut in rev/min and mm, to be checked and marked; exit code 1 if it chatters")
      ->type_name("SPEED:DEPTH")
      ->delimiter(',');
  CLI::Option* const depth =
      command->add_option("--depth", options->depth_mm, "depth of the cuts of --program, mm")
          ->check(CLI::PositiveNumber);
  CLI::Option* const machine =
      command->add_option("--machine", options->job.machine_file, "machine file of the program")
          ->type_name("FILE");
  command
      ->add_option("--program", options->program,
                   "part program; the speeds of its feed moves are planned cuts")
      ->type_name("FILE")
      ->needs(depth)
      ->needs(machine);
  command->add_option("--channel", options->job.channel, "channel of the program")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--method", options->method,
                   "zeroth-order: uses the mean over a tooth; semi-discretisation: follows each "
                   "tooth, for small widths of cut")
      ->check(CLI::IsMember({"zeroth-order", "semi-discretisation"}));
  command->add_option("--picture", options->picture, "picture of the lobes, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command->add_option("--csv", options->csv, "write the limits as CSV")->type_name("FILE");
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = run_lobes(*options); });
  add_identify_command(*noun, exit_code);
  add_optimise_command(*noun, exit_code);
}

}  // namespace stanok::client
