// Rows of the scheme's key tables.
#include "config/scheme_keys.h"

namespace stanok::config {
namespace {

using kinematics::Parking;
using kinematics::SchemeConfig;

Allowed known_types() {
  static const std::vector<std::string> types = kinematics::scheme_types();
  return one_of({types.begin(), types.end()});
}

}  // namespace

// A new type of scheme gets its line here.
const std::vector<TypeGeometry>& type_geometries() {
  static const std::vector<TypeGeometry> geometries = {
      {"cartesian", {}, {}},
      {"head_table", {"head_axis", "table_axis"}, {"pivot_to_spindle", "table_centre"}},
  };
  return geometries;
}

const Keys<SchemeFile>& scheme_keys() {
  static const Keys<SchemeFile> keys = {
      {"type", at<&SchemeFile::scheme, &SchemeConfig::type>, required, "",
       "kind of transformation (docs/kinematics.md)", known_types()},
      {"axes", at<&SchemeFile::axes>, required, "",
       "axes that take part, by the channel's words or the machine's names"},
      {"zero", at<&SchemeFile::zero>, optional, "mm, deg",
       "position of the scheme's base in machine axes, per axis that takes part"},
      {"retract", at<&SchemeFile::retract>, optional, "mm, deg",
       "machine positions to go to, in this order, before axes are parked"},
      {"parked", at<&SchemeFile::parked>, optional, "",
       "axes that do not take part, in the order in which they are parked; see below"},
      {"head_axis", at<&SchemeFile::head_axis>, optional, "",
       "head_table: rotary axis about Y that carries the spindle"},
      {"table_axis", at<&SchemeFile::table_axis>, optional, "",
       "head_table: rotary axis about Z that carries the workpiece"},
      {"pivot_to_spindle", at<&SchemeFile::scheme, &SchemeConfig::pivot_to_spindle>, optional, "mm",
       "head_table, required there: from the pivot to the spindle nose, head upright"},
      {"table_centre", at<&SchemeFile::scheme, &SchemeConfig::table_centre>, optional, "mm",
       "head_table, required there: position of X, Y, Z with the pivot on the table's axis"},
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
