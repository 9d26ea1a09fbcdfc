// The machine file: everything stanokd, simulate and stanok-drives know of one machine.
//
// read_machine_file is strict: an unknown or missing key, a wrong kind or a value that contradicts
// another is an error with its place and remedy, and all errors of the file and the files it names
// are shown at once. Paths in it are relative to the machine file. All keys:
// docs/reference/configuration.md.
#pragma once

#include <filesystem>
#include <vector>

#include "config/sections/machine_description.h"
#include "config/text/config_error.h"

namespace stanok::config {

// Throws ConfigError.
[[nodiscard]] MachineFile read_machine_file(const std::filesystem::path& path);

// The same from texts: the machine file comes first, the others have the names it calls them by.
// Throws ConfigError.
[[nodiscard]] MachineFile read_machine_sources(std::vector<SourceFile> sources);

}  // namespace stanok::config
