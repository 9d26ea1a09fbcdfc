#include "client/offline/grind/grind_input.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "config/files/grinding_file.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using process::ControlFile;
using process::DesignRequest;

std::string read_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const bool is_file = stream.is_open() && !fs::is_directory(path);
  std::string text;
  if (is_file) text.assign(std::istreambuf_iterator<char>(stream), {});
  if (!is_file || stream.bad()) {
    throw std::runtime_error("cannot read " + path + "; check the path");
  }
  return text;
}

void print_refusal(const nlohmann::ordered_json& diagnostics) {
  const nlohmann::ordered_json json{{"ok", false}, {"diagnostics", diagnostics}};
  write_json(json);
}

// What was found wrong is printed; nothing then.
std::optional<GrindInput> printed_or(const GrindOptions& options,
                                     Expected<GrindInput, Diagnostics> input) {
  if (input) return std::move(*input);
  auto list = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : input.error()) {
    list.push_back(to_json(diagnostic));
    if (!options.json) print(diagnostic);
  }
  if (options.json) print_refusal(list);
  return std::nullopt;
}

void apply(const GrindOptions& options, DesignRequest& request) {
  if (options.exact) request.process.removal = process::RemovalForm::exact;
  if (options.burn_margin >= 0.0) request.limits.burn_margin = options.burn_margin;
  if (options.spark_out_revolutions >= 0.0) {
    request.simulation.spark_out_revolutions = options.spark_out_revolutions;
    request.spark_out = process::SparkOut::given;
  }
  if (options.time_step_s > 0.0) request.simulation.time_step_max_s = options.time_step_s;
  request.optimiser.feedback = options.feedback;
  request.optimiser.iterations_max = options.iterations;
  request.optimiser.stops_when_growing = !options.force;
  if (options.points >= 0) request.staircase.points = options.points;
  request.staircase.at_mm = options.at_mm;
  if (options.decimals > 0) request.staircase.decimals = options.decimals;
}

bool is_process_file(const std::string& path) {
  return fs::path(path).extension() == ".toml";
}

// The faults of the file as `--json` has them.
nlohmann::ordered_json faults_json(const config::ConfigError& error) {
  auto list = nlohmann::ordered_json::array();
  for (const config::ConfigFault& fault : error.faults()) {
    Diagnostic diagnostic;
    diagnostic.code = "E9102";
    diagnostic.place.file = fault.file;
    diagnostic.place.line = diagnostic.place.end_line = static_cast<int>(fault.line);
    diagnostic.place.column = diagnostic.place.end_column = static_cast<int>(fault.column);
    diagnostic.message = fault.text;
    list.push_back(to_json(diagnostic));
  }
  return list;
}

}  // namespace

Expected<GrindInput, Diagnostics> control_input(const GrindOptions& options) {
  auto file = process::read_control_text(read_text(options.input), options.input);
  if (!file) return Unexpected<Diagnostics>(file.error());
  GrindInput input{.request = {}, .control = std::move(*file)};
  input.request.process = input.control->process;
  input.request.allowance_mm = input.control->allowance_mm();
  apply(options, input.request);
  return input;
}

Expected<GrindInput, Diagnostics> grind_input(const GrindOptions& options) {
  if (!is_process_file(options.input)) return control_input(options);
  GrindInput input{.request = config::read_grinding_file(options.input), .control = std::nullopt};
  apply(options, input.request);
  return input;
}

std::optional<GrindInput> read_control_input(const GrindOptions& options) {
  return printed_or(options, control_input(options));
}

std::optional<GrindInput> read_input(const GrindOptions& options) {
  try {
    return printed_or(options, grind_input(options));
  } catch (const config::ConfigError& error) {
    if (!options.json) throw;
    print_refusal(faults_json(error));
    return std::nullopt;
  }
}

}  // namespace stanok::client
