// Keys of the register map of a drive: [axis.drive.map] with one field for each quantity, and the
// bits that lie in its words.
#pragma once

#include <vector>

#include "config/text/key_table.h"
#include "drives/register_map.h"

namespace stanok::config {

// Fields take width, sign and scale from `standard` unless they say otherwise; what the table does
// not name the drive does not have.
[[nodiscard]] drives::RegisterMap read_register_map(const toml::table& table,
                                                    const drives::RegisterMap& standard,
                                                    const Scope& scope);

// Takes away the bits of control and status word that only drives with the standard map have.
void clear_own_bits(drives::DriveBits& bits);

// Bits of `bits` that the table names.
void read_drive_bits(const toml::table& table, drives::DriveBits& bits, const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> register_map_key_rows();
[[nodiscard]] std::vector<KeyRow> register_field_key_rows();
[[nodiscard]] std::vector<KeyRow> drive_bit_key_rows();

}  // namespace stanok::config
