#include "runtime/run_setup.h"

#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include "config/files/tables_file.h"

namespace stanok::runtime {

std::string text_of(const RunSetup& setup) {
  std::ostringstream text;
  text << "on_at_start " << setup.options.on_at_start << "\n"
       << "stops_go_on " << setup.options.stops_go_on << "\n"
       << "outputs_to_inputs " << setup.options.outputs_to_inputs << "\n"
       << "unnamed_tools " << setup.unnamed_tools << "\n";
  for (const auto& [channel, scheme] : setup.schemes)
    text << "scheme " << channel << " " << scheme << "\n";
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const auto& [axis, position] : setup.starts)
    text << "start " << axis << " " << position << "\n";
  return text.str();
}

RunSetup setup_of(const std::string& text) {
  RunSetup setup;
  const std::map<std::string, bool*> switches{
      {"on_at_start", &setup.options.on_at_start},
      {"stops_go_on", &setup.options.stops_go_on},
      {"outputs_to_inputs", &setup.options.outputs_to_inputs},
      {"unnamed_tools", &setup.unnamed_tools}};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (const auto found = switches.find(key); found != switches.end()) {
      words >> *found->second;
    } else if (key == "scheme") {
      auto& [channel, scheme] = setup.schemes.emplace_back();
      words >> channel >> scheme;
    } else if (key == "start") {
      std::string axis;
      words >> axis;
      words >> setup.starts[axis];
    } else {
      throw std::runtime_error("the setup of the run has an unknown key: " + key);
    }
    if (words.fail()) throw std::runtime_error("the setup of the run lacks a value: " + line);
  }
  return setup;
}

recording::LogDescription description_of(const config::MachineFile& file, std::string version,
                                         std::string build) {
  auto description = recording::describe(file.machine, std::move(version), std::move(build));
  if (!file.sources.empty())
    description.config_hash = recording::text_hash(file.sources.front().text);
  return description;
}

void record_setup(const RunSetup& setup, const config::MachineFile& file,
                  recording::MessageStream& stream) {
  using recording::TextKind;
  const std::filesystem::path folder = file.path.lexically_normal().parent_path();
  for (const config::SourceFile& source : file.sources) {
    const bool is_machine = &source == &file.sources.front();
    const std::string name = source.path.lexically_normal().lexically_relative(folder).string();
    stream.text({.kind = is_machine ? TextKind::machine_file : TextKind::scheme,
                 .name = name,
                 .text = source.text});
  }
  const std::string tables = config::to_toml(file.machine.tables);
  stream.text({.kind = TextKind::tables, .name = "tables at start", .text = tables});
  RunSetup whole = setup;
  whole.unnamed_tools = file.machine.unnamed_tools;
  for (const channels::AxisConfig& axis : file.machine.axes) whole.starts[axis.name] = axis.start;
  const std::string text = text_of(whole);
  stream.text({.kind = TextKind::initial_state, .name = "run", .text = text});
}

std::string this_build() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace stanok::runtime
