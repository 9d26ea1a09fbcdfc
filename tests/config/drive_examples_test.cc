// The register maps of docs/integrator/drives.md are read by the strict reader, and mean what the
// text says.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "config/files/machine_file.h"
#include "drives/modbus/exchange_plan.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::config {
namespace {

using drives::Function;

// All TOML of the document, in its order, with the rest of a machine around it.
std::string machine_of_the_document() {
  std::ifstream stream(stanok::testing::source_folder() + "/docs/integrator/drives.md");
  const std::string document{std::istreambuf_iterator<char>(stream),
                             std::istreambuf_iterator<char>()};
  std::string text =
      "[machine]\nname = \"document\"\n[[channel]]\nid = 1\nname = \"c\"\n"
      "axes = [\"X\", \"Y\"]\nspindles = [1]\n";
  constexpr std::string_view fence = "```toml\n";
  for (std::size_t at = document.find(fence); at != std::string::npos;
       at = document.find(fence, at)) {
    at += fence.size();
    text += document.substr(at, document.find("```", at) - at);
  }
  return text;
}

class DriveExamples : public ::testing::Test {
 protected:
  TemporaryFiles files_;
  MachineFile file_ = read_machine_file(files_.write("m.toml", machine_of_the_document()));
};

TEST_F(DriveExamples, TheServoTakesOneTrip) {
  const drives::AxisDriveConfig& servo = file_.bus.axes.at(0);
  const auto plan = drives::exchange_plan(servo);
  ASSERT_EQ(plan.size(), 1U);
  EXPECT_EQ(plan[0].function, Function::write_and_read_registers);
  EXPECT_EQ(plan[0].written, (drives::RegisterRun{0x40, 5}));
  EXPECT_EQ(plan[0].read, (drives::RegisterRun{0x80, 9}));
  EXPECT_FALSE(servo.words.has_value());
  EXPECT_EQ(servo.map.target_position.increments(10.0), 100000) << "one turn";
  EXPECT_EQ(servo.map.bits.close_brake, 0);
}

TEST_F(DriveExamples, TheStepperIsWrittenAndReadOnce) {
  const drives::AxisDriveConfig& stepper = file_.bus.axes.at(1);
  const auto plan = drives::exchange_plan(stepper);
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[0].function, Function::write_registers);
  EXPECT_EQ(plan[1].function, Function::read_registers);
  EXPECT_EQ(plan[1].read, (drives::RegisterRun{0x1000, 5}));
  EXPECT_EQ(stepper.map.position.increments(5.0), 4000) << "one turn";
  EXPECT_EQ(stepper.map.target_velocity.increments(-100.0), -1200) << "5 mm a turn, per minute";
}

// 3000 rev/min of a motor with two pairs of poles are 100 Hz.
TEST_F(DriveExamples, TheInverterIsToldAFrequency) {
  const drives::AxisDriveConfig& inverter = file_.bus.spindles.at(0);
  EXPECT_EQ(inverter.map.target_velocity.increments(3000.0), 10000);
  EXPECT_EQ(inverter.map.power.value(15), 1500.0);
  EXPECT_EQ(drives::exchange_plan(inverter).size(), 4U);
  EXPECT_EQ(drives::run_word(*inverter.words, drives::PowerRequest::on, -1.0), 0x22);
}

TEST_F(DriveExamples, SignalsAreOnTheBus) {
  ASSERT_EQ(file_.bus.signals.size(), 2U);
  EXPECT_EQ(file_.bus.signals[1].table, drives::SignalTable::coil);
}

}  // namespace
}  // namespace stanok::config
