// Status words and control words against the tables of CiA 402 (objects 6040h and 6041h).
#include "drives/cia402.h"

#include <gtest/gtest.h>

#include <vector>

namespace stanok::drives {
namespace {

struct StatusCase {
  const char* name;
  std::uint16_t word;
  std::optional<DriveState> state;
};

class StatusWord : public ::testing::TestWithParam<StatusCase> {};

TEST_P(StatusWord, IsTheStateOfTheStandard) {
  EXPECT_EQ(state_of(GetParam().word), GetParam().state);
}

// The bits that are no state bits (4, 7 to 15) are set here and there.
INSTANTIATE_TEST_SUITE_P(
    Standard, StatusWord,
    ::testing::Values(StatusCase{"NotReady", 0x0000, DriveState::not_ready_to_switch_on},
                      StatusCase{"SwitchOnDisabled", 0x0250, DriveState::switch_on_disabled},
                      StatusCase{"ReadyToSwitchOn", 0x0231, DriveState::ready_to_switch_on},
                      StatusCase{"SwitchedOn", 0x0233, DriveState::switched_on},
                      StatusCase{"OperationEnabled", 0x9237, DriveState::operation_enabled},
                      StatusCase{"QuickStopActive", 0x0217, DriveState::quick_stop_active},
                      StatusCase{"FaultReactionActive", 0x021F, DriveState::fault_reaction_active},
                      StatusCase{"Fault", 0x0218, DriveState::fault},
                      StatusCase{"OperationWithoutSwitchedOn", 0x0034, std::nullopt},
                      StatusCase{"AllBits", 0xFFFF, std::nullopt}),
    [](const auto& test) { return test.param.name; });

TEST(StatusWord, ReadsBackEveryState) {
  for (int i = 0; i < 8; ++i) {
    const auto state = static_cast<DriveState>(i);
    EXPECT_EQ(state_of(state_bits(state)), state) << name_of(state);
  }
}

TEST(ControlWord, LeadsThroughTheStatesToOperation) {
  EXPECT_EQ(control_word(DriveState::switch_on_disabled, PowerRequest::on), 0x06);
  EXPECT_EQ(control_word(DriveState::ready_to_switch_on, PowerRequest::on), 0x07);
  EXPECT_EQ(control_word(DriveState::switched_on, PowerRequest::on), 0x0F);
  EXPECT_EQ(control_word(DriveState::operation_enabled, PowerRequest::on), 0x0F);
}

TEST(ControlWord, NeverTakesADriveOutOfItsFaultUnasked) {
  for (const auto request : {PowerRequest::off, PowerRequest::on, PowerRequest::quick_stop}) {
    EXPECT_EQ(control_word(DriveState::fault, request) & control::fault_reset, 0);
  }
  EXPECT_EQ(control_word(DriveState::fault, PowerRequest::reset_fault), 0x80);
}

TEST(ControlWord, QuickStopKeepsVoltageSoThatTheDriveBrakes) {
  EXPECT_EQ(control_word(DriveState::operation_enabled, PowerRequest::quick_stop), 0x02);
}

TEST(ControlWord, OffLeavesOperationByShutdownAndQuickStopByDisableVoltage) {
  EXPECT_EQ(control_word(DriveState::operation_enabled, PowerRequest::off), 0x06);
  EXPECT_EQ(control_word(DriveState::quick_stop_active, PowerRequest::off), 0x00);
}

}  // namespace
}  // namespace stanok::drives
