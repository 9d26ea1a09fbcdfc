// Rows of the scheme's key tables.
#include "config/sections/scheme_keys.h"

namespace stanok::config {
namespace {

using kinematics::Parking;
using kinematics::SchemeConfig;

Allowed known_types() {
  std::vector<std::string_view> names;
  for (const kinematics::TypeOfScheme& type : kinematics::scheme_types()) {
    if (type.chosen_by == kinematics::ChosenBy::file) names.push_back(type.name);
  }
  return one_of(std::move(names));
}

// What may stand at a key, by its kind.
struct Kind {
  SchemeValue value;
  std::string_view unit{};
  Allowed allowed{};
};

Kind kind_of(const kinematics::AxisName& axis) {
  return {.value = std::string(axis.usual)};
}
Kind kind_of(const kinematics::Direction& vector) {
  return {.value = components(vector.vector), .allowed = direction};
}
Kind kind_of(const kinematics::Place& place) {
  return {.value = components(place.vector), .unit = "mm"};
}
Kind kind_of(const kinematics::Number& number) {
  return {
      .value = number.value.get(), .unit = number.unit, .allowed = from(number.min, number.max)};
}
Kind kind_of(const kinematics::Choice& choice) {
  return {.value = std::string(choice.names[choice.chosen]), .allowed = one_of(choice.names)};
}

}  // namespace

GeometryKey geometry_key(const kinematics::SchemeKey& key) {
  Kind kind = std::visit([](const auto& value) { return kind_of(value); }, key.value);
  return {
      .text = {.name = key.name,
               .presence = key.presence == kinematics::KeyPresence::required ? required : optional,
               .unit = kind.unit,
               .meaning = key.meaning,
               .allowed = std::move(kind.allowed)},
      .value = std::move(kind.value)};
}

const Keys<SchemeFile>& scheme_keys() {
  static const Keys<SchemeFile> keys = {
      {"type", at<&SchemeFile::scheme, &SchemeConfig::type>, required, "",
       "kind of transformation (docs/integrator/kinematics.md)", known_types()},
      {"axes", at<&SchemeFile::axes>, required, "",
       "axes that take part, by their words in the channel or their names in the machine"},
      {"zero", at<&SchemeFile::zero>, optional, "mm, deg",
       "position of the scheme's base in machine axes, per axis that takes part"},
      {"retract", at<&SchemeFile::retract>, optional, "mm, deg",
       "machine positions to move to, in this order, before axes are parked"},
      {"parked", at<&SchemeFile::parked>, optional, "",
       "axes that do not take part, in the order in which they are parked; see below"},
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
       "machine position at which it is parked"},
      {"velocity", at<&ParkedFile::parking, &Parking::velocity>, optional, "mm/s, deg/s",
       "velocity of the parking move; 0: rapid", not_negative},
      {"brake", at<&ParkedFile::parking, &Parking::brake>, optional, "",
       "whether its brake is closed while it is parked"},
      {"drive", at<&ParkedFile::drive>, optional, "", "what its drive does while it is parked",
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
std::vector<KeyRow> geometry_key_rows(const kinematics::TypeOfScheme& type) {
  std::vector<KeyRow> rows;
  kinematics::SchemeGeometry geometry = type.geometry;
  for (const kinematics::SchemeKey& key : kinematics::keys_of(geometry)) {
    const GeometryKey row = geometry_key(key);
    const auto kind =
        std::visit([](const auto& value) { return detail::kind_text(value); }, row.value);
    rows.push_back(detail::key_row(row.text, kind));
  }
  return rows;
}
std::vector<KeyRow> parked_key_rows() {
  return describe(parked_keys());
}

}  // namespace stanok::config
