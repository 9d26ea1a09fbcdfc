// libFuzzer target: any text as a machine file and as the tables of one. It is read, or refused
// with every fault at a place of the text.
#include <string>

#include "config/files/machine_file.h"
#include "config/files/tables_file.h"

using namespace stanok::config;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  try {
    static_cast<void>(read_machine_sources({{"fuzz.toml", text}}));
  } catch (const ConfigError& refused) {
    if (refused.faults().empty()) std::abort();
  }
  try {
    const auto tables = read_tables_text(text, "tables.toml", {"X", "Y", "Z", "B", "C"});
    // What was accepted is kept in a form that is accepted again.
    static_cast<void>(read_tables_text(to_toml(tables), "kept.toml", {"X", "Y", "Z", "B", "C"}));
  } catch (const ConfigError& refused) {
    if (refused.faults().empty()) std::abort();
    for (const ConfigFault& fault : refused.faults())
      if (fault.file == "kept.toml") std::abort();
  }
  return 0;
}
