// The keys of [[signal]] and their checks.
#include "config/sections/signal_section.h"

#include <algorithm>

namespace stanok::config {
namespace {

using drives::RegisterField;
using drives::SignalConfig;
using drives::SignalKind;
using drives::SignalTable;

// The keys as they stand in the file.
struct SignalFile {
  SignalConfig signal{.field = {.address = 0}};
  std::string kind;
  std::string table;
  std::string order = "high_first";
  int width = 16;
};

template <auto Member>
inline constexpr auto of_field = at<&SignalFile::signal, &SignalConfig::field, Member>;

const Keys<SignalFile>& signal_keys() {
  static const Keys<SignalFile> keys = {
      {"kind", at<&SignalFile::kind>, required, "", "kind of signal in programs",
       one_of({"digital_input", "digital_output", "analog_input", "analog_output"})},
      {"number", at<&SignalFile::signal, &SignalConfig::number>, required, "",
       "its number in programs: 0 to 63 digital, 0 to 15 analog", from(0, 63)},
      {"address", at<&SignalFile::signal, &SignalConfig::unit>, required, "",
       "Modbus unit of the module", from(1, 247)},
      {"table", at<&SignalFile::table>, required, "", "where it is in the module",
       one_of({"coil", "discrete_input", "holding_register", "input_register"})},
      {"register", of_field<&RegisterField::address>, required, "",
       "coil, input or register, counted from 0", from(0, 65535)},
      {"bit", at<&SignalFile::signal, &SignalConfig::bit>, optional, "",
       "digital in a register: its bit", from(0, 15)},
      {"inverted", at<&SignalFile::signal, &SignalConfig::is_inverted>, optional, "",
       "digital: on is 0 on the wire, as with a break contact"},
      {"width", at<&SignalFile::width>, optional, "bit", "analog: 16, or 32 over two registers",
       from(16, 32)},
      {"signed", of_field<&RegisterField::is_signed>, optional, "",
       "analog: whether 16 bits are two's complement"},
      {"order", at<&SignalFile::order>, optional, "", "analog: which word of 32 bits comes first",
       one_of({"high_first", "low_first"})},
      {"scale", of_field<&RegisterField::scale>, optional, "1/unit",
       "analog: increments per unit of the value in programs"},
      {"offset", of_field<&RegisterField::offset>, optional, "", "analog: increments at value 0"},
  };
  return keys;
}

SignalKind signal_kind_named(const std::string& word) {
  if (word == "digital_input") return SignalKind::digital_input;
  if (word == "digital_output") return SignalKind::digital_output;
  return word == "analog_input" ? SignalKind::analog_input : SignalKind::analog_output;
}

SignalTable table_of(const std::string& word) {
  if (word == "coil") return SignalTable::coil;
  if (word == "discrete_input") return SignalTable::discrete_input;
  return word == "holding_register" ? SignalTable::holding_register : SignalTable::input_register;
}

void check(const toml::table& table, const SignalFile& file, const Scope& scope) {
  const SignalConfig& signal = file.signal;
  const bool is_read_only =
      signal.table == SignalTable::discrete_input || signal.table == SignalTable::input_register;
  if (signal.is_output() && is_read_only) {
    scope.fault(place_of(table, "table"),
                "an output cannot be written there; use coil or holding_register");
  }
  if (!signal.is_digital() && signal.is_of_bits()) {
    scope.fault(place_of(table, "table"),
                "an analog value needs a holding_register or an input_register");
  }
  if (!signal.is_digital() && signal.number >= Signals::analog_count) {
    scope.fault(place_of(table, "number"),
                "number is " + std::to_string(signal.number) + "; analog signals are 0 to 15");
  }
  if (file.width != 16 && file.width != 32) {
    scope.fault(place_of(table, "width"),
                "width is " + std::to_string(file.width) + "; it must be 16 or 32 bits");
  }
  if (signal.field.scale == 0.0)
    scope.fault(place_of(table, "scale"), "scale is 0; write the number of increments per unit");
}

SignalConfig read_signal(const toml::table& table, const Scope& scope) {
  SignalFile file;
  read_table(table, signal_keys(), file, scope);
  file.signal.kind = signal_kind_named(file.kind);
  file.signal.table = table_of(file.table);
  file.signal.field.words = file.width == 32 && !file.signal.is_digital() ? 2 : 1;
  file.signal.field.order =
      file.order == "low_first" ? drives::WordOrder::low_first : drives::WordOrder::high_first;
  check(table, file, scope);
  return file.signal;
}

}  // namespace

std::vector<SignalConfig> read_signals(Subtables signals, const Scope& scope) {
  std::vector<SignalConfig> configs;
  if (signals == nullptr) return configs;
  for (const toml::node& node : *signals) {
    const toml::table& table = *node.as_table();
    const Scope inner{scope.faults, "signal " + std::to_string(configs.size() + 1)};
    const SignalConfig signal = read_signal(table, inner);
    const bool is_known = std::ranges::any_of(configs, [&](const SignalConfig& other) {
      return other.kind == signal.kind && other.number == signal.number;
    });
    if (is_known)
      inner.fault(place_of(table, "number"), "another signal of this kind has the number");
    configs.push_back(signal);
  }
  return configs;
}

std::vector<KeyRow> signal_key_rows() {
  return describe(signal_keys());
}

}  // namespace stanok::config
