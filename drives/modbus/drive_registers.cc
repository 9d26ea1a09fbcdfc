// Blocks to registers and back, field by field.
#include "drives/modbus/drive_registers.h"

namespace stanok::drives {
namespace {

// Calls `visit` with every field of the map and the member of the block that it holds.
template <class Visit>
void visit_commands(const RegisterMap& map, Visit visit) {
  visit(map.control_word, &CommandBlock::control_word);
  visit(map.target_position, &CommandBlock::target_position);
  visit(map.target_velocity, &CommandBlock::target_velocity);
  visit(map.heartbeat, &CommandBlock::heartbeat);
}

template <class Visit>
void visit_statuses(const RegisterMap& map, Visit visit) {
  visit(map.status_word, &StatusBlock::status_word);
  visit(map.position, &StatusBlock::position);
  visit(map.velocity, &StatusBlock::velocity);
  visit(map.following_error, &StatusBlock::following_error);
  visit(map.power, &StatusBlock::power);
  visit(map.vibration, &StatusBlock::vibration);
  visit(map.vibration_frequency, &StatusBlock::vibration_frequency);
  visit(map.fault_code, &StatusBlock::fault_code);
  visit(map.heartbeat_echo, &StatusBlock::heartbeat_echo);
  visit(map.inputs, &StatusBlock::inputs);
  visit(map.index_position, &StatusBlock::index_position);
  visit(map.index_count, &StatusBlock::index_count);
  visit(map.temperature, &StatusBlock::temperature);
}

template <class Block>
auto writer(const Block& block, std::span<std::uint16_t> image) {
  return [&block, image](const RegisterField& field, auto member) RT_SAFE {
    if (field.exists()) write_field(field, static_cast<std::int32_t>(block.*member), image);
  };
}

template <class Block>
auto reader(Block& block, std::span<const std::uint16_t> image) {
  return [&block, image](const RegisterField& field, auto member) RT_SAFE {
    using Value = std::remove_reference_t<decltype(block.*member)>;
    if (field.exists()) block.*member = static_cast<Value>(read_field(field, image));
  };
}

}  // namespace

void write_block(const RegisterMap& map, const CommandBlock& block, std::span<std::uint16_t> image)
    RT_SAFE {
  visit_commands(map, writer(block, image));
}

void write_block(const RegisterMap& map, const StatusBlock& block, std::span<std::uint16_t> image)
    RT_SAFE {
  visit_statuses(map, writer(block, image));
}

CommandBlock command_block(const RegisterMap& map, std::span<const std::uint16_t> image) RT_SAFE {
  CommandBlock block;
  visit_commands(map, reader(block, image));
  return block;
}

StatusBlock status_block(const RegisterMap& map, std::span<const std::uint16_t> image) RT_SAFE {
  StatusBlock block;
  visit_statuses(map, reader(block, image));
  return block;
}

}  // namespace stanok::drives
