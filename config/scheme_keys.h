// The keys of a kinematic scheme as they stand in a file; config/scheme_file.h gives them meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/key_table.h"
#include "kinematics/scheme.h"

namespace stanok::config {

// [[channel.scheme]] or a scheme file.
struct SchemeFile {
  int id = 0;
  std::string file;
  kinematics::SchemeConfig scheme;
  Texts axes;
  Subtable zero = nullptr;
  Subtable retract = nullptr;
  Subtables parked = nullptr;
  std::string head_axis = "B";
  std::string table_axis = "C";
  std::string outer_axis;
  std::string inner_axis;
  std::string x_reading = "radius";
  std::string turret = "rear";
};

// [[parked]]
struct ParkedFile {
  std::string axis;
  kinematics::Parking parking;
  std::string drive = "off";
};

// The keys of a type's geometry. Types may share keys.
struct TypeGeometry {
  std::string_view type;
  std::vector<std::string_view> optional_keys;
  std::vector<std::string_view> required_keys;

  [[nodiscard]] bool has(std::string_view key) const;
};

[[nodiscard]] const std::vector<TypeGeometry>& type_geometries();

// A key that names a rotary axis, and where the index of that axis goes.
struct RotaryKey {
  std::string_view key;
  std::string SchemeFile::* name;
  int kinematics::SchemeConfig::* axis;
};

[[nodiscard]] const std::vector<RotaryKey>& rotary_keys();

// A scheme file; [[channel.scheme]] that names one; [[channel.scheme]] that holds the scheme
// itself.
[[nodiscard]] const Keys<SchemeFile>& scheme_keys();
[[nodiscard]] const Keys<SchemeFile>& reference_keys();
[[nodiscard]] const Keys<SchemeFile>& inline_keys();
[[nodiscard]] const Keys<ParkedFile>& parked_keys();

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> scheme_key_rows();
[[nodiscard]] std::vector<KeyRow> parked_key_rows();

}  // namespace stanok::config
