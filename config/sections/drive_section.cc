// Keys of a drive, and what a drive of each kind cannot do without.
#include "config/sections/drive_section.h"

#include <algorithm>
#include <array>

#include "config/sections/register_section.h"

namespace stanok::config {
namespace {

using drives::AxisDriveConfig;
using drives::DriveKind;
using drives::RegisterField;
using drives::RegisterMap;
using drives::RequestStyle;
using drives::RunWords;
using drives::StandardMap;

// The keys as they stand in the file.
struct DriveFile {
  DriveSection section;
  std::string kind;
  std::string write = "fc23";
  Subtable registers = nullptr;
  Subtable scales = nullptr;
  Subtable map = nullptr;
  Subtable bits = nullptr;
  Subtable words = nullptr;
};

template <auto Member>
inline constexpr auto of_drive = at<&DriveFile::section, &DriveSection::drive, Member>;

const Keys<DriveFile>& drive_keys() {
  static const Keys<DriveFile> keys = {
      {"address", of_drive<&AxisDriveConfig::unit>, optional, "", "Modbus unit of the drive",
       from(1, 247), "number of the axis in the file; spindle n: 200 + n"},
      {"kind", at<&DriveFile::kind>, optional, "",
       "what the drive follows: a position, a velocity, or only the command to run (spindles)",
       one_of({"position", "velocity", "on_off"}),
       "position; velocity where the cycle closes the loop and for spindles"},
      {"write", at<&DriveFile::write>, optional, "",
       "Modbus function that writes registers: 23 (together with a read), 16, or 6 (one by one)",
       one_of({"fc23", "fc16", "fc06"})},
      {"read_gap", of_drive<&AxisDriveConfig::gap_max>, optional, "",
       "number of unused registers that may be read to save a request", from(0, 100)},
      {"registers", at<&DriveFile::registers>, optional, "",
       "first registers of the blocks of the standard map: control, status"},
      {"scales", at<&DriveFile::scales>, optional, "",
       "units of the registers: position, velocity"},
      {"map", at<&DriveFile::map>, optional, "",
       "registers of a drive with a different map, quantity by quantity"},
      {"bits", at<&DriveFile::bits>, optional, "", "positions of bits in its words"},
      {"words", at<&DriveFile::words>, optional, "",
       "control words of a drive that does not speak CiA 402"},
      {"watchdog_ms", of_drive<&AxisDriveConfig::watchdog_ms>, optional, "ms",
       "time without a request after which the drive stops by itself, as set in the drive; longer "
       "than timeout_ms of [drives]; 0: not known",
       from(0, 60000)},
      {"brake_time", at<&DriveFile::section, &DriveSection::brake_s>, optional, "s",
       "time that the brake takes to close or open", not_negative},
      {"power_time", at<&DriveFile::section, &DriveSection::power_s>, optional, "s",
       "time that the drive takes to take over the axis", not_negative},
  };
  return keys;
}

const Keys<StandardMap>& register_keys() {
  static const Keys<StandardMap> keys = {
      {"control", at<&StandardMap::control>, optional, "",
       "first register of the block written in every exchange", from(0, 65500)},
      {"status", at<&StandardMap::status>, optional, "",
       "first register of the block read in every exchange", from(0, 65500)},
  };
  return keys;
}

const Keys<StandardMap>& scale_keys() {
  static const Keys<StandardMap> keys = {
      {"position", at<&StandardMap::position_scale>, optional, "1/mm, 1/deg",
       "increments of the position registers", positive},
      {"velocity", at<&StandardMap::velocity_scale>, optional, "s/mm, s/deg",
       "increments of the velocity registers", positive},
  };
  return keys;
}

// [axis.drive.words]
struct WordFile {
  int stop = 0;
  int run = 0;
  int run_reverse = -1;
  int reset = -1;
  Integers running;
  Integers fault;
};

const Keys<WordFile>& word_keys() {
  static const Keys<WordFile> keys = {
      {"stop", at<&WordFile::stop>, required, "", "control word that stops the drive",
       from(0, 65535)},
      {"run", at<&WordFile::run>, required, "", "control word that lets the drive run",
       from(0, 65535)},
      {"run_reverse", at<&WordFile::run_reverse>, optional, "",
       "control word that lets the drive run backwards; the velocity is then written without a "
       "sign",
       from(0, 65535), "none"},
      {"reset", at<&WordFile::reset>, optional, "", "control word that clears a fault",
       from(0, 65535), "none"},
      {"running", at<&WordFile::running>, optional, "",
       "[mask, value]: the drive runs when the masked status word has this value", any},
      {"fault", at<&WordFile::fault>, optional, "",
       "[mask, value]: the drive has a fault when the masked status word has this value", any},
  };
  return keys;
}

drives::StatusPattern pattern_of(const toml::table& table, const char* key, const Integers& numbers,
                                 const Scope& scope) {
  if (numbers.empty()) return {};
  const bool are_words =
      std::ranges::all_of(numbers, [](int number) { return number >= 0 && number <= 65535; });
  if (numbers.size() != 2 || !are_words || numbers[0] == 0 || (numbers[1] & ~numbers[0]) != 0) {
    scope.fault(place_of(table, key), std::string(key) +
                                          " must be [mask, value]: a word that is not 0, and the "
                                          "value of its bits");
    return {};
  }
  return {.mask = static_cast<std::uint16_t>(numbers[0]),
          .value = static_cast<std::uint16_t>(numbers[1])};
}

std::optional<std::uint16_t> word_of(int number) {
  if (number < 0) return std::nullopt;
  return static_cast<std::uint16_t>(number);
}

RunWords read_words(const toml::table& table, const Scope& scope) {
  WordFile file;
  read_table(table, word_keys(), file, scope);
  return {.stop = static_cast<std::uint16_t>(file.stop),
          .run = static_cast<std::uint16_t>(file.run),
          .run_reverse = word_of(file.run_reverse),
          .fault_reset = word_of(file.reset),
          .running = pattern_of(table, "running", file.running, scope),
          .fault = pattern_of(table, "fault", file.fault, scope)};
}

RequestStyle request_style(const std::string& write) {
  if (write == "fc16") return RequestStyle::write_multiple;
  return write == "fc06" ? RequestStyle::write_single : RequestStyle::write_and_read;
}

RegisterMap read_map(const DriveFile& file, DriveLoad load, const Scope& scope) {
  StandardMap standard;
  if (load == DriveLoad::spindle) standard.velocity_scale = 1.0;
  if (file.registers != nullptr)
    read_table(*file.registers, register_keys(), standard, scope.inner("registers"));
  if (file.scales != nullptr)
    read_table(*file.scales, scale_keys(), standard, scope.inner("scales"));
  RegisterMap map = drives::register_map(standard);
  if (file.map != nullptr) map = read_register_map(*file.map, map, scope.inner("map"));
  if (file.words != nullptr) clear_own_bits(map.bits);
  if (file.bits != nullptr) read_drive_bits(*file.bits, map.bits, scope.inner("bits"));
  return map;
}

void require(const RegisterField& field, const char* name, const char* why, const toml::table& map,
             const Scope& scope) {
  if (field.exists()) return;
  scope.fault(map.source(), std::string(name) + " is missing; " + why);
}

// What a drive of its kind must have.
void check_map(const toml::table& table, const AxisDriveConfig& drive, DriveLoad load,
               const Scope& scope) {
  const RegisterMap& map = drive.map;
  require(map.control_word, "control_word", "every drive needs a command to run and to stop", table,
          scope);
  if (drive.kind == DriveKind::on_off) return;
  require(map.status_word, "status_word", "the drive must report whether it runs", table, scope);
  if (drive.kind == DriveKind::position) {
    require(map.target_position, "target_position", "a position drive follows it", table, scope);
  } else {
    require(map.target_velocity, "target_velocity", "a velocity drive follows it", table, scope);
  }
  if (load == DriveLoad::axis)
    require(map.position, "position", "an axis must report its position", table, scope);
}

void check_written_fields(const toml::table& table, const AxisDriveConfig& drive,
                          const Scope& scope) {
  const auto& fields = drives::written_fields;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const RegisterField& field = drive.map.*fields[k];
    if (!field.exists()) continue;
    if (field.words == 2 && drive.requests == RequestStyle::write_single) {
      scope.fault(place_of(table, "write"),
                  "fc06 writes one register at a time, which splits a value of 32 bits; use fc16, "
                  "or a target of 16 bits");
    }
    for (std::size_t earlier = 0; earlier < k; ++earlier) {
      const RegisterField& other = drive.map.*fields[earlier];
      if (!other.exists() || field.address >= other.end() || other.address >= field.end()) continue;
      scope.fault(place_of(table, "map"),
                  "two written values share register " +
                      std::to_string(std::max(field.address, other.address)) +
                      "; give each its own");
    }
  }
}

// A spindle has no brake, and nobody waits for its drive to take it over.
void refuse_axis_keys(const toml::table& table, const Scope& scope) {
  for (const char* key : {"brake_time", "power_time"}) {
    if (table.contains(key))
      scope.fault(place_of(table, key), std::string(key) + " belongs to an axis; remove it");
  }
}

void take_kind(const toml::table& table, const std::string& kind, DriveLoad load,
               AxisDriveConfig& drive, const Scope& scope) {
  if (kind.empty()) return;
  const DriveKind given = kind == "position"   ? DriveKind::position
                          : kind == "velocity" ? DriveKind::velocity
                                               : DriveKind::on_off;
  if (load == DriveLoad::spindle && given == DriveKind::position) {
    scope.fault(place_of(table, "kind"), "a spindle follows a velocity, or is on or off");
  } else if (load == DriveLoad::axis && given != drive.kind) {
    scope.fault(place_of(table, "kind"),
                given == DriveKind::on_off
                    ? "a drive that only runs or stops cannot move an axis; it may drive a spindle"
                    : "kind and [axis.position_controller] feedback differ: feedback = \"drive\" "
                      "goes with a "
                      "position drive, \"cycle\" with a velocity drive");
  } else {
    drive.kind = given;
  }
}

}  // namespace

void read_drive(const toml::table& table, DriveLoad load, DriveSection& section,
                const Scope& scope) {
  DriveFile file{.section = section, .kind = "", .write = "fc23"};
  read_table(table, drive_keys(), file, scope);
  section = file.section;
  AxisDriveConfig& drive = section.drive;
  take_kind(table, file.kind, load, drive, scope);
  drive.requests = request_style(file.write);
  if (file.map != nullptr && file.registers != nullptr) {
    scope.fault(place_of(table, "registers"),
                "registers belongs to the standard map; remove registers or map");
  }
  drive.map = read_map(file, load, scope);
  if (file.words != nullptr) drive.words = read_words(*file.words, scope.inner("words"));
  if (file.map != nullptr) check_map(*file.map, drive, load, scope.inner("map"));
  check_written_fields(table, drive, scope);
  if (load == DriveLoad::spindle) refuse_axis_keys(table, scope);
}

std::vector<KeyRow> drive_key_rows() {
  std::vector<KeyRow> rows = describe(drive_keys());
  const auto append = [&](const char* table, std::vector<KeyRow> inner) {
    for (KeyRow& row : inner) {
      row.name = std::string(table) + "." + row.name;
      rows.push_back(std::move(row));
    }
  };
  append("registers", describe(register_keys()));
  append("scales", describe(scale_keys()));
  return rows;
}

std::vector<KeyRow> run_word_key_rows() {
  return describe(word_keys());
}

}  // namespace stanok::config
