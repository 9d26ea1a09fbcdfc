// The list of documented tables, and their form in Markdown.
#include "config/files/key_reference.h"

#include <algorithm>

#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "config/files/tables_file.h"
#include "config/sections/automatic_feed_section.h"
#include "config/sections/axis_section.h"
#include "config/sections/channel_section.h"
#include "config/sections/contact_section.h"
#include "config/sections/drive_section.h"
#include "config/sections/machine_sections.h"
#include "config/sections/plant_section.h"
#include "config/sections/probing_section.h"
#include "config/sections/process_section.h"
#include "config/sections/register_section.h"
#include "config/sections/scheme_keys.h"
#include "config/sections/signal_section.h"
#include "config/sections/vibration_section.h"

namespace stanok::config {

namespace {

// What the types of schemes add to [[channel.scheme]].
std::vector<KeySection> geometry_sections() {
  std::vector<KeySection> sections;
  for (const kinematics::TypeOfScheme& type : kinematics::scheme_types()) {
    std::vector<KeyRow> rows = geometry_key_rows(type);
    if (rows.empty()) continue;
    sections.push_back({"[[channel.scheme]] of type " + std::string(type.name), std::move(rows)});
  }
  return sections;
}

}  // namespace

std::vector<KeySection> key_sections() {
  std::vector<KeySection> sections = {
      {"[machine]", describe(machine_keys())},
      {"[[axis]]", axis_key_rows()},
      {"[axis.homing]", homing_key_rows()},
      {"[axis.position_controller]", controller_key_rows()},
      {"[axis.drive]", drive_key_rows()},
      {"[axis.drive.map]", register_map_key_rows()},
      {"a quantity of [axis.drive.map]", register_field_key_rows()},
      {"[axis.drive.bits]", drive_bit_key_rows()},
      {"[axis.drive.words]", run_word_key_rows()},
      {"[axis.plant]", axis_plant_key_rows()},
      {"[[spindle]]", spindle_key_rows()},
      {"[[channel]]", channel_key_rows()},
      {"[[channel.automatic_feed]]", automatic_feed_key_rows()},
      {"[[channel.scheme]], scheme file", scheme_key_rows()},
      {"[[parked]] of a scheme", parked_key_rows()},
      {"[drives]", drives_key_rows()},
      {"[[signal]]", signal_key_rows()},
      {"[[vibration_sensor]]", vibration_sensor_key_rows()},
      {"[lcm]", lcm_key_rows()},
      {"[recorder]", recorder_key_rows()},
      {"[entry_limits]", entry_limits_key_rows()},
      {"[process]", process_key_rows()},
      {"[simulation]", describe(simulation_keys())},
      {"[simulation.cutting]", cutting_key_rows()},
      {"[[simulation.cutting.stock]]", stock_key_rows()},
      {"[[simulation.tool]]", real_tool_key_rows()},
      {"[simulation.tool_setter]", tool_setter_key_rows()},
      {"[[contact]]", contact_key_rows()},
      {"[[tool]] of the tables file", tool_key_rows()},
      {"process file of stanok grind", grinding_key_rows()},
      {"[[burn]] of a process file of stanok grind", burn_key_rows()},
      {"file of stanok process lobes", chatter_key_rows()},
      {"[[mode_x]] and [[mode_y]] of a file of stanok process lobes", vibration_mode_key_rows()},
  };
  const std::vector<KeySection> geometries = geometry_sections();
  const auto parked = std::ranges::find(sections, "[[parked]] of a scheme", &KeySection::title);
  sections.insert(parked, geometries.begin(), geometries.end());
  return sections;
}

std::string to_markdown(const KeySection& section) {
  std::string text = "### `" + section.title + "`\n\n";
  text += "| key | kind | unit | default | values | meaning |\n|---|---|---|---|---|---|\n";
  const auto cell = [](const std::string& content) { return content.empty() ? "–" : content; };
  for (const KeyRow& row : section.rows) {
    text += "| `" + row.name + "` | " + row.kind + " | " + cell(row.unit) + " | " + row.initial +
            " | " + cell(row.allowed) + " | " + row.meaning + " |\n";
  }
  return text;
}

}  // namespace stanok::config
