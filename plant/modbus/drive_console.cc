// Words of a line, and the drive that they name.
#include "plant/modbus/drive_console.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

#include "base/place.h"

namespace stanok::plant {
namespace {

constexpr const char* usage =
    "write 'fault AXIS KIND', or 'load AXIS POWER_W [VIBRATION_UM VIBRATION_HZ]'";

std::optional<std::size_t> drive_named(std::string_view axis,
                                       const std::vector<SimulatedDriveConfig>& drives) {
  const auto found = std::ranges::find_if(
      drives, [&](const SimulatedDriveConfig& drive) { return drive.registers.axis == axis; });
  if (found == drives.end()) return std::nullopt;
  return checked_size(found - drives.begin());
}

std::optional<double> number_of(const std::string& word) {
  double value = 0.0;
  const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_number = end.ec == std::errc() && end.ptr == word.data() + word.size();
  return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

std::string make_fault(const std::vector<std::string>& words,
                       const std::vector<SimulatedDriveConfig>& drives, ModbusServer& server) {
  if (words.size() != 3) return usage;
  const auto found = injection(words[1], words[2], drives);
  if (!found) return "there is no such axis or fault: " + words[1] + " " + words[2];
  server.inject(found->drive, found->kind);
  return "";
}

std::string take_load(const std::vector<std::string>& words,
                      const std::vector<SimulatedDriveConfig>& drives, ModbusServer& server) {
  if (words.size() != 3 && words.size() != 5) return usage;
  const auto drive = drive_named(words[1], drives);
  if (!drive) return "there is no axis " + words[1];
  std::array<double, 3> values{};
  for (std::size_t k = 0; k + 2 < words.size(); ++k) {
    const auto value = number_of(words[k + 2]);
    if (!value) return "this is not a number: " + words[k + 2];
    values[k] = *value;
  }
  server.load(*drive, {.power_w = values[0], .vibration_um = values[1], .vibration_hz = values[2]});
  return "";
}

}  // namespace

std::optional<Injection> injection(std::string_view axis, std::string_view fault,
                                   const std::vector<SimulatedDriveConfig>& drives) {
  const auto drive = drive_named(axis, drives);
  const auto kind = fault_named(fault);
  if (!drive || !kind) return std::nullopt;
  return Injection{*drive, *kind};
}

std::string carry_out(const std::string& line, const std::vector<SimulatedDriveConfig>& drives,
                      ModbusServer& server) {
  const std::vector<std::string> words = words_of(line);
  if (words.empty()) return "";
  if (words[0] == "fault") return make_fault(words, drives, server);
  return words[0] == "load" ? take_load(words, drives, server) : usage;
}

}  // namespace stanok::plant
