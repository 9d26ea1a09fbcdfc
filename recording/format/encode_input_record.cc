#include "recording/format/encode_input_record.h"

#include <cstring>
#include <limits>
#include <variant>

#include "base/signals.h"

namespace stanok::recording {
namespace {

using channels::InputContent;

// The numbers of input_t.
enum class InputKind : std::int8_t {
  operator_command = 0,
  signal = 3,
  overrun = 4,
  spindle_sensor = 5,
  lost = 6,
  table_taking = 7,
};

// Analog inputs are counted on behind the digital ones.
struct Fill {
  input_t& message;

  void kind(InputKind kind) const { message.kind = static_cast<std::int8_t>(kind); }

  void operator()(const channels::OperatorCommand& command) const {
    const channels::CommandFields fields = channels::fields_of(command);
    kind(InputKind::operator_command);
    message.method = static_cast<std::int32_t>(fields.action);
    message.number = fields.number;
    message.value = fields.value;
    message.value_2 = fields.value_2;
    put_text(fields.text.view(), message.text);
  }
  void operator()(const channels::DigitalInput& input) const {
    kind(InputKind::signal);
    message.method = input.number;
    message.value = input.is_on ? 1.0 : 0.0;
  }
  void operator()(const channels::AnalogInput& input) const {
    kind(InputKind::signal);
    message.method = Signals::digital_count + input.number;
    message.value = input.value;
  }
  void operator()(const channels::SpindleInput& input) const {
    kind(InputKind::spindle_sensor);
    message.method = input.spindle;
    message.number = static_cast<std::int32_t>(input.quantity);
    message.value = input.value;
  }
  void operator()(const channels::Overrun& overrun) const {
    kind(InputKind::overrun);
    message.value = static_cast<double>(overrun.periods);
  }
  void operator()(const channels::LostInputs& lost) const {
    kind(InputKind::lost);
    message.value = static_cast<double>(lost.count);
  }
  void operator()(const channels::TableTaking& taking) const {
    kind(InputKind::table_taking);
    message.method = static_cast<std::int32_t>(taking.run);
    message.value = static_cast<double>(taking.command);
    message.value_2 = static_cast<double>(taking.version);
  }
  void operator()(const channels::UnknownInput& /*unknown*/) const { message.kind = -1; }
};

InputContent command_in(const input_t& message) {
  if (message.method < 0 || message.method > std::numeric_limits<std::uint8_t>::max())
    return channels::UnknownInput{};
  const auto command =
      channels::command_of({.action = static_cast<channels::OperatorAction>(message.method),
                            .number = message.number,
                            .value = message.value,
                            .value_2 = message.value_2,
                            .text = text_of(message.text)});
  return command ? InputContent(*command) : InputContent(channels::UnknownInput{});
}

InputContent signal_in(const input_t& message) {
  const std::int32_t number = message.method;
  if (number < 0 || number >= Signals::digital_count + Signals::analog_count)
    return channels::UnknownInput{};
  if (number < Signals::digital_count)
    return channels::DigitalInput{.number = number, .is_on = message.value != 0.0};
  return channels::AnalogInput{.number = number - Signals::digital_count, .value = message.value};
}

InputContent spindle_sensor_in(const input_t& message) {
  constexpr auto last = static_cast<std::int32_t>(channels::SpindleQuantity::vibration_hz);
  if (message.method < 0 || message.number < 0 || message.number > last)
    return channels::UnknownInput{};
  return channels::SpindleInput{.spindle = message.method,
                                .quantity = static_cast<channels::SpindleQuantity>(message.number),
                                .value = message.value};
}

// Of a count; others than whole numbers up to 2^53 are no counts.
template <class Whole>
Whole count_in(double value) {
  constexpr double count_max = 9007199254740992.0;
  return value >= 0.0 && value <= count_max ? static_cast<Whole>(value) : Whole{0};
}

InputContent content_of(const input_t& message) {
  switch (static_cast<InputKind>(message.kind)) {
    case InputKind::operator_command:
      return command_in(message);
    case InputKind::signal:
      return signal_in(message);
    case InputKind::overrun:
      return channels::Overrun{count_in<std::int64_t>(message.value)};
    case InputKind::spindle_sensor:
      return spindle_sensor_in(message);
    case InputKind::lost:
      return channels::LostInputs{count_in<std::uint64_t>(message.value)};
    case InputKind::table_taking:
      return channels::TableTaking{.run = static_cast<std::uint32_t>(message.method),
                                   .command = count_in<std::uint64_t>(message.value),
                                   .version = count_in<std::uint64_t>(message.value_2)};
  }
  return channels::UnknownInput{};
}

}  // namespace

input_t to_input(const channels::InputRecord& record, const Stamp& stamp) {
  input_t message;
  std::memset(&message, 0, sizeof message);
  message.utime = stamp.utime;
  message.cycle = stamp.cycle;
  message.seq = stamp.seq;
  message.channel = record.channel;
  std::visit(Fill{message}, record.content);
  return message;
}

channels::InputRecord from_input(const input_t& message) {
  return {.cycle = message.cycle, .channel = message.channel, .content = content_of(message)};
}

}  // namespace stanok::recording
