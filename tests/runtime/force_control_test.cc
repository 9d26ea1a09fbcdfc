// Force control in the whole runtime: the plant of lathe.toml behind the sensors, on the virtual
// clock.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "runtime/simulation.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

using ::testing::Each;
using ::testing::Le;
using ::testing::SizeIs;

const std::filesystem::path root = stanok::testing::source_folder();

config::MachineFile lathe() {
  return config::read_machine_file(root / "config" / "machines" / "lathe.toml");
}

std::string example() {
  std::ifstream file(root / "programs" / "examples" / "adaptive_steps.nc");
  return {std::istreambuf_iterator<char>(file), {}};
}

// What each cycle of a run was.
struct Cycles final : public CycleObserver {
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    if (!channel.running) return;
    outputs.push_back(channel);
    for (std::size_t k = 0; k < 2; ++k) {
      const channels::AxisSetpoint& axis = channel.axes[k];
      for (const double value : {axis.position, axis.velocity, axis.acceleration, axis.jerk})
        bits.push_back(std::bit_cast<std::uint64_t>(value));
    }
  }
  void observe(const channels::InputChange& change) override {
    if (std::holds_alternative<channels::SpindleInput>(change.content)) inputs.push_back(change);
  }
  void observe(const channels::Event& event) override { codes.emplace_back(event.code.view()); }

  std::vector<channels::ChannelOutput> outputs;
  std::vector<channels::InputChange> inputs;
  std::vector<std::uint64_t> bits;
  std::vector<std::string> codes;
};

class ForceControlRun : public ::testing::Test {
 protected:
  ForceControlRun() { options.file = lathe(); }
  SimulationResult run(const std::string& program, Cycles& cycles,
                       DriveChoice drives = DriveChoice::ideal) {
    files_.write("part.nc", program);
    options.program_roots = {files_.folder()};
    options.programs = {{.channel = 1, .program = "part.nc"}};
    options.drives = drives;
    return simulate(options, {&cycles}, [] { return false; });
  }

  SimulationOptions options;

 private:
  config::TemporaryFiles files_;
};

// Depth 2, 3, 2 mm and hardness 200, 260, 170 HB at 600 rev/min: 12 revolutions are 1.2 s.
TEST_F(ForceControlRun, HoldsTheForceOverStepsOfDepthAndHardness) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    Cycles cycles;
    const SimulationResult result = run(example(), cycles, drives);
    EXPECT_TRUE(result.ok);
    ASSERT_TRUE(result.process.has_value());
    EXPECT_LT(result.process->force_error_steady_max, 0.01);
    EXPECT_LT(result.process->overshoot_return_max, 0.05);
    EXPECT_THAT(result.process->settling_s, SizeIs(4));
    // Where the cut becomes lighter the feed rises a tenth at a time.
    EXPECT_THAT(result.process->settling_s, Each(Le(4.0)));
    for (const channels::ChannelOutput& output : cycles.outputs) {
      const motion::ForceStatus& force = output.process.force;
      if (force.state != motion::ForceState::regulating) continue;
      // 0.05 and 0.6 mm per revolution at 10 revolutions per second.
      ASSERT_GE(force.feed_per_s, 0.5 - 1e-9);
      ASSERT_LE(force.feed_per_s, 6.0 + 1e-9);
    }
  }
}

// The greatest constant feed that keeps 1200 N in the deepest step: h^0.75 = 1200 / (1600 x 3).
TEST_F(ForceControlRun, IsFasterThanTheBestConstantFeedFullSize) {
  Cycles controlled;
  const double with = static_cast<double>(run(example(), controlled).cycles);
  const double h = std::pow(1200.0 / (1600.0 * 3.0), 1.0 / 0.75);
  std::string program = example();
  const auto replace = [&](const std::string& from, const std::string& to) {
    program.replace(program.find(from), from.size(), to);
  };
  replace("#adaptive (force, 1200, 0.05, 0.6)", "");
  replace("#adaptive (off)", "");
  replace("F0.25", "F" + std::to_string(h));
  Cycles constant;
  const double without = static_cast<double>(run(program, constant).cycles);
  RecordProperty("gain_percent", std::to_string(100.0 * (1.0 - with / without)));
  EXPECT_LT(with, 0.8 * without);
}

// Without #adaptive a machine file with the section runs as one without, bit by bit.
TEST_F(ForceControlRun, OffItChangesNoBit) {
  std::string program = example();
  for (const std::string line : {"#adaptive (force, 1200, 0.05, 0.6)", "#adaptive (off)"})
    program.replace(program.find(line), line.size(), "");
  Cycles with;
  EXPECT_TRUE(run(program, with).ok);
  options.file.process = {};
  options.file.simulation.cutting = {};
  for (channels::ChannelConfig& channel : options.file.machine.channels)
    channel.force_control = false;
  Cycles without;
  EXPECT_TRUE(run(program, without).ok);
  EXPECT_EQ(with.bits, without.bits);
}

// Rapid moves have in every cycle the feed that they have without control. The dwell lets the
// cycles of both runs begin together behind the cut.
TEST_F(ForceControlRun, LeavesRapidMovesAlone) {
  const std::string way = "G61 G0 X60 Z2\nG1 Z-30 F0.25\nG4 P0.1\nG0 X72\nG0 Z5\nG0 X60\nM30\n";
  const std::string head = "G21 G90 G18 G7 G40 G54 G95\nG97 S600 M3\n";
  const auto rapids = [&](const std::string& program) {
    Cycles cycles;
    EXPECT_TRUE(run(program, cycles).ok);
    std::vector<double> speeds;
    for (const channels::ChannelOutput& output : cycles.outputs) {
      if (output.feed_commanded == 0.0 && output.path_speed > 0.0)
        speeds.push_back(output.path_speed);
    }
    return speeds;
  };
  const std::vector<double> expected = rapids(head + way);
  const std::vector<double> controlled =
      rapids(head + "#adaptive (force, 1200, 0.05, 0.6)\n" + way);
  ASSERT_EQ(controlled.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_EQ(controlled[k], expected[k]) << k;
}

// The sensor values on record, given back in place of the plant.
TEST_F(ForceControlRun, IsReplayedBitByBitFromTheRecordedSensors) {
  Cycles original;
  EXPECT_TRUE(run(example(), original).ok);
  ASSERT_FALSE(original.inputs.empty());
  SensorRow row;
  row.spindles.resize(options.file.machine.spindles.size());
  std::int64_t cycle = original.inputs.front().cycle;
  const auto end_row = [&] {
    row.t = (static_cast<double>(cycle) - 0.5) * 1e-3;
    options.sensors.push_back(row);
  };
  for (const channels::InputChange& input : original.inputs) {
    if (input.cycle != cycle) end_row();
    cycle = input.cycle;
    const auto& sensor = std::get<channels::SpindleInput>(input.content);
    channels::SpindleSensors& sensors = row.spindles[static_cast<std::size_t>(sensor.spindle)];
    using enum channels::SpindleQuantity;
    (sensor.quantity == power_w        ? sensors.power_w
     : sensor.quantity == vibration_um ? sensors.vibration_um
                                       : sensors.vibration_hz) = sensor.value;
  }
  end_row();
  Cycles replay;
  EXPECT_TRUE(run(example(), replay).ok);
  EXPECT_EQ(replay.bits, original.bits);
}

TEST_F(ForceControlRun, IdlePowerIsTakenAtEveryStartOfTheSpindle) {
  Cycles cycles;
  EXPECT_TRUE(run("G21 G90 G18 G7 G40 G54 G95\nG97 S600 M3\n#adaptive (force, 1200, 0.05, 0.6)\n"
                  "G0 X60 Z2\nG1 Z-5 F0.2\nG0 X72\nM5\nM4 S700\nG0 Z2\nM5\nM3\nM30\n",
                  cycles)
                  .ok);
  std::uint32_t captures = 0;
  for (const channels::ChannelOutput& output : cycles.outputs) {
    const motion::ForceStatus& force = output.process.force;
    if (force.captures == captures) continue;
    captures = force.captures;
    EXPECT_FALSE(output.feed_commanded > 0.0 && output.path_speed > 0.0);
    EXPECT_NE(output.process.spindle_rev_per_min, 0.0);
  }
  EXPECT_EQ(captures, 3U);
}

// #tool_overhang moves the counter by the difference; not one pulse goes to the slide.
TEST_F(ForceControlRun, OverhangMovesTheCounterAndNotTheSlide) {
  Cycles cycles;
  EXPECT_TRUE(run("G21 G90 G18 G8 G40 G54 G95\nT0101\nG97 S600 M3\n"
                  "#adaptive (force, 1200, 0.05, 0.6)\nG0 X40 Z20\n#tool_overhang (5)\n"
                  "G4 P0.1\n#tool_overhang (7.5)\nG4 P0.1\n#tool_overhang ()\nG4 P0.1\nM30\n",
                  cycles)
                  .ok);
  double counter = -1.0;
  std::int64_t slide = 0;
  std::vector<double> changes;
  for (const channels::ChannelOutput& output : cycles.outputs) {
    const double radius = output.process.force.radius_mm;
    if (output.path_speed == 0.0 && counter >= 0.0 && radius != counter) {
      changes.push_back(radius - counter);
      EXPECT_EQ(output.axes[0].position_code, slide);
    }
    counter = radius;
    slide = output.axes[0].position_code;
    ASSERT_NEAR(radius, std::abs(output.point_W[0].value), 0.0005 + 1e-9);
  }
  // First the tool comes in; then 5, 7.5 and again 0, the value of the table.
  ASSERT_THAT(changes, SizeIs(4));
  EXPECT_NEAR(changes[1], 5.0, 1e-9);
  EXPECT_NEAR(changes[2], 2.5, 1e-9);
  EXPECT_NEAR(changes[3], -7.5, 1e-9);
}

// The van der Pol plant: 12 um at 113 Hz on 2 kg, swung at 4 Hz with 1.1 P_q.
TEST_F(ForceControlRun, QuenchesSelfOscillationByTheOscillationOfTheForce) {
  options.file.simulation.cutting.vibration_um = 12.0;
  options.file.simulation.cutting.vibration_hz = 113.0;
  options.file.simulation.cutting.vibration_mass_kg = 2.0;
  const std::string cut =
      "G21 G90 G18 G7 G40 G54 G95\nG97 S600 M3\n#adaptive (force, 1200, 0.05, 0.6)\n";
  Cycles cycles;
  EXPECT_TRUE(
      run(cut + "G0 X60 Z2\n#adaptive (vibration, on, 6, 2, 4)\nG1 Z-19 F0.25\nM30\n", cycles).ok);
  double seen_um = 0.0;
  double seen_hz = 0.0;
  double formed_n = 0.0;
  for (const channels::ChannelOutput& output : cycles.outputs) {
    const motion::ForceStatus& force = output.process.force;
    // What the law begins with.
    if (formed_n > 0.0 || force.oscillation_n == 0.0) continue;
    seen_um = force.vibration_um;
    seen_hz = force.vibration_hz;
    formed_n = force.oscillation_n;
  }
  EXPECT_NEAR(seen_um, 12.0, 0.05 * 12.0);
  EXPECT_NEAR(seen_hz, 113.0, 0.01 * 113.0);
  const double w = 2.0 * M_PI * seen_hz;
  const double f = 2.0 * M_PI * 4.0;
  EXPECT_NEAR(formed_n, 1.1 * seen_um * 1e-6 / std::sqrt(2.0) * 2.0 * (w * w - f * f), 1e-6);
}

TEST_F(ForceControlRun, LostSensorHoldsTheFeedWithAnAlarm) {
  options.sensors = {{.t = 0.0, .spindles = {{.power_w = 70.0}, {}}},
                     {.t = 3.0, .spindles = {{}, {}}}};
  Cycles cycles;
  const SimulationResult result =
      run("G21 G90 G18 G7 G40 G54 G95\nG97 S600 M3\n#adaptive (force, 1200, 0.05, 0.6)\n"
          "G0 X60 Z2\nG1 Z-19 F0.25\nM30\n",
          cycles);
  EXPECT_FALSE(result.ok);
  ASSERT_THAT(result.alarms, SizeIs(1));
  EXPECT_EQ(result.alarms[0].diagnostic.code, "A4010");
  EXPECT_EQ(cycles.outputs.back().state, channels::ChannelState::held);
  EXPECT_EQ(cycles.outputs.back().path_speed, 0.0);
}

TEST_F(ForceControlRun, LostSensorMeansTheSmallestFeedWhereTheMachineFileSaysSo) {
  options.file.process.control.on_sensor_fault = process::SensorFault::feed_min;
  options.sensors = {{.t = 0.0, .spindles = {{.power_w = 70.0}, {}}},
                     {.t = 3.0, .spindles = {{}, {}}}};
  Cycles cycles;
  const SimulationResult result =
      run("G21 G90 G18 G7 G40 G54 G95\nG97 S600 M3\n#adaptive (force, 1200, 0.05, 0.6)\n"
          "G0 X60 Z2\nG1 Z-9 F0.25\nM30\n",
          cycles);
  ASSERT_THAT(result.alarms, SizeIs(1));
  EXPECT_EQ(result.alarms[0].diagnostic.code, "A4010");
  double last = 0.0;
  for (const channels::ChannelOutput& output : cycles.outputs) {
    if (output.path_speed > 0.0) last = output.path_speed;
    const bool is_lost = output.process.force.state == motion::ForceState::fault;
    if (is_lost && output.feed_commanded > 0.0) {
      ASSERT_LE(output.path_speed, 2.5 + 1e-9);
    }
  }
  EXPECT_LE(last, 0.5 + 1e-9) << "S_min, 0.05 mm per revolution";
  ASSERT_THAT(result.runs, SizeIs(1));
  EXPECT_TRUE(result.runs[0].ended);
}

}  // namespace
}  // namespace stanok::runtime
