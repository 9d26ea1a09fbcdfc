// Rows of the scheme's key tables.
#include "config/scheme_keys.h"

#include <algorithm>

namespace stanok::config {
namespace {

using kinematics::Parking;
using kinematics::SchemeConfig;

Allowed known_types() {
  static const std::vector<std::string> types = kinematics::scheme_types_of_files();
  return one_of({types.begin(), types.end()});
}

}  // namespace

bool TypeGeometry::has(std::string_view key) const {
  return std::ranges::find(optional_keys, key) != optional_keys.end() ||
         std::ranges::find(required_keys, key) != required_keys.end();
}

// A new type of scheme gets its line here, and its new keys their rows below.
const std::vector<TypeGeometry>& type_geometries() {
  static const std::vector<TypeGeometry> geometries = {
      {"cartesian", {}, {}},
      {"lathe", {"x_reading", "turret"}, {}},
      {"head_table",
       {"head_axis", "head_vector", "table_axis", "table_vector"},
       {"pivot_to_spindle", "table_centre"}},
      {"head_head",
       {"pivot_to_pivot"},
       {"outer_axis", "outer_vector", "inner_axis", "inner_vector", "pivot_to_spindle"}},
      {"table_table",
       {"centre_to_centre"},
       {"outer_axis", "outer_vector", "inner_axis", "inner_vector", "table_centre"}},
  };
  return geometries;
}

const std::vector<RotaryKey>& rotary_keys() {
  static const std::vector<RotaryKey> keys = {
      {"head_axis", &SchemeFile::head_axis, &SchemeConfig::head_axis},
      {"table_axis", &SchemeFile::table_axis, &SchemeConfig::table_axis},
      {"outer_axis", &SchemeFile::outer_axis, &SchemeConfig::outer_axis},
      {"inner_axis", &SchemeFile::inner_axis, &SchemeConfig::inner_axis},
  };
  return keys;
}

const Keys<SchemeFile>& scheme_keys() {
  static const Keys<SchemeFile> keys = {
      {"type", at<&SchemeFile::scheme, &SchemeConfig::type>, required, "",
       "kind of transformation (docs/integrator/kinematics.md)", known_types()},
      {"axes", at<&SchemeFile::axes>, required, "",
       "axes that take part, by the channel's words or the machine's names"},
      {"zero", at<&SchemeFile::zero>, optional, "mm, deg",
       "position of the scheme's base in machine axes, per axis that takes part"},
      {"retract", at<&SchemeFile::retract>, optional, "mm, deg",
       "machine positions to go to, in this order, before axes are parked"},
      {"parked", at<&SchemeFile::parked>, optional, "",
       "axes that do not take part, in the order in which they are parked; see below"},
      {"x_reading", at<&SchemeFile::x_reading>, optional, "",
       "lathe: what the machine's X axis counts; points are always in radius",
       one_of({"radius", "diameter"})},
      {"turret", at<&SchemeFile::turret>, optional, "",
       "lathe: side of the workpiece; in front, X and Y of the machine point against the "
       "workpiece's",
       one_of({"rear", "front"})},
      {"head_axis", at<&SchemeFile::head_axis>, optional, "",
       "head_table: rotary axis that carries the spindle"},
      {"head_vector", at<&SchemeFile::scheme, &SchemeConfig::head_vector>, optional, "",
       "head_table: direction of head_axis", direction},
      {"table_axis", at<&SchemeFile::table_axis>, optional, "",
       "head_table: rotary axis that carries the workpiece"},
      {"table_vector", at<&SchemeFile::scheme, &SchemeConfig::table_vector>, optional, "",
       "head_table: direction of table_axis", direction},
      {"outer_axis", at<&SchemeFile::outer_axis>, optional, "",
       "head_head, table_table, required there: rotary axis nearest to the slides or the bed"},
      {"outer_vector", at<&SchemeFile::scheme, &SchemeConfig::outer_vector>, optional, "",
       "head_head, table_table, required there: direction of outer_axis", direction, "none"},
      {"inner_axis", at<&SchemeFile::inner_axis>, optional, "",
       "head_head, table_table, required there: rotary axis nearest to the spindle or the "
       "workpiece"},
      {"inner_vector", at<&SchemeFile::scheme, &SchemeConfig::inner_vector>, optional, "",
       "head_head, table_table, required there: direction of inner_axis, outer axis at 0",
       direction, "none"},
      {"pivot_to_pivot", at<&SchemeFile::scheme, &SchemeConfig::pivot_to_pivot>, optional, "mm",
       "head_head: from the pivot of outer_axis to that of inner_axis, head upright"},
      {"pivot_to_spindle", at<&SchemeFile::scheme, &SchemeConfig::pivot_to_spindle>, optional, "mm",
       "head_table, head_head, required there: from the (inner) pivot to the spindle nose, head "
       "upright",
       any, "none"},
      {"table_centre", at<&SchemeFile::scheme, &SchemeConfig::table_centre>, optional, "mm",
       "head_table, table_table, required there: position of X, Y, Z with the pivot (without a "
       "pivot, the nose) on the (outer) table's axis",
       any, "none"},
      {"centre_to_centre", at<&SchemeFile::scheme, &SchemeConfig::centre_to_centre>, optional, "mm",
       "table_table: from the centre on outer_axis to the one on inner_axis, table at 0"},
  };
  return keys;
}

const Keys<SchemeFile>& reference_keys() {
  static const Keys<SchemeFile> keys = {
      {"id", at<&SchemeFile::id>, required, "", "number for #kinematics", from(1)},
      {"file", at<&SchemeFile::file>, required, "", "file with the other keys"},
  };
  return keys;
}

const Keys<SchemeFile>& inline_keys() {
  static const Keys<SchemeFile> keys = [] {
    Keys<SchemeFile> all = {reference_keys().front()};
    all.insert(all.end(), scheme_keys().begin(), scheme_keys().end());
    return all;
  }();
  return keys;
}

const Keys<ParkedFile>& parked_keys() {
  static const Keys<ParkedFile> keys = {
      {"axis", at<&ParkedFile::axis>, required, "", "axis that is parked"},
      {"position", at<&ParkedFile::parking, &Parking::position>, optional, "mm, deg",
       "machine position where it stands"},
      {"velocity", at<&ParkedFile::parking, &Parking::velocity>, optional, "mm/s, deg/s",
       "velocity of the parking move; 0: rapid", not_negative},
      {"brake", at<&ParkedFile::parking, &Parking::brake>, optional, "",
       "whether its brake is closed there"},
      {"drive", at<&ParkedFile::drive>, optional, "", "what its drive does there",
       one_of({"off", "on"})},
  };
  return keys;
}

std::vector<KeyRow> scheme_key_rows() {
  std::vector<KeyRow> rows = describe(reference_keys());
  rows.back().initial = "none";  // left out when the keys below stand in the machine file
  const std::vector<KeyRow> own = describe(scheme_keys());
  rows.insert(rows.end(), own.begin(), own.end());
  return rows;
}
std::vector<KeyRow> parked_key_rows() {
  return describe(parked_keys());
}

}  // namespace stanok::config
