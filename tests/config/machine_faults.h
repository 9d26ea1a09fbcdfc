// The faults for which a machine file is refused.
#pragma once

#include <filesystem>
#include <vector>

#include "config/files/machine_file.h"

namespace stanok::config {

// Empty when the file is taken.
inline std::vector<ConfigFault> faults_of_machine(const std::filesystem::path& path) {
  try {
    static_cast<void>(read_machine_file(path));
  } catch (const ConfigError& error) {
    return error.faults();
  }
  return {};
}

}  // namespace stanok::config
