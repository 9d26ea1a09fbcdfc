// The keys of a kinematic scheme as they stand in a file; config/sections/scheme_file.h gives them
// meaning.
//
// Those that every scheme has are here; a type of scheme has more, which it lists itself
// (kinematics/scheme_key.h).
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/text/key_table.h"
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
};

// [[parked]]
struct ParkedFile {
  std::string axis;
  kinematics::Parking parking;
  std::string drive = "off";
};

// The value of a key of a geometry as a scheme file has it: the name of an axis or of a choice, or
// numbers.
using SchemeValue = std::variant<std::string, Numbers3, double>;

// A key of a geometry as a row of a key table: what may stand there, and what stands there when the
// file has none.
struct GeometryKey {
  KeyText text;
  SchemeValue value;
};

[[nodiscard]] GeometryKey geometry_key(const kinematics::SchemeKey& key);

// A scheme file; [[channel.scheme]] that names one; [[channel.scheme]] that holds the scheme
// itself.
[[nodiscard]] const Keys<SchemeFile>& scheme_keys();
[[nodiscard]] const Keys<SchemeFile>& reference_keys();
[[nodiscard]] const Keys<SchemeFile>& inline_keys();
[[nodiscard]] const Keys<ParkedFile>& parked_keys();

// Rows of the documentation; of the geometry of a type.
[[nodiscard]] std::vector<KeyRow> scheme_key_rows();
[[nodiscard]] std::vector<KeyRow> geometry_key_rows(const kinematics::TypeOfScheme& type);
[[nodiscard]] std::vector<KeyRow> parked_key_rows();

}  // namespace stanok::config
