#include "client/offline/grind/grind_input.h"

#include "client/terminal/diagnostic_output.h"
#include "client/terminal/output.h"
#include "config/files/grinding_file.h"

namespace stanok::client {
namespace {

using jobs::GrindInput;

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

std::optional<GrindInput> read_control_input(const GrindOptions& options) {
  return printed_or(options, jobs::control_input(options));
}

std::optional<GrindInput> read_input(const GrindOptions& options) {
  try {
    return printed_or(options, jobs::grind_input(options));
  } catch (const config::ConfigError& error) {
    if (!options.json) throw;
    print_refusal(faults_json(error));
    return std::nullopt;
  }
}

}  // namespace stanok::client
