// [[channel]] of the machine file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "config/text/key_table.h"

namespace stanok::config {

// All channels, ascending by id. `machine` holds the axes and spindles they name; scheme files are
// looked for in `folder`.
[[nodiscard]] NumberedList<channels::ChannelConfig> read_channels(
    Subtables channels, const channels::MachineConfig& machine, const std::filesystem::path& folder,
    const Scope& scope);

// The text of a machine file with `scheme = N` of every [[channel]] spelt `active = N`, the same
// length, so that places stay. TOML lets no table hold a number and [[channel.scheme]] under one
// name, but both belong to the machine file as people write it.
[[nodiscard]] std::string with_active_scheme_key(std::string text);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> channel_key_rows();

}  // namespace stanok::config
