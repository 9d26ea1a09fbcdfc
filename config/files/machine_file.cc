// Assembles a MachineFile from its tables and the files it names.
#include "config/files/machine_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/place.h"
#include "config/files/tables_file.h"
#include "config/sections/axis_section.h"
#include "config/sections/channel_section.h"
#include "config/sections/contact_section.h"
#include "config/sections/machine_sections.h"
#include "config/sections/probing_section.h"
#include "config/sections/process_section.h"
#include "config/sections/signal_section.h"
#include "config/sections/vibration_section.h"
#include "config/text/text_encoding.h"

namespace stanok::config {
namespace {

// The tables at the top of the file.
struct TopLevel {
  Subtable machine = nullptr;
  Subtables axes = nullptr;
  Subtables spindles = nullptr;
  Subtables channels = nullptr;
  Subtable drives = nullptr;
  Subtables signals = nullptr;
  Subtables vibration_sensors = nullptr;
  Subtable lcm = nullptr;
  Subtable recorder = nullptr;
  Subtable entry_limits = nullptr;
  Subtable process = nullptr;
  Subtable simulation = nullptr;
  Subtables contacts = nullptr;
};

const Keys<TopLevel>& top_level_keys() {
  static const Keys<TopLevel> keys = {
      {"machine", at<&TopLevel::machine>, required, "", "[machine] with the name of the machine"},
      {"axis", at<&TopLevel::axes>, optional, "", "one [[axis]] for each axis"},
      {"spindle", at<&TopLevel::spindles>, optional, "", "one [[spindle]] for each spindle"},
      {"channel", at<&TopLevel::channels>, required, "", "one [[channel]] for each channel"},
      {"drives", at<&TopLevel::drives>, optional, "", "bus of the drives"},
      {"signal", at<&TopLevel::signals>, optional, "",
       "one [[signal]] for each input or output of programs on the bus"},
      {"vibration_sensor", at<&TopLevel::vibration_sensors>, optional, "",
       "one [[vibration_sensor]] for each sensor that delivers samples"},
      {"lcm", at<&TopLevel::lcm>, optional, "", "publishing"},
      {"recorder", at<&TopLevel::recorder>, optional, "", "log files"},
      {"entry_limits", at<&TopLevel::entry_limits>, optional, "",
       "limits of tool and work offset values and of their changes"},
      {"process", at<&TopLevel::process>, optional, "", "force control"},
      {"simulation", at<&TopLevel::simulation>, optional, "", "plant of the simulated drives"},
      {"contact", at<&TopLevel::contacts>, optional, "",
       "one [[contact]] for each input that the position of a simulated axis switches"},
  };
  return keys;
}

// Whether both write the same register.
bool share_a_register(const drives::RegisterMap& one, const drives::RegisterMap& other) {
  return std::ranges::any_of(drives::written_fields, [&](drives::FieldOfMap of_one) {
    return std::ranges::any_of(drives::written_fields, [&](drives::FieldOfMap of_other) {
      const drives::RegisterField& a = one.*of_one;
      const drives::RegisterField& b = other.*of_other;
      return a.exists() && b.exists() && a.address < b.end() && b.address < a.end();
    });
  });
}

class MachineReader {
 public:
  MachineReader(const std::filesystem::path& path, FaultList& faults)
      : folder_(path.parent_path()), faults_(faults) {
    file_.path = path;
    file_.machine.file = path.string();
  }

  MachineFile read(const toml::table& root) {
    read_table(root, top_level_keys(), top_, Scope{faults_, "machine file"});
    const std::vector<AxisSection> axes = read_axes(top_.axes, Scope{faults_, "machine file"});
    for (const AxisSection& section : axes) {
      file_.machine.axes.push_back(section.axis);
      file_.axis_plants.push_back(section.plant);
    }
    if (names_are_right(axes)) read_users_of_axes(root, axes);
    file_.contacts =
        read_contacts(top_.contacts, file_.machine.axes, Scope{faults_, "machine file"});
    read_machine();
    read_drives(axes);
    for (channels::AxisConfig& axis : file_.machine.axes)
      axis.controller.demand_held_s = file_.bus.poll_ms * 1e-3;
    read_services();
    return std::move(file_);
  }

 private:
  // A wrong name is one fault, not one more wherever it is used: these wait until names are right.
  void read_users_of_axes(const toml::table& root, const std::vector<AxisSection>& axes) {
    const Scope scope{faults_, "machine file"};
    spindles_ = read_spindles(top_.spindles, axes, scope);
    for (const SpindleSection& section : spindles_)
      file_.machine.spindles.push_back(section.spindle);
    if (root.contains("spindle") && top_.spindles == nullptr) return;
    file_.machine.channels = read_channels(top_.channels, file_.machine, folder_, scope);
  }

  void read_machine() {
    if (top_.machine == nullptr) return;
    const Scope scope{faults_, "[machine]"};
    MachineSection section;
    read_table(*top_.machine, machine_keys(), section, scope);
    file_.machine.name = section.name;
    file_.machine.cycle_us = section.cycle_us;
    file_.machine.stop_time_max_s = section.stop_time_max_s;
    file_.machine.catch_up_max = section.catch_up_max;
    file_.machine.request_age_max_s = section.request_age_max_s;
    file_.machine.retrace_memory_mb = section.retrace_memory_mb;
    file_.machine.first_run = section.first_run;
    set_stop_limits(section.stop_limits);
    file_.machine.tables_write_protected = section.tables_write_protected;
    file_.machine.program_bounds = {
        .bytes = checked_size(section.program_size_max_mb) << 20,
        .steps = static_cast<std::uint64_t>(section.program_steps_max_m) * 1'000'000};
    if (!section.program_encoding.empty() && !is_encoding_of_programs(section.program_encoding)) {
      scope.fault(
          place_of(*top_.machine, "program_encoding"),
          "`" + section.program_encoding +
              "` is not a known encoding that contains ASCII; `iconv --list` shows the names");
    }
    file_.machine.program_encoding = section.program_encoding;
    if (!section.tables.empty()) read_tables_named(section.tables, scope);
  }

  // Of axes that name none of their own.
  void set_stop_limits(double stop_limits) {
    for (std::size_t i = 0; i < file_.machine.axes.size(); ++i) {
      if (top_.axes->get(i)->as_table()->contains("stop_limits")) continue;
      file_.machine.axes[i].limits.stop_limits = stop_limits;
    }
  }

  void read_tables_named(const std::string& name, const Scope& scope) {
    const std::filesystem::path tables = resolved(name);
    if (!faults_.is_file(tables)) {
      scope.fault(place_of(*top_.machine, "tables"),
                  "tables file '" + tables.string() +
                      "' does not exist; its path is relative to the machine file");
      return;
    }
    file_.machine.tables = read_tables(tables, names_of_axes(file_.machine), faults_);
    file_.machine.unnamed_tools = file_.machine.tables.tools.empty();
    check_reference_points(tables);
  }

  void check_reference_points(const std::filesystem::path& tables) {
    const auto& known = file_.machine.channels;
    if (known.empty()) return;  // a fault that is told already
    for (const auto& [id, points] : file_.machine.tables.reference_points) {
      if (std::ranges::find(known, id, &channels::ChannelConfig::id) != known.end()) continue;
      faults_.add(tables, "[reference_point." + std::to_string(id) +
                              "]: the machine has no channel " + std::to_string(id));
    }
  }

  void read_drives(const std::vector<AxisSection>& axes) {
    if (top_.drives == nullptr) return;
    file_.bus = read_bus(*top_.drives, Scope{faults_, "[drives]"});
    for (const AxisSection& section : axes) file_.bus.axes.push_back(section.drive);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const motion::AxisLimits& limits = file_.machine.axes[k].limits;
      file_.bus.axes[k].target_acceleration_max = limits.stop_limits * limits.acceleration_max;
    }
    for (const SpindleSection& section : spindles_) {
      if (section.drive) file_.bus.spindles.push_back(*section.drive);
    }
    file_.bus.signals = read_signals(top_.signals, Scope{faults_, "machine file"});
    file_.bus.vibration_sensors = read_vibration_sensors(top_.vibration_sensors, file_.bus.poll_ms,
                                                         Scope{faults_, "machine file"});
    check_addresses();
    check_watchdogs();
    check_dead_times();
  }

  // [[axis]] or [[spindle]] of a drive of the bus; the first one when its name is at fault.
  [[nodiscard]] const toml::table& table_of(const drives::AxisDriveConfig& drive) const {
    const bool is_axis = drive.spindle == 0;
    const toml::array& tables = is_axis ? *top_.axes : *top_.spindles;
    for (const toml::node& node : tables) {
      const toml::table& table = *node.as_table();
      const bool is_it = is_axis ? table["name"].value_or(std::string()) == drive.axis
                                 : table["id"].value_or(0) == drive.spindle;
      if (is_it) return table;
    }
    return *tables.get(0)->as_table();
  }

  [[nodiscard]] const toml::source_region& place_in_drive(const drives::AxisDriveConfig& drive,
                                                          std::string_view key) const {
    const toml::table& owner = table_of(drive);
    const toml::table* const own = owner["drive"].as_table();
    return own == nullptr ? owner.source() : place_of(*own, key);
  }

  [[nodiscard]] Scope scope_of(const drives::AxisDriveConfig& drive) const {
    return {faults_,
            drive.spindle == 0 ? "axis " + drive.axis : "spindle " + std::to_string(drive.spindle)};
  }

  void check_addresses() {
    const std::vector<drives::AxisDriveConfig> drives = drives_of(file_.bus);
    for (std::size_t i = 0; i < drives.size(); ++i) {
      for (std::size_t earlier = 0; earlier < i; ++earlier) {
        const auto& drive = drives[i];
        const auto& other = drives[earlier];
        if (drive.unit != other.unit || !share_a_register(drive.map, other.map)) continue;
        scope_of(drive).fault(place_of(table_of(drive), "drive"),
                              "its drive has the address of " +
                                  std::string(other.spindle == 0 ? "axis " : "spindle ") +
                                  other.axis + ", " + std::to_string(drive.unit) +
                                  "; give this drive its own address or registers");
      }
    }
  }

  // The control must notice a loss of contact and stop along the path before the drive stops by
  // itself.
  void check_watchdogs() {
    for (const drives::AxisDriveConfig& drive : drives_of(file_.bus)) {
      if (drive.watchdog_ms == 0 || drive.watchdog_ms > file_.bus.timeout_ms) continue;
      scope_of(drive).fault(
          place_in_drive(drive, "watchdog_ms"),
          "E7010 watchdog_ms is " + std::to_string(drive.watchdog_ms) +
              "; it must be longer than timeout_ms of [drives], " +
              std::to_string(file_.bus.timeout_ms) +
              ", or the drive stops before the control notices the loss of contact");
    }
  }

  // The current position is up to a poll old, and U acts a cycle later. A proportional loop has 90
  // deg of phase at its gain of 1 and loses kp times the dead time; 60 deg must be left.
  void check_dead_times() {
    const double dead_time_s = file_.bus.poll_ms * 1e-3 + file_.machine.cycle_us * 1e-6;
    const double kp_max = std::numbers::pi / 6.0 / dead_time_s;
    for (std::size_t i = 0; i < file_.machine.axes.size(); ++i) {
      const channels::AxisConfig& axis = file_.machine.axes[i];
      const bool in_cycle = axis.controller.feedback == channels::FeedbackPlace::cycle;
      if (!in_cycle || axis.controller.gains.kp <= kp_max) continue;
      const toml::table& controller =
          *top_.axes->get(i)->as_table()->get("position_controller")->as_table();
      Scope{faults_, "axis " + axis.name + ": position_controller"}.fault(
          place_of(controller, "kp"),
          "kp is " + number_text(axis.controller.gains.kp) + "; with poll_ms = " +
              std::to_string(file_.bus.poll_ms) + " the loop is well damped up to about " +
              number_text(std::floor(kp_max)) + "; poll more often, or lower kp");
    }
  }

  void read_services() {
    if (top_.lcm != nullptr) file_.lcm_url = read_lcm_url(*top_.lcm, Scope{faults_, "[lcm]"});
    file_.machine.entry_limits =
        read_entry_limits(top_.entry_limits, file_.machine, Scope{faults_, "[entry_limits]"});
    if (top_.recorder != nullptr) {
      file_.recorder = read_recorder(*top_.recorder, Scope{faults_, "[recorder]"});
      if (!file_.recorder.directory.empty()) {
        file_.recorder.directory = resolved(file_.recorder.directory);
      }
    }
    if (top_.process != nullptr) {
      file_.process = read_process(*top_.process, file_.machine, Scope{faults_, "[process]"});
    }
    if (top_.simulation != nullptr) {
      const Scope scope{faults_, "[simulation]"};
      SimulationSection section;
      read_table(*top_.simulation, simulation_keys(), section, scope);
      file_.simulation = section.simulation;
      if (section.cutting != nullptr)
        file_.simulation.cutting =
            read_cutting(*section.cutting, file_.machine, scope.inner("cutting"));
      file_.simulation.tools = read_real_tools(section.tools, file_.machine, scope);
      if (section.setter != nullptr)
        file_.simulation.setter =
            read_tool_setter(*section.setter, file_.machine, scope.inner("tool_setter"));
    }
  }

  [[nodiscard]] std::filesystem::path resolved(const std::filesystem::path& name) const {
    return (folder_ / name).lexically_normal();
  }

  std::filesystem::path folder_;
  FaultList& faults_;
  TopLevel top_;
  MachineFile file_;
  std::vector<SpindleSection> spindles_;
};

}  // namespace

namespace {

MachineFile read_machine(const std::filesystem::path& path, FaultList faults) {
  MachineFile file;
  if (const auto text = read_text(path, faults)) {
    if (const auto root = parse_text(with_active_scheme_key(*text), path, faults)) {
      file = MachineReader(path, faults).read(*root);
    }
  }
  faults.throw_if_any();
  file.sources = std::move(faults.sources());
  return file;
}

}  // namespace

MachineFile read_machine_file(const std::filesystem::path& path) {
  return read_machine(path, {});
}

MachineFile read_machine_sources(std::vector<SourceFile> sources) {
  const std::filesystem::path path = sources.empty() ? "" : sources.front().path;
  return read_machine(path, FaultList(std::move(sources)));
}

}  // namespace stanok::config
