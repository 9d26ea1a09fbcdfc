#include "runtime/run_setup.h"

#include <sstream>
#include <stdexcept>

#include "config/tables_file.h"

namespace stanok::runtime {

std::string text_of(const RunSetup& setup) {
  std::ostringstream text;
  text << "on_at_start " << setup.options.on_at_start << "\n"
       << "stops_go_on " << setup.options.stops_go_on << "\n"
       << "outputs_to_inputs " << setup.options.outputs_to_inputs << "\n";
  for (const auto& [channel, scheme] : setup.schemes)
    text << "scheme " << channel << " " << scheme << "\n";
  return text.str();
}

RunSetup setup_of(const std::string& text) {
  RunSetup setup;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    int value = 0;
    words >> key >> value;
    if (key == "on_at_start") {
      setup.options.on_at_start = value != 0;
    } else if (key == "stops_go_on") {
      setup.options.stops_go_on = value != 0;
    } else if (key == "outputs_to_inputs") {
      setup.options.outputs_to_inputs = value != 0;
    } else if (key == "scheme") {
      int scheme = 0;
      words >> scheme;
      setup.schemes.emplace_back(value, scheme);
    } else {
      throw std::runtime_error("the setup of the run has an unknown key: " + key);
    }
    if (words.fail()) throw std::runtime_error("the setup of the run lacks a value: " + line);
  }
  return setup;
}

void record_setup(const RunSetup& setup, const config::MachineFile& file,
                  recording::MessageStream& stream) {
  using recording::TextKind;
  const std::filesystem::path folder = file.path.parent_path();
  for (const config::SourceFile& source : file.sources) {
    const bool is_machine = &source == &file.sources.front();
    const std::string name = source.path.lexically_relative(folder).string();
    stream.text({.kind = is_machine ? TextKind::machine_file : TextKind::scheme,
                 .name = name,
                 .text = source.text});
  }
  const std::string tables = config::to_toml(file.machine.tables);
  stream.text({.kind = TextKind::tables, .name = "tables at start", .text = tables});
  const std::string text = text_of(setup);
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
