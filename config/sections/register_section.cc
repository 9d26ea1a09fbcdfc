// The quantities of a register map by name, and the keys of a field.
#include "config/sections/register_section.h"

#include <array>

namespace stanok::config {
namespace {

using drives::DriveBits;
using drives::FieldOfMap;
using drives::RegisterField;
using drives::RegisterMap;

struct Quantity {
  std::string_view name;
  FieldOfMap field;
  std::string_view unit;
  std::string_view meaning;
};

// Written ones first.
constexpr std::array<Quantity, 17> quantities = {{
    {"control_word", &RegisterMap::control_word, "", "written: control word"},
    {"target_position", &RegisterMap::target_position, "mm, deg", "written: target position"},
    {"target_velocity", &RegisterMap::target_velocity, "mm/s, deg/s, rev/min",
     "written: target velocity"},
    {"heartbeat", &RegisterMap::heartbeat, "",
     "written: heartbeat that changes with every exchange"},
    {"status_word", &RegisterMap::status_word, "", "status word"},
    {"position", &RegisterMap::position, "mm, deg", "actual position"},
    {"velocity", &RegisterMap::velocity, "mm/s, deg/s, rev/min", "actual velocity"},
    {"following_error", &RegisterMap::following_error, "mm, deg",
     "setpoint of the drive minus its position"},
    {"power", &RegisterMap::power, "W", "electrical power"},
    {"vibration", &RegisterMap::vibration, "um", "amplitude of vibration"},
    {"vibration_frequency", &RegisterMap::vibration_frequency, "Hz", "frequency of vibration"},
    {"fault_code", &RegisterMap::fault_code, "", "number of the fault; 0: none"},
    {"heartbeat_echo", &RegisterMap::heartbeat_echo, "",
     "heartbeat of the exchange; without it, a drive that answers with old values is not noticed"},
    {"inputs", &RegisterMap::inputs, "", "word with the bits of the switches"},
    {"index_position", &RegisterMap::index_position, "mm, deg",
     "position latched at the last index pulse"},
    {"index_count", &RegisterMap::index_count, "", "number of index pulses so far"},
    {"temperature", &RegisterMap::temperature, "deg C", "temperature of the motor"},
}};

struct FieldFile {
  int address = 0;
  int width = 16;
  bool is_signed = false;
  std::string order = "high_first";
  double scale = 1.0;
  double offset = 0.0;
};

const Keys<FieldFile>& field_keys() {
  static const Keys<FieldFile> keys = {
      {"address", at<&FieldFile::address>, required, "", "holding register, counted from 0",
       from(0, 65535)},
      {"width", at<&FieldFile::width>, optional, "bit", "16, or 32 over two registers",
       from(16, 32), "of the standard map"},
      {"signed", at<&FieldFile::is_signed>, optional, "",
       "whether 16 bits are two's complement; 32 bits always are", any, "of the standard map"},
      {"order", at<&FieldFile::order>, optional, "", "which word of 32 bits comes first",
       one_of({"high_first", "low_first"})},
      {"scale", at<&FieldFile::scale>, optional, "1/unit",
       "increments per unit; negative: counts the other way", any, "of the standard map"},
      {"offset", at<&FieldFile::offset>, optional, "", "increments at position 0"},
  };
  return keys;
}

struct BitFile {
  int close_brake = -1;
  int follow_velocity = -1;
  int brake_closed = -1;
  int referenced = -1;
  int limit_negative = -1;
  int limit_positive = -1;
  int home_switch = -1;
};

struct Bit {
  std::string_view name;
  int& (*slot)(BitFile&);
  std::uint16_t DriveBits::* mask;
  std::string_view meaning;
  std::string_view initial;
};

const std::array<Bit, 7>& drive_bits() {
  static const std::array<Bit, 7> bits = {{
      {"close_brake", at<&BitFile::close_brake>, &DriveBits::close_brake,
       "control word: close the brake", "11; with map or words: -1"},
      {"follow_velocity", at<&BitFile::follow_velocity>, &DriveBits::follow_velocity,
       "control word: follow the target velocity instead of the position",
       "12; with map or words: -1"},
      {"brake_closed", at<&BitFile::brake_closed>, &DriveBits::brake_closed,
       "status word: the brake is closed", "14; with map or words: -1"},
      {"referenced", at<&BitFile::referenced>, &DriveBits::referenced,
       "status word: the drive is referenced; -1: always, with an absolute encoder",
       "15; with map or words: -1"},
      {"limit_negative", at<&BitFile::limit_negative>, &DriveBits::limit_negative,
       "inputs: limit switch at the negative end", "0"},
      {"limit_positive", at<&BitFile::limit_positive>, &DriveBits::limit_positive,
       "inputs: limit switch at the positive end", "1"},
      {"home_switch", at<&BitFile::home_switch>, &DriveBits::home_switch, "inputs: home switch",
       "2"},
  }};
  return bits;
}

const Keys<BitFile>& bit_keys() {
  static const Keys<BitFile> keys = [] {
    Keys<BitFile> made;
    for (const Bit& bit : drive_bits())
      made.push_back({bit.name, bit.slot, optional, "", bit.meaning, from(-1, 15), bit.initial});
    return made;
  }();
  return keys;
}

void check_field(const toml::table& table, const FieldFile& file, const Scope& scope) {
  if (file.width != 16 && file.width != 32) {
    scope.fault(place_of(table, "width"),
                "width is " + std::to_string(file.width) + "; it must be 16 or 32 bits");
  }
  if (file.scale == 0.0)
    scope.fault(place_of(table, "scale"), "scale is 0; write the number of increments per unit");
  if (file.width == 32 && file.address == 65535) {
    scope.fault(place_of(table, "address"),
                "address is 65535; a value of 32 bits has no second register after it");
  }
}

RegisterField read_field(const toml::table& table, const RegisterField& standard,
                         const Scope& scope) {
  FieldFile file{.width = 16 * standard.words,
                 .is_signed = standard.is_signed,
                 .scale = standard.scale,
                 .offset = standard.offset};
  read_table(table, field_keys(), file, scope);
  check_field(table, file, scope);
  return {.address = file.address,
          .words = file.width == 32 ? 2 : 1,
          .is_signed = file.is_signed,
          .order = file.order == "low_first" ? drives::WordOrder::low_first
                                             : drives::WordOrder::high_first,
          .scale = file.scale == 0.0 ? 1.0 : file.scale,
          .offset = file.offset};
}

}  // namespace

RegisterMap read_register_map(const toml::table& table, const RegisterMap& standard,
                              const Scope& scope) {
  RegisterMap map;
  std::vector<std::string_view> names;
  for (const Quantity& quantity : quantities) {
    names.push_back(quantity.name);
    const toml::node* node = table.get(quantity.name);
    if (node == nullptr) continue;
    const Scope inner = scope.inner(std::string(quantity.name));
    if (const toml::table* field = node->as_table()) {
      map.*quantity.field = read_field(*field, standard.*quantity.field, inner);
    } else {
      inner.fault(node->source(),
                  "write a table, as { address = 100 } (" + std::string(quantity.meaning) + ")");
    }
  }
  refuse_unknown_keys(table, names, scope);
  map.bits = standard.bits;
  clear_own_bits(map.bits);
  return map;
}

void clear_own_bits(DriveBits& bits) {
  bits.close_brake = bits.follow_velocity = 0;
  bits.brake_closed = bits.referenced = 0;
}

void read_drive_bits(const toml::table& table, DriveBits& bits, const Scope& scope) {
  BitFile file;
  read_table(table, bit_keys(), file, scope);
  for (const Bit& bit : drive_bits()) {
    if (!table.contains(bit.name)) continue;
    const int place = bit.slot(file);
    bits.*bit.mask = place < 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(1U << place);
  }
}

std::vector<KeyRow> register_map_key_rows() {
  std::vector<KeyRow> rows;
  rows.reserve(quantities.size());
  for (const Quantity& quantity : quantities) {
    rows.push_back({.name = std::string(quantity.name),
                    .kind = "table",
                    .unit = std::string(quantity.unit),
                    .initial = "none",
                    .allowed = "",
                    .meaning = std::string(quantity.meaning)});
  }
  return rows;
}

std::vector<KeyRow> register_field_key_rows() {
  return describe(field_keys());
}

std::vector<KeyRow> drive_bit_key_rows() {
  return describe(bit_keys());
}

}  // namespace stanok::config
