#include "client/offline/grind/grind_command.h"

#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "base/place.h"
#include "client/offline/grind/grind_input.h"
#include "client/offline/grind/grind_picture.h"
#include "client/offline/grind/grind_report.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/output.h"
#include "client/terminal/progress_line.h"
#include "client/terminal/result_files.h"
#include "jobs/grinding/grind_cycle.h"
#include "jobs/grinding/grind_study.h"
#include "protocol/contract/fields_json.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using jobs::GrindCycle;
using jobs::GrindInput;
using process::DesignRequest;

void show_iterations(DesignRequest& request, ProgressLine& progress) {
  request.optimiser.on_iteration = [&progress](const process::Iteration& iteration) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "iteration %d: error %.2f %%, at most %.2f %%",
                  iteration.number, 100.0 * iteration.rms, 100.0 * iteration.worst);
    progress.show(text.data());
  };
}

void print_findings_of_process(const process::Findings& findings) {
  const Terminal terminal(STDERR_FILENO);
  for (const process::Finding& finding : findings) {
    const Colour colour = finding.is_error() ? Colour::red : Colour::yellow;
    write_message(terminal.coloured(to_text(finding), colour));
  }
}

void draw_pictures(const GrindOptions& options, const GrindCycle& cycle) {
  const process::OptimalLaw& optimum = cycle.design.continuous;
  const bool has_optimum = !optimum.law.empty();
  const process::PlungeRun& run = cycle.design.verification.run;
  if (!options.picture.empty() && !run.samples.empty()) {
    draw_picture({cycle.request, cycle.design.law, run, has_optimum ? &optimum : nullptr},
                 options.picture);
  }
  if (!options.optimum_picture.empty() && has_optimum) {
    draw_picture({cycle.request, optimum.law, optimum.run}, options.optimum_picture);
  }
}

int report(const GrindOptions& options, const GrindCycle& cycle) {
  draw_pictures(options, cycle);
  const process::Findings& findings = cycle.design.verification.findings;
  if (options.json) {
    write_json(protocol::fields_json(jobs::cycle_fields(cycle)));
  } else {
    write_data(to_text(cycle, Terminal(STDOUT_FILENO)));
    print_findings_of_process(findings);
  }
  return process::has_errors(findings) ? exit_failed : 0;
}

void write_program(const GrindOptions& options, const DesignRequest& request,
                   const process::InfeedLaw& law, double spark_out_revolutions) {
  const jobs::GrindProgram program =
      jobs::grind_program({.process = request.process,
                           .law = law,
                           .machine = options.machine,
                           .title = fs::path(options.input).filename().string(),
                           .spark_out_revolutions = spark_out_revolutions,
                           .gauge_margin_mm = options.gauge_margin_mm});
  for (const std::string& warning : program.warnings) write_message("warning: " + warning + "\n");
  write_text_file(options.program, program.text);
}

int refused(const GrindOptions& options, const process::Findings& findings) {
  if (options.json) write_json(protocol::fields_json(jobs::refusal_fields(findings)));
  if (!options.json) print_findings_of_process(findings);
  return exit_failed;
}

// KEY=VALUE: a part of stiffness or force_factor, or mm of allowance.
process::Spread spread_of(const GrindOptions& options) {
  process::Spread spread;
  for (const std::string& text : options.spreads) {
    const std::size_t middle = text.find('=');
    const std::string key = text.substr(0, middle);
    double value = -1.0;
    if (middle != std::string::npos) {
      const char* const end = text.data() + text.size();
      if (std::from_chars(text.data() + middle + 1, end, value).ptr != end) value = -1.0;
    }
    constexpr double part_max = 0.9;
    double* const place = key == "stiffness"      ? &spread.stiffness
                          : key == "force_factor" ? &spread.force_factor
                          : key == "allowance"    ? &spread.allowance_mm
                                                  : nullptr;
    if (place == nullptr || !(value >= 0.0 && value <= part_max)) {
      throw CLI::ValidationError("--spread", "'" + text +
                                                 "' is not stiffness=PART, force_factor=PART or "
                                                 "allowance=MM, as stiffness=0.2, up to 0.9");
    }
    *place = value;
  }
  return spread;
}

int run_design(const GrindOptions& options) {
  const process::Spread spread = spread_of(options);
  auto input = read_input(options);
  if (!input) return exit_failed;
  ProgressLine progress;
  show_iterations(input->request, progress);
  const auto cycle = jobs::designed_cycle(input->request, spread);
  progress.clear();
  if (!cycle) return refused(options, cycle.error());
  if (!options.out.empty()) write_text_file(options.out, jobs::control_text(*input, *cycle));
  if (!options.program.empty())
    write_program(options, input->request, cycle->design.law, cycle->design.spark_out_revolutions);
  return report(options, *cycle);
}

int run_verify(const GrindOptions& options) {
  auto input = read_control_input(options);
  if (!input) return exit_failed;
  if (!options.out.empty()) write_text_file(options.out, process::control_text(*input->control));
  ProgressLine progress;
  show_iterations(input->request, progress);
  const GrindCycle cycle = jobs::assessed_cycle(input->request, input->control->law);
  progress.clear();
  return report(options, cycle);
}

int run_program(const GrindOptions& options) {
  const auto input = read_control_input(options);
  if (!input) return exit_failed;
  const DesignRequest& request = input->request;
  const process::InfeedLaw& law = input->control->law;
  write_program(options, request, law, request.simulation.spark_out_revolutions);
  const process::Findings findings =
      process::verify_cycle(request.process, law, request.simulation, request.limits).findings;
  print_findings_of_process(findings);
  return process::has_errors(findings) ? exit_failed : 0;
}

int run_study_command(const GrindOptions& options) {
  std::vector<jobs::Variation> variations;
  for (const std::string& text : options.variations) {
    const auto variation = jobs::read_variation(text);
    if (!variation) {
      throw CLI::ValidationError("--set", "'" + text +
                                              "' is not KEY=FROM:TO:COUNT or KEY=A,B,C with a "
                                              "key of the process file, as stiffness=2e7:4e7:100 "
                                              "or part_speed=100,120");
    }
    variations.push_back(*variation);
  }
  const double size = jobs::study_size(variations);
  if (size > jobs::study_points_max) {
    throw CLI::ValidationError("--set", "more than a million designs");
  }
  const auto part = jobs::read_study_part(options.part);
  if (!part) {
    throw CLI::ValidationError("--part",
                               "'" + options.part + "' is not K/N with K from 1 to N, as 3/10");
  }
  auto input = read_input(options);
  if (!input) return exit_failed;
  ProgressLine progress;
  const std::size_t designs = part->end(checked_size(size)) - part->begin(checked_size(size));
  const auto show = [&](std::size_t done) {
    constexpr std::size_t columns = 79;
    progress.show(progress_bar(done, designs, "designs", columns));
  };
  const std::vector<jobs::StudyPoint> points =
      jobs::run_study(input->request, variations, *part, show);
  progress.clear();
  const std::string text = jobs::study_csv(variations, *part, points);
  if (options.out.empty()) {
    write_data(text);
  } else {
    write_text_file(options.out, text);
  }
  return 0;
}

void add_process_options(CLI::App& command, GrindOptions& options) {
  command.add_flag("--exact", options.exact,
                   "calculate the removal as Q = a R instead of the paper's triangle");
  command
      .add_option("--burn-margin", options.burn_margin,
                  "fraction by which the removal may exceed the burn line (0.05)")
      ->check(CLI::Range(0.0, 1.0));
  command
      .add_option("--spark-out", options.spark_out_revolutions,
                  "spark-out revolutions of the part after the last X")
      ->check(CLI::Range(0.0, 1000.0));
  command.add_option("--time-step", options.time_step_s, "time step of the simulation, s (0.0005)")
      ->check(CLI::Range(1e-6, 0.0005));
}

void add_result_options(CLI::App& command, GrindOptions& options) {
  command.add_option("--out", options.out, "control file to write")->type_name("FILE");
  command.add_option("--picture", options.picture, "picture of the cycle, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command
      .add_option("--optimum-picture", options.optimum_picture,
                  "picture of the continuous law, .svg or .png")
      ->type_name("FILE")
      ->check(picture_name_fault);
  command.add_flag("--json", options.json, "print JSON");
}

void add_machine_options(CLI::App& command, GrindOptions& options) {
  command
      .add_option("--gauge", options.gauge_margin_mm,
                  "let the gauge end the last feed, at most this far below the last X, mm")
      ->check(CLI::Range(0.001, 1.0));
  command
      .add_option("--machine", options.machine.machine_file,
                  "machine file, for the spindles of its grind channel")
      ->type_name("FILE");
  command.add_option("--channel", options.machine.channel, "channel of the machine")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--wheel-speed", options.machine.wheel_speed_m_per_s,
                  "surface speed of the wheel, m/s (35)")
      ->check(CLI::Range(1.0, 200.0));
}

void add_staircase_options(CLI::App& command, GrindOptions& options) {
  command
      .add_option("--points", options.points,
                  "number of switch points; default: as many as are worthwhile")
      ->check(CLI::Range(0, process::switch_points_max));
  command
      .add_option("--at", options.at_mm, "X of the switch points in mm, descending: 0.26,0.09,0.02")
      ->delimiter(',')
      ->excludes("--points");
  command
      .add_option("--decimals", options.decimals,
                  "decimals of X and feeds in the table; default: 4 or more")
      ->check(CLI::Range(3, 7));
}

void add_iteration_options(CLI::App& command, GrindOptions& options) {
  command.add_option("--koc", options.feedback, "gain of the iteration, below 1 (0.5)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--iterations", options.iterations,
                  "maximum number of iterations; 0: the constant feed (40)")
      ->check(CLI::Range(0, 1000));
  command.add_flag("--force", options.force, "keep iterating even with a gain that is not stable");
}

using Run = int (*)(const GrindOptions&);

}  // namespace

void add_grind_commands(CLI::App& app, int& exit_code) {
  CLI::App* noun = app.add_subcommand("grind", "plunge grinding cycles");
  noun->require_subcommand(1);
  const auto add = [&](const char* name, const char* help, Run run) {
    const auto options = std::make_shared<GrindOptions>();
    CLI::App* command = noun->add_subcommand(name, help);
    command->callback([options, run, &exit_code] { exit_code = run(*options); });
    return std::pair(command, options);
  };
  const auto [design, of_design] =
      add("design", "design the infeed cycle of a process: optimum, table, program", &run_design);
  design->add_option("PROCESS", of_design->input, "process file (.toml) or control file")
      ->type_name("FILE")
      ->required();
  design->add_option("--program", of_design->program, "part program to write")->type_name("FILE");
  add_process_options(*design, *of_design);
  add_staircase_options(*design, *of_design);
  add_iteration_options(*design, *of_design);
  design
      ->add_option(
          "--spread", of_design->spreads,
          "KEY=PART: the table must also work for values that differ by this much to either side: "
          "stiffness, force_factor (fractions), allowance (mm); may be repeated")
      ->type_name("KEY=PART");
  add_result_options(*design, *of_design);
  add_machine_options(*design, *of_design);

  const auto [verify, of_verify] =
      add("verify", "simulate and assess the cycle of a control file", &run_verify);
  verify->add_option("CONTROL_FILE", of_verify->input, "control file")
      ->type_name("FILE")
      ->required();
  add_process_options(*verify, *of_verify);
  add_result_options(*verify, *of_verify);

  const auto [program, of_program] =
      add("program", "write the part program of a control file", &run_program);
  program->add_option("CONTROL_FILE", of_program->input, "control file")
      ->type_name("FILE")
      ->required();
  program->add_option("-o,--out", of_program->program, "part program to write")
      ->type_name("FILE")
      ->required();
  program
      ->add_option("--spark-out", of_program->spark_out_revolutions,
                   "spark-out revolutions after the last X")
      ->check(CLI::Range(0.0, 1000.0));
  add_machine_options(*program, *of_program);

  const auto [study, of_study] =
      add("study", "design cycles for varied values of a process, as CSV", &run_study_command);
  study->add_option("PROCESS", of_study->input, "process file (.toml) or control file")
      ->type_name("FILE")
      ->required();
  study
      ->add_option("--set,--vary", of_study->variations,
                   "KEY=FROM:TO:COUNT, in equal steps, or KEY=A,B,C; may be repeated")
      ->required();
  study
      ->add_option("--part", of_study->part,
                   "part K of N of the study, for job arrays: all parts one after the other make "
                   "the whole file; default 1/1")
      ->type_name("K/N");
  study->add_option("--out", of_study->out, "CSV file; default: standard output")
      ->type_name("FILE");
  add_process_options(*study, *of_study);
  add_staircase_options(*study, *of_study);
}

}  // namespace stanok::client
