// The standard map, and the packing of fields with shifts and bit casts: no word order but the one
// of the field.
#include "drives/register_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace stanok::drives {
namespace {

struct Range {
  double low;
  double high;
};

// -2^31 is left out: drives use it for "no value".
Range range_of(const RegisterField& field) RT_SAFE {
  if (field.words == 2) {
    constexpr double limit = std::numeric_limits<std::int32_t>::max();
    return {-limit, limit};
  }
  return field.is_signed ? Range{-32768.0, 32767.0} : Range{0.0, 65535.0};
}

// Places the fields of a block one after the other.
class Block {
 public:
  explicit Block(int first) : next_(first) {}

  RegisterField word() { return placed({}); }
  RegisterField short_value(double scale) { return placed({.is_signed = true, .scale = scale}); }
  RegisterField unsigned_value(double scale) { return placed({.scale = scale}); }
  RegisterField long_value(double scale) {
    return placed({.words = 2, .is_signed = true, .scale = scale});
  }

 private:
  RegisterField placed(RegisterField field) {
    field.address = next_;
    next_ += field.words;
    return field;
  }

  int next_;
};

}  // namespace

std::optional<std::int32_t> RegisterField::increments(double value) const RT_SAFE {
  if (!exists()) return 0;
  const double rounded = std::round(value * scale + offset);
  const Range range = range_of(*this);
  if (!(rounded >= range.low && rounded <= range.high)) return std::nullopt;
  return static_cast<std::int32_t>(rounded);
}

std::int32_t RegisterField::saturated_increments(double value) const RT_SAFE {
  if (!exists()) return 0;
  const double rounded = std::round(value * scale + offset);
  if (std::isnan(rounded)) return 0;
  const Range range = range_of(*this);
  return static_cast<std::int32_t>(std::clamp(rounded, range.low, range.high));
}

RegisterMap register_map(const StandardMap& standard) {
  constexpr double tenths = 10.0;
  RegisterMap map;
  map.bits = standard_bits;
  Block written(standard.control);
  map.control_word = written.word();
  map.target_position = written.long_value(standard.position_scale);
  map.target_velocity = written.long_value(standard.velocity_scale);
  map.heartbeat = written.word();
  Block read(standard.status);
  map.status_word = read.word();
  map.position = read.long_value(standard.position_scale);
  map.velocity = read.long_value(standard.velocity_scale);
  map.following_error = read.long_value(standard.position_scale);
  map.power = read.short_value(1.0);
  map.vibration = read.unsigned_value(tenths);
  map.vibration_frequency = read.unsigned_value(tenths);
  map.fault_code = read.word();
  map.heartbeat_echo = read.word();
  map.inputs = read.word();
  map.index_position = read.long_value(standard.position_scale);
  map.index_count = read.word();
  map.temperature = read.short_value(tenths);
  return map;
}

int register_count(const RegisterMap& map) {
  int count = 0;
  for (const FieldOfMap field : written_fields) count = std::max(count, (map.*field).end());
  for (const FieldOfMap field : read_fields) count = std::max(count, (map.*field).end());
  return count;
}

std::int32_t read_field(const RegisterField& field, std::span<const std::uint16_t> image) RT_SAFE {
  const std::size_t at = field.place();
  if (field.words == 2) {
    const bool high_first = field.order == WordOrder::high_first;
    const std::uint32_t high = image[high_first ? at : at + 1];
    const std::uint32_t low = image[high_first ? at + 1 : at];
    return std::bit_cast<std::int32_t>(high << 16U | low);
  }
  return field.is_signed ? std::bit_cast<std::int16_t>(image[at]) : std::int32_t{image[at]};
}

void write_field(const RegisterField& field, std::int32_t increments,
                 std::span<std::uint16_t> image) RT_SAFE {
  const std::size_t at = field.place();
  const auto bits = std::bit_cast<std::uint32_t>(increments);
  const auto high = static_cast<std::uint16_t>(bits >> 16U);
  const auto low = static_cast<std::uint16_t>(bits & 0xFFFFU);
  if (field.words == 2) {
    const bool high_first = field.order == WordOrder::high_first;
    image[high_first ? at : at + 1] = high;
    image[high_first ? at + 1 : at] = low;
  } else {
    image[at] = low;
  }
}

}  // namespace stanok::drives
