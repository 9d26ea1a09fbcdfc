// The keys of [axis.plant] and their checks.
#include "config/sections/plant_section.h"

namespace stanok::config {
namespace {

struct PlantFile {
  AxisSimulation plant;
  std::string encoder = "absolute";
};

const Keys<PlantFile>& axis_plant_keys() {
  static const Keys<PlantFile> keys = {
      {"encoder", at<&PlantFile::encoder>, optional, "",
       "whether the drive knows its position at power-on or counts from wherever it is then",
       one_of({"absolute", "incremental"})},
      {"home_switch_from", at<&PlantFile::plant, &AxisSimulation::home_switch_from>, optional,
       "mm, deg", "lower end of the home switch"},
      {"home_switch_to", at<&PlantFile::plant, &AxisSimulation::home_switch_to>, optional,
       "mm, deg", "upper end of the home switch"},
      {"limit_switch_negative", at<&PlantFile::plant, &AxisSimulation::limit_negative>, optional,
       "mm, deg", "the limit switch of this end is active at and below this position"},
      {"limit_switch_positive", at<&PlantFile::plant, &AxisSimulation::limit_positive>, optional,
       "mm, deg", "the limit switch of this end is active at and above this position"},
      {"index_position", at<&PlantFile::plant, &AxisSimulation::index_position>, optional,
       "mm, deg", "position of one index pulse of the encoder"},
      {"index_pitch", at<&PlantFile::plant, &AxisSimulation::index_pitch>, optional, "mm, deg",
       "distance between index pulses; 0: none", not_negative},
      {"backlash", at<&PlantFile::plant, &AxisSimulation::backlash>, optional, "mm, deg",
       "backlash between the motor with the encoder and the load with the switches", not_negative},
      {"friction", at<&PlantFile::plant, &AxisSimulation::dry_friction>, optional, "mm/s2, deg/s2",
       "deceleration by dry friction", not_negative},
  };
  return keys;
}

void check_home_switch(const toml::table& table, const AxisSimulation& plant, const Scope& scope) {
  const bool has_from = table.contains("home_switch_from");
  const bool has_to = table.contains("home_switch_to");
  if (has_from != has_to) {
    scope.fault(place_of(table, has_from ? "home_switch_from" : "home_switch_to"),
                std::string(has_from ? "home_switch_to" : "home_switch_from") +
                    " is missing; give both ends of the switch, or neither");
  } else if (has_from && plant.home_switch_from >= plant.home_switch_to) {
    scope.fault(place_of(table, "home_switch_from"),
                "home_switch_from is " + number_text(plant.home_switch_from) +
                    "; it must be below home_switch_to, " + number_text(plant.home_switch_to));
  }
}

}  // namespace

AxisSimulation read_axis_plant(const toml::table& table, const Scope& scope) {
  PlantFile file;
  read_table(table, axis_plant_keys(), file, scope);
  file.plant.absolute_encoder = file.encoder == "absolute";
  check_home_switch(table, file.plant, scope);
  return file.plant;
}

std::vector<KeyRow> axis_plant_key_rows() {
  return describe(axis_plant_keys());
}

}  // namespace stanok::config
