#include "client/offline/process/forecast_job.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/interrupts.h"

namespace stanok::client {

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path + "; check the path");
  return {std::istreambuf_iterator<char>(file), {}};
}

jobs::ForecastJob forecast_job(const std::string& program, const JobOptions& options) {
  const LocatedProgram located = locate(program);
  return {.machine = machine_file_of(options),
          .program_roots = search_roots({located}, options),
          .program = located.name,
          .text = text_of_file(program),
          .channel = options.channel,
          .schemes = scheme_choices(options),
          .tell = [](const Diagnostic& diagnostic) { print(diagnostic); },
          .gives_up = [] { return is_interrupted(); }};
}

}  // namespace stanok::client
