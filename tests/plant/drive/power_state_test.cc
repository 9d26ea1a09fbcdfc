// Every transition of the CiA 402 automaton that a control word or an event causes.
#include "plant/drive/power_state.h"

#include <gtest/gtest.h>

#include <vector>

#include "drives/cia402.h"

namespace stanok::plant {
namespace {

using drives::DriveState;

constexpr std::uint16_t disable_voltage = 0x00;
constexpr std::uint16_t quick_stop = 0x02;
constexpr std::uint16_t shutdown = 0x06;
constexpr std::uint16_t switch_on = 0x07;
constexpr std::uint16_t enable_operation = 0x0F;
constexpr std::uint16_t fault_reset = 0x80;

struct TransitionCase {
  int number;  // in CiA 402
  std::vector<std::uint16_t> words;
  DriveState state;
};

class Transition : public ::testing::TestWithParam<TransitionCase> {};

TEST_P(Transition, LeadsToTheStateOfTheStandard) {
  PowerState power;
  for (const std::uint16_t word : GetParam().words) {
    power.take_control_word(word);
  }
  EXPECT_EQ(power.state(), GetParam().state);
}

INSTANTIATE_TEST_SUITE_P(
    ByControlWord, Transition,
    ::testing::Values(
        TransitionCase{2, {shutdown}, DriveState::ready_to_switch_on},
        TransitionCase{3, {shutdown, switch_on}, DriveState::switched_on},
        TransitionCase{4, {shutdown, switch_on, enable_operation}, DriveState::operation_enabled},
        TransitionCase{34, {shutdown, enable_operation}, DriveState::operation_enabled},
        TransitionCase{5, {shutdown, enable_operation, switch_on}, DriveState::switched_on},
        TransitionCase{6, {shutdown, switch_on, shutdown}, DriveState::ready_to_switch_on},
        TransitionCase{7, {shutdown, disable_voltage}, DriveState::switch_on_disabled},
        TransitionCase{70, {shutdown, quick_stop}, DriveState::switch_on_disabled},
        TransitionCase{8, {shutdown, enable_operation, shutdown}, DriveState::ready_to_switch_on},
        TransitionCase{9, {shutdown, enable_operation, 0}, DriveState::switch_on_disabled},
        TransitionCase{10, {shutdown, switch_on, 0}, DriveState::switch_on_disabled},
        TransitionCase{11, {shutdown, enable_operation, quick_stop}, DriveState::quick_stop_active},
        TransitionCase{
            12, {shutdown, enable_operation, quick_stop, 0}, DriveState::switch_on_disabled},
        TransitionCase{0, {enable_operation}, DriveState::switch_on_disabled},
        TransitionCase{16,
                       {shutdown, enable_operation, quick_stop, enable_operation},
                       DriveState::quick_stop_active}),
    [](const auto& test) { return "Number" + std::to_string(test.param.number); });

PowerState enabled() {
  PowerState power;
  power.take_control_word(shutdown);
  power.take_control_word(enable_operation);
  return power;
}

TEST(PowerState, QuickStopEndsDisabledWhenTheMotorStands) {
  PowerState power = enabled();
  power.take_control_word(quick_stop);
  EXPECT_TRUE(power.is_powered());
  power.notice_standstill();
  EXPECT_EQ(power.state(), DriveState::switch_on_disabled);
  EXPECT_FALSE(power.is_powered());
}

TEST(PowerState, AFaultBrakesFirstAndKeepsItsFirstCode) {
  PowerState power = enabled();
  power.trip(0x2310);
  power.trip(0x8611);
  EXPECT_EQ(power.state(), DriveState::fault_reaction_active);
  power.take_control_word(enable_operation);
  EXPECT_EQ(power.state(), DriveState::fault_reaction_active);
  power.notice_standstill();
  EXPECT_EQ(power.state(), DriveState::fault);
  EXPECT_EQ(power.fault_code(), 0x2310);
}

TEST(PowerState, LeavesTheFaultOnTheEdgeOfTheResetOnly) {
  PowerState power = enabled();
  power.take_control_word(fault_reset);
  power.trip(0x2310);
  power.notice_standstill();
  power.take_control_word(fault_reset);
  EXPECT_EQ(power.state(), DriveState::fault) << "the bit was set before: no edge";
  power.take_control_word(shutdown);
  EXPECT_EQ(power.state(), DriveState::fault);
  power.take_control_word(fault_reset);
  EXPECT_EQ(power.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(power.fault_code(), 0);
}

}  // namespace
}  // namespace stanok::plant
