// Keys and checks of the single tables of the machine file.
#include "config/sections/machine_sections.h"

#include <algorithm>

namespace stanok::config {
namespace {

using drives::BusConfig;

struct BusFile {
  BusConfig bus;
  std::string kind;
};

struct LcmFile {
  std::string url = MachineFile{}.lcm_url;
};

struct RecorderFile {
  std::string directory;
  int size_mb = RecorderConfig{}.size_mb;
  double flight_s = RecorderConfig{}.flight_s;
  double logs_max_gb = RecorderConfig{}.logs_max_gb;
  double logs_max_days = RecorderConfig{}.logs_max_days;
  double free_space_min_gb = RecorderConfig{}.free_space_min_gb;
};

const Keys<BusFile>& bus_keys() {
  static const Keys<BusFile> keys = {
      {"bus", at<&BusFile::kind>, required, "", "kind of bus",
       one_of({"modbus-tcp", "modbus-rtu"})},
      {"host", at<&BusFile::bus, &BusConfig::host>, optional, "",
       "modbus-tcp: address of the drives"},
      {"port", at<&BusFile::bus, &BusConfig::port>, optional, "", "modbus-tcp: port",
       from(1, 65535)},
      {"device", at<&BusFile::bus, &BusConfig::device>, optional, "",
       "modbus-rtu: serial device, required"},
      {"baud", at<&BusFile::bus, &BusConfig::baud>, optional, "1/s", "modbus-rtu: bits per second",
       from(1200, 4e6)},
      {"poll_ms", at<&BusFile::bus, &BusConfig::poll_ms>, optional, "ms",
       "time between two exchanges", from(1, 1000)},
      {"timeout_ms", at<&BusFile::bus, &BusConfig::timeout_ms>, optional, "ms",
       "time without a valid answer after which a drive counts as lost", from(1, 60000)},
  };
  return keys;
}

const Keys<LcmFile>& lcm_keys() {
  static const Keys<LcmFile> keys = {
      {"url", at<&LcmFile::url>, required, "", "where setpoints and states are published"},
  };
  return keys;
}

const Keys<RecorderFile>& recorder_keys() {
  static const Keys<RecorderFile> keys = {
      {"directory", at<&RecorderFile::directory>, optional, "", "where logs are written", any,
       "in the state directory"},
      {"size_mb", at<&RecorderFile::size_mb>, optional, "MB",
       "size at which the next log file begins; at most a quarter of logs_max_gb", from(1, 1e6)},
      {"flight_s", at<&RecorderFile::flight_s>, optional, "s",
       "length of the record that is kept in memory and written to a file when a fault stops the "
       "machine; 0: none",
       from(0, 600)},
      {"logs_max_gb", at<&RecorderFile::logs_max_gb>, optional, "GB",
       "total size of the logs and flight files of the machine; the oldest are removed; 0: no "
       "limit",
       from(0, 1e6)},
      {"logs_max_days", at<&RecorderFile::logs_max_days>, optional, "d",
       "age above which they are removed; 0: no limit", from(0, 36500)},
      {"free_space_min_gb", at<&RecorderFile::free_space_min_gb>, optional, "GB",
       "space that they leave free on their disk: the oldest are removed, and if that is not "
       "enough, nothing is logged; 0: none",
       from(0, 1e6)},
  };
  return keys;
}

const Keys<channels::EntryLimits>& entry_limits_keys() {
  using Limits = channels::EntryLimits;
  static const Keys<Limits> keys = {
      {"touch_off_max", at<&Limits::touch_off_max>, optional, "mm, deg",
       "touching off that changes a work offset or tool length by more than this must be confirmed",
       not_negative},
      {"change_max", at<&Limits::change_max>, optional, "mm, deg",
       "a new value of a work offset or tool length other than 0 that changes it by more than this "
       "must be confirmed",
       not_negative},
      {"change_in_run_max", at<&Limits::change_in_run_max>, optional, "mm, deg",
       "largest change of the wear of a tool or of a work offset while a program runs; a larger "
       "one, and one of another value, is refused (E6101); 0: no change",
       not_negative},
      {"tool_length_min", at<&Limits::tool_length_min_mm>, optional, "mm",
       "smallest length of a tool along Z; lengths that are measured against a reference tool may "
       "be negative",
       any, "0; with a lathe channel, whose tools point in both directions, -tool_length_max"},
      {"tool_length_max", at<&Limits::tool_length_max_mm>, optional, "mm",
       "largest length of a tool along Z; largest magnitude of its lengths along X and Y and of "
       "its overhang",
       positive},
      {"tool_radius_max", at<&Limits::tool_radius_max_mm>, optional, "mm",
       "largest radius of a tool", positive},
      {"wear_max", at<&Limits::wear_max_mm>, optional, "mm",
       "largest magnitude of the wear of a length or radius", positive},
      {"offset_max", at<&Limits::offset_max_mm>, optional, "mm",
       "largest magnitude of a work offset along a linear axis; for a rotary axis it is a whole "
       "turn, or its travel",
       positive, "the largest magnitude of min and max of the axis, and tool_length_max"},
  };
  return keys;
}

bool has_lathe(const channels::MachineConfig& machine) {
  return std::ranges::any_of(machine.channels, [](const channels::ChannelConfig& channel) {
    return channel.kind == lang::ChannelKind::lathe;
  });
}

}  // namespace

const Keys<MachineSection>& machine_keys() {
  static const Keys<MachineSection> keys = {
      {"name", at<&MachineSection::name>, required, "",
       "name of the machine, of its files, and on the LCM bus", part_of_path},
      {"cycle_us", at<&MachineSection::cycle_us>, optional, "us", "real-time cycle",
       from(100, 20000)},
      {"catch_up_max", at<&MachineSection::catch_up_max>, optional, "",
       "number of missed periods that are permitted; after more, the path comes to rest",
       from(0, 100)},
      {"stop_limits", at<&MachineSection::stop_limits>, optional, "",
       "multiple of acceleration_max and jerk_max of its axes that a stop may use", from(1.0, 2.0)},
      {"stop_time_max", at<&MachineSection::stop_time_max_s>, optional, "s",
       "time after a stop at which power is removed from axes that still move; 0: twice the time "
       "of the slowest axis or spindle, plus one second",
       from(0.0, 3600.0)},
      {"retrace_memory", at<&MachineSection::retrace_memory_mb>, optional, "MiB",
       "memory of each channel for the path that lies behind, along which the axes of a held "
       "program can go back: 64 MiB hold 100,000 short blocks in five axes; 0: within the block "
       "only",
       from(0, 4096)},
      {"first_run", at<&MachineSection::first_run>, optional, "",
       "limits rapid traverse to 25 % from the load of a program until it has run from its "
       "beginning to its end once; again after every change of its text and every start of the "
       "daemon"},
      {"request_age_max", at<&MachineSection::request_age_max_s>, optional, "s",
       "age above which a command that begins motion is refused", from(0.1, 60.0)},
      {"tables", at<&MachineSection::tables>, optional, "",
       "file with tools and offsets at first start"},
      {"tables_write_protected", at<&MachineSection::tables_write_protected>, optional, "",
       "programs cannot write tools and offsets"},
      {"program_size_max", at<&MachineSection::program_size_max_mb>, optional, "MiB",
       "largest size of a program with all its files", from(1, 4096)},
      {"program_steps_max", at<&MachineSection::program_steps_max_m>, optional, "million",
       "steps that a program may compute without moving, waiting or asking; for check and "
       "interpret, steps of a run",
       from(1, 1'000'000)},
      {"program_encoding", at<&MachineSection::program_encoding>, optional, "",
       "encoding of program files that are not UTF-8, by its name in iconv: cp1251, cp866, "
       "iso-8859-1",
       any, "none: text that is not UTF-8 becomes U+FFFD"},
  };
  return keys;
}

const Keys<SimulationSection>& simulation_keys() {
  static const Keys<SimulationSection> keys = {
      {"drive_frequency", at<&SimulationSection::simulation, &SimulationConfig::drive_frequency_hz>,
       optional, "Hz", "natural frequency of the simulated position loops", positive},
      {"drive_damping", at<&SimulationSection::simulation, &SimulationConfig::drive_damping>,
       optional, "", "their damping", positive},
      {"servo_frequency", at<&SimulationSection::simulation, &SimulationConfig::servo_frequency_hz>,
       optional, "Hz",
       "natural frequency of the simulated velocity loops, of axes with feedback = \"cycle\"",
       positive},
      {"servo_damping", at<&SimulationSection::simulation, &SimulationConfig::servo_damping>,
       optional, "", "their damping", positive},
      {"resonance_frequency",
       at<&SimulationSection::simulation, &SimulationConfig::resonance_frequency_hz>, optional,
       "Hz", "natural frequency of the load on its spring after them; 0: none", not_negative},
      {"resonance_damping",
       at<&SimulationSection::simulation, &SimulationConfig::resonance_damping>, optional, "",
       "its damping", not_negative},
      {"outputs_to_inputs",
       at<&SimulationSection::simulation, &SimulationConfig::outputs_to_inputs>, optional, "",
       "outputs of programs return as inputs with the same number"},
      {"cutting", at<&SimulationSection::cutting>, optional, "", "the cut at the spindle", any,
       "none"},
      {"tool", at<&SimulationSection::tools>, optional, "",
       "one [[simulation.tool]] for each tool that differs from the tables"},
      {"tool_setter", at<&SimulationSection::setter>, optional, "",
       "a disc that switches probe_input when a tool touches it", any, "none"},
  };
  return keys;
}

BusConfig read_bus(const toml::table& table, const Scope& scope) {
  BusFile file;
  read_table(table, bus_keys(), file, scope);
  const bool serial = file.kind == "modbus-rtu";
  file.bus.kind = serial ? drives::BusKind::modbus_rtu : drives::BusKind::modbus_tcp;
  if (serial && file.bus.device.empty()) {
    scope.fault(place_of(table, "bus"),
                "key 'device' is missing; modbus-rtu needs a serial device");
  }
  if (file.bus.timeout_ms < file.bus.poll_ms) {
    scope.fault(place_of(table, "timeout_ms"), "timeout_ms is shorter than poll_ms, " +
                                                   std::to_string(file.bus.poll_ms) +
                                                   "; every drive would count as lost");
  }
  return file.bus;
}

std::string read_lcm_url(const toml::table& table, const Scope& scope) {
  LcmFile file;
  read_table(table, lcm_keys(), file, scope);
  return file.url;
}

RecorderConfig read_recorder(const toml::table& table, const Scope& scope) {
  RecorderFile file;
  read_table(table, recorder_keys(), file, scope);
  return {.directory = file.directory,
          .size_mb = file.size_mb,
          .flight_s = file.flight_s,
          .logs_max_gb = file.logs_max_gb,
          .logs_max_days = file.logs_max_days,
          .free_space_min_gb = file.free_space_min_gb};
}

channels::EntryLimits read_entry_limits(Subtable table, const channels::MachineConfig& machine,
                                        const Scope& scope) {
  channels::EntryLimits limits;
  if (table != nullptr) read_table(*table, entry_limits_keys(), limits, scope);
  const bool has_least = table != nullptr && table->contains("tool_length_min");
  if (!has_least && has_lathe(machine)) limits.tool_length_min_mm = -limits.tool_length_max_mm;
  if (limits.tool_length_min_mm < limits.tool_length_max_mm) return limits;
  scope.fault(place_of(*table, "tool_length_min"),
              "tool_length_min is not less than tool_length_max, " +
                  number_text(limits.tool_length_max_mm));
  return limits;
}

std::vector<KeyRow> drives_key_rows() {
  return describe(bus_keys());
}
std::vector<KeyRow> lcm_key_rows() {
  return describe(lcm_keys());
}
std::vector<KeyRow> recorder_key_rows() {
  return describe(recorder_keys());
}
std::vector<KeyRow> entry_limits_key_rows() {
  return describe(entry_limits_keys());
}

}  // namespace stanok::config
