#include "jobs/grinding/grind_input.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "config/files/grinding_file.h"

namespace stanok::jobs {
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

void apply(const GrindRequest& asked, DesignRequest& request) {
  if (asked.exact) request.process.removal = process::RemovalForm::exact;
  if (asked.burn_margin >= 0.0) request.limits.burn_margin = asked.burn_margin;
  if (asked.spark_out_revolutions >= 0.0) {
    request.simulation.spark_out_revolutions = asked.spark_out_revolutions;
    request.spark_out = process::SparkOut::given;
  }
  if (asked.time_step_s > 0.0) request.simulation.time_step_max_s = asked.time_step_s;
  request.optimiser.feedback = asked.feedback;
  request.optimiser.iterations_max = asked.iterations;
  request.optimiser.stops_when_growing = !asked.force;
  if (asked.points >= 0) request.staircase.points = asked.points;
  request.staircase.at_mm = asked.at_mm;
  if (asked.decimals > 0) request.staircase.decimals = asked.decimals;
}

bool is_process_file(const std::string& path) {
  return fs::path(path).extension() == ".toml";
}

}  // namespace

Expected<GrindInput, Diagnostics> control_input(const GrindRequest& asked) {
  auto file = process::read_control_text(read_text(asked.input), asked.input);
  if (!file) return Unexpected<Diagnostics>(file.error());
  GrindInput input{.request = {}, .control = std::move(*file)};
  input.request.process = input.control->process;
  input.request.allowance_mm = input.control->allowance_mm();
  apply(asked, input.request);
  return input;
}

Expected<GrindInput, Diagnostics> grind_input(const GrindRequest& asked) {
  if (!is_process_file(asked.input)) return control_input(asked);
  GrindInput input{.request = config::read_grinding_file(asked.input), .control = std::nullopt};
  apply(asked, input.request);
  return input;
}

}  // namespace stanok::jobs
