// Recorded runs are repeated from their logs, bit for bit, whatever the timing of the preparations
// was and whatever an operator did; a log that was tampered with or cut is found out.
#include "runtime/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

#include "recording/channel_names.h"
#include "recording/decode.h"
#include "recording/encode.h"
#include "recording/log_check.h"
#include "recording/log_contents.h"
#include "recording/log_reader.h"
#include "recording/message_stream.h"
#include "runtime/assembly.h"
#include "runtime/log_observer.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;
using ::testing::Contains;
using ::testing::HasSubstr;

const std::filesystem::path source_tree = stanok::testing::source_folder();

config::MachineFile started_at(const channels::AxisRow& starts, config::MachineFile file) {
  for (channels::AxisConfig& axis : file.machine.axes) {
    const auto start = starts.find(axis.name);
    if (start != starts.end()) axis.start = start->second;
  }
  return file;
}

// A run whose preparations come only as far as chance lets them, as threads do.
class RecordedByChance {
 public:
  // `starts`: where axes stand at first that do not stand as in the machine file.
  RecordedByChance(const std::string& machine, DriveChoice drives, std::uint64_t seed,
                   const channels::AxisRow& starts = {})
      : random_(seed),
        assembly_({.file = started_at(starts, config::read_machine_file(source_tree / "config" /
                                                                        "machines" / machine)),
                   .drives = drives,
                   .program_roots = {files_.folder(), source_tree / "programs" / "examples"},
                   .machine = setup_.options,
                   .output_capacity = 0}),
        log_(assembly_.file(), setup_, path().string(), "test") {}

  void program(const std::string& name, const std::string& text) { files_.write(name, text); }

  void ask(OperatorAction action, int channel, const std::string& text = "", double value = 0.0,
           double value_2 = 0.0) {
    channels::OperatorEvent event;
    event.id = ++last_id_;
    event.action = action;
    event.channel = channel;
    event.text = FixedText<256>(text);
    event.value = value;
    event.value_2 = value_2;
    events_.push_back(event);
  }

  void run(int cycles) {
    const int channels = static_cast<int>(assembly_.file().machine.channels.size());
    for (int n = 0; n < cycles; ++n) {
      for (int k = 0; k < channels; ++k) {
        for (int steps = chance(4); steps > 0; --steps)
          static_cast<void>(assembly_.machine().prepare(k));
      }
      const channels::CycleOutput& output = assembly_.cycle(events_);
      events_.clear();
      for (const auto& read : assembly_.program_reads()) log_.observe(read, output.cycle);
      channels::InputRecord input;
      while (assembly_.machine().input_records().pop(input)) log_.observe(input);
      log_.observe(output);
      channels::Event event;
      while (assembly_.machine().events().pop(event)) log_.observe(event);
      channels::OperatorReply reply;
      while (assembly_.machine().replies().pop(reply)) {
      }
      moved_ = moved_ || output.channels[0].path_speed > 1.0;
    }
  }

  [[nodiscard]] int chance(int count) {
    return static_cast<int>(random_() % static_cast<std::uint64_t>(count));
  }
  [[nodiscard]] bool moved() const { return moved_; }
  [[nodiscard]] std::filesystem::path path() const { return files_.folder() / "run.lcm"; }
  void close() { EXPECT_EQ(log_.close(), ""); }
  [[nodiscard]] std::string closing_word() { return log_.close(); }
  // Cycles whose outputs do not get to the log.
  void lose_outputs(int cycles) {
    for (int n = 0; n < cycles; ++n) static_cast<void>(assembly_.cycle({}));
  }

 private:
  std::mt19937_64 random_;
  config::TemporaryFiles files_;
  RunSetup setup_{.options = {.on_at_start = true}};
  Assembly assembly_;
  LogObserver log_;
  std::vector<channels::OperatorEvent> events_;
  std::uint64_t last_id_ = 0;
  bool moved_ = false;
};

// A copy of a log in which every message of one type went through `change`.
template <class Message, class Change>
std::filesystem::path changed(const std::filesystem::path& log, recording::Topic topic,
                              const Change& change,
                              const std::function<void(recording::MessageStream&)>& go_on = {}) {
  const std::filesystem::path copy = log.string() + ".copy";
  auto reader = recording::LogReader::open(log);
  auto writer = recording::LogWriter::open(copy);
  while (const auto event = reader->next()) {
    std::vector<std::uint8_t> bytes(event->bytes.begin(), event->bytes.end());
    if (recording::topic_of(event->channel) == recording::name_of(topic)) {
      Message message = *recording::decode<Message>(event->bytes);
      change(message);
      message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    }
    (*writer)->send(std::string(event->channel), event->utime, bytes);
  }
  if (go_on) {
    recording::LogDescription machine;
    machine.machine = "mill3";
    recording::MessageStream stream(machine, {writer->get()});
    go_on(stream);
  }
  EXPECT_TRUE((*writer)->flush());
  return copy;
}

// The log without its check events.
std::filesystem::path without_checks(const std::filesystem::path& log) {
  const std::filesystem::path copy = log.string() + ".old";
  std::ofstream file(copy, std::ios::binary);
  const auto put = [&](const auto& bytes) {
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  };
  auto reader = recording::LogReader::open(log);
  std::int64_t number = 0;
  while (const auto event = reader->next()) {
    if (recording::topic_of(event->channel) == recording::name_of(recording::Topic::log_check))
      continue;
    put(recording::event_header(number++, event->utime, event->channel.size(),
                                event->bytes.size()));
    put(event->channel);
    put(event->bytes);
  }
  return copy;
}

// What `log verify` makes of a file.
struct Judgement {
  bool is_same = false;
  bool differs = false;
  std::int64_t cycles = 0;
};

Judgement judgement_of(const std::filesystem::path& log) {
  try {
    const ReplayResult result = replay(log, {});
    return {result.is_same(), result.difference.has_value(), result.cycles};
  } catch (const std::runtime_error&) {
    return {};
  }
}

constexpr const char* contour =
    "#1=0\nG64 P0.05\nM3 S1000\nwhile (#1 < 60) {\n"
    "G1 X[40*cos[#1*12]] Y[40*sin[#1*12]] F6000\n#1=[#1+1]\n}\nM5\nG0 X0 Y0\nM30\n";

// Operators at random, over drives at random.
class ReplayOfAnything : public ::testing::TestWithParam<int> {};

TEST_P(ReplayOfAnything, IsTheSameBitForBit) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  RecordedByChance run("mill3.toml", seed % 2 == 0 ? DriveChoice::simulated : DriveChoice::ideal,
                       seed);
  run.program("contour.nc", contour);
  run.run(200);
  for (int n = 0; n < 40; ++n) {
    switch (run.chance(9)) {
      case 0:
      case 1:
      case 2:
        run.ask(OperatorAction::program_run, 1, "contour.nc");
        break;
      case 3:
        run.ask(OperatorAction::program_hold, 1);
        break;
      case 4:
        run.ask(OperatorAction::program_resume, 1);
        break;
      case 5:
        run.ask(OperatorAction::override_feed, 1, "", 0.2 + 0.01 * run.chance(130));
        break;
      case 6:
        run.ask(OperatorAction::program_reset, 1);
        break;
      case 7:
        run.ask(OperatorAction::mdi, 1, "G0 X" + std::to_string(run.chance(50)));
        break;
      default:
        run.ask(OperatorAction::jog, 1, "Z", 20.0, run.chance(2) == 0 ? 3.0 : -3.0);
    }
    run.run(50 + run.chance(500));
  }
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_GT(result.setpoints, 2000);
  if (result.difference) {
    ADD_FAILURE() << "cycle " << result.difference->cycle << " " << result.difference->field << " "
                  << result.difference->recorded << " " << result.difference->repeated;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplayOfAnything, ::testing::Range(0, 12));

TEST(Replay, ALogSaysWhichMachineFileItIsOf) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 1);
  run.run(10);
  run.close();
  std::ifstream file(source_tree / "config" / "machines" / "mill3.toml", std::ios::binary);
  std::uint64_t fnv1a = 14695981039346656037U;
  for (char byte = 0; file.get(byte);)
    fnv1a = (fnv1a ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  const auto contents = recording::read_contents(run.path());
  ASSERT_TRUE(contents && contents->description);
  EXPECT_EQ(contents->description->config_hash, fnv1a);
}

// As after a daemon that ended elsewhere.
TEST(Replay, OfARunThatBeganWhereTheAxesStoodLast) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    RecordedByChance run("mill3.toml", drives, 5, {{"X", 31.0 / 3.0}, {"Z", -0.1}});
    run.program("line.nc", "G91\nG1 X3 Y1 F3000\nM30\n");
    run.ask(OperatorAction::program_run, 1, "line.nc");
    run.run(3000);
    run.close();
    EXPECT_TRUE(run.moved());
    EXPECT_TRUE(replay(run.path(), {}).is_same());
  }
}

// Kinematics that change, a master that starts a worker, marks.
TEST(Replay, OfTwoChannelsAndChangingKinematicsIsTheSame) {
  RecordedByChance run("e7106mf4.toml", DriveChoice::ideal, 7);
  run.program("flat.nc", "G0 X10 Y10 Z20\nG1 X20 F2000\nG0 X0 Y0\nM30\n");
  run.program("turned.nc", "G0 X10 B10 C30\nG1 X20 B20 C60 F2000\nG0 X0 B0 C0\nM30\n");
  run.program("master.nc",
              "#kinematics (1, 1)\nchannel_run (1, \"flat.nc\");\nchannel_wait (1);\n"
              "#kinematics (2, 1)\nchannel_run (1, \"turned.nc\");\nchannel_wait (1);\n"
              "#kinematics (1, 1)\nM30\n");
  run.ask(OperatorAction::program_run, 2, "master.nc");
  run.run(15000);
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_EQ(result.cycles, 15000);
}

// Force control over a simulated cut, with an operator: the repetition has the sensors, not the
// cut.
TEST(Replay, OfForceControlIsTheSameFromItsSensors) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    RecordedByChance run("lathe.toml", drives, 11);
    run.run(300);
    run.ask(OperatorAction::program_run, 1, "adaptive_steps.nc");
    run.run(12000);
    run.ask(OperatorAction::override_feed, 1, "", 0.8);
    run.run(1500);
    run.ask(OperatorAction::override_feed, 1, "", 1.0);
    run.ask(OperatorAction::program_hold, 1);
    run.run(500);
    run.ask(OperatorAction::program_resume, 1);
    run.run(6000);
    run.close();
    EXPECT_TRUE(run.moved());
    const ReplayResult result = replay(run.path(), {});
    EXPECT_TRUE(result.is_same());
    EXPECT_EQ(result.cycles, 20300);
  }
}

// A log with one bit of one set-point changed: its cycle, channel and axis are named.
TEST(Replay, FindsOneChangedBit) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 3);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(2000);
  run.close();
  constexpr std::int64_t changed_cycle = 1234;
  const auto copy =
      changed<setpoint_t>(run.path(), recording::Topic::setpoint, [](setpoint_t& one) {
        if (one.cycle == changed_cycle) one.position[1] = std::nextafter(one.position[1], 1e9);
      });
  EXPECT_TRUE(replay(run.path(), {}).is_same());
  const ReplayResult result = replay(copy, {});
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->cycle, changed_cycle);
  EXPECT_EQ(result.difference->channel, 1);
  EXPECT_EQ(result.difference->field, "position of Y");
  EXPECT_EQ(result.difference->units_in_last_place, 1U);
}

// Up to the cut everything is verified; the log as a whole is not.
TEST(Replay, OfALogThatWasCutGoesToTheCut) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 4);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(1500);
  run.close();
  std::filesystem::resize_file(run.path(), std::filesystem::file_size(run.path()) / 2 + 11);
  const ReplayResult result = replay(run.path(), {});
  EXPECT_FALSE(result.difference);
  EXPECT_TRUE(result.is_cut);
  EXPECT_EQ(result.cycles, result.setpoints);
  EXPECT_GT(result.setpoints, 500);
  EXPECT_LT(result.setpoints, 1500);
  ASSERT_FALSE(result.remarks.empty());
  EXPECT_THAT(result.remarks.back(),
              HasSubstr("everything up to cycle " + std::to_string(result.cycles) + " is sound"));
}

// Cut between two events, as far as the machine is known: never a difference, never whole.
TEST(Replay, OfALogThatWasCutBetweenEventsSaysSo) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 12);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(300);
  run.close();
  std::vector<std::int64_t> begins;
  auto reader = recording::LogReader::open(run.path());
  while (const auto event = reader->next()) begins.push_back(event->offset);
  int repeated = 0;
  for (std::size_t k = begins.size(); k-- > 0; k -= std::min<std::size_t>(k, 6)) {
    std::filesystem::resize_file(run.path(), static_cast<std::uintmax_t>(begins[k]));
    const Judgement judgement = judgement_of(run.path());
    EXPECT_FALSE(judgement.is_same) << "cut before event " << k;
    EXPECT_FALSE(judgement.differs) << "cut before event " << k;
    repeated += judgement.cycles > 0 ? 1 : 0;
  }
  EXPECT_GT(repeated, 10);
}

// Any byte: nothing of what is damaged is used, so that no difference is told that there was not.
TEST(Replay, NoticesAnyByteThatChanges) {
  RecordedByChance run("mill3.toml", DriveChoice::simulated, 13);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(200);
  run.close();
  EXPECT_TRUE(judgement_of(run.path()).is_same);
  std::fstream file(run.path(), std::ios::binary | std::ios::in | std::ios::out);
  const auto size = static_cast<int>(std::filesystem::file_size(run.path()));
  for (int n = 0; n < 200; ++n) {
    const int offset = run.chance(size);
    const auto put = [&](char byte) {
      file.seekp(offset);
      file.put(byte);
      file.flush();
    };
    file.seekg(offset);
    const char before = static_cast<char>(file.get());
    put(static_cast<char>(before ^ 1 << n % 8));
    const Judgement judgement = judgement_of(run.path());
    EXPECT_FALSE(judgement.is_same) << "byte " << offset;
    EXPECT_FALSE(judgement.differs) << "byte " << offset;
    put(before);
  }
  EXPECT_TRUE(judgement_of(run.path()).is_same);
}

// As stanok 0.1.0 made them.
TEST(Replay, OfALogWithoutCheckSumsSaysWhatIsNotCovered) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 14);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(500);
  run.close();
  const ReplayResult result = replay(without_checks(run.path()), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_FALSE(result.has_checks);
  EXPECT_EQ(result.cycles, 500);
  EXPECT_THAT(result.remarks, Contains(HasSubstr("without check sums")));
}

// More inputs in one cycle than the ring of the recorder holds: the same up to there, and no word
// of a difference.
TEST(Replay, OfALogThatLacksInputsGoesToTheLoss) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 8);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(1000);
  for (int n = 0; n < 5000; ++n) run.ask(OperatorAction::override_feed, 1, "", 0.5 + 0.0001 * n);
  run.run(1000);
  EXPECT_THAT(run.closing_word(), HasSubstr("W720"));
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_FALSE(result.difference);
  EXPECT_FALSE(result.is_same());
  EXPECT_EQ(result.lost_cycle, 1001);
  EXPECT_EQ(result.cycles, 1000);
  EXPECT_THAT(result.remarks, Contains(HasSubstr("W720")));
}

// The same of a log whose last record says so.
TEST(Replay, OfALogThatEndsWithALossSaysSo) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 9);
  run.run(100);
  run.close();
  const auto copy = changed<log_meta_t>(
      run.path(), recording::Topic::log_meta, [](log_meta_t&) {},
      [](recording::MessageStream& stream) {
        channels::InputRecord loss;
        loss.cycle = 101;
        loss.kind = channels::InputKind::lost;
        stream.input(loss);
      });
  const ReplayResult result = replay(copy, {});
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.lost_cycle, 101);
  EXPECT_EQ(result.cycles, 100);
}

TEST(Replay, OfALogThatLacksSetPointsGoesToTheGap) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 10);
  run.run(60);
  run.lose_outputs(5);
  run.run(40);
  run.close();
  const ReplayResult result = replay(run.path(), {});
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.lost_cycle, 61);
  EXPECT_EQ(result.cycles, 60);
}

// Inputs that no machine of this description can have had: told, and nothing worse.
TEST(Replay, OfALogWithForeignInputsIsRefused) {
  RecordedByChance run("mill3.toml", DriveChoice::simulated, 6);
  run.program("contour.nc", contour);
  run.ask(OperatorAction::program_run, 1, "contour.nc");
  run.run(500);
  run.close();
  for (const int method : {-1, 200, 256, 1 << 30}) {
    const auto copy = changed<input_t>(run.path(), recording::Topic::input,
                                       [&](input_t& input) { input.method = method; });
    EXPECT_THROW(static_cast<void>(replay(copy, {})), std::runtime_error) << method;
  }
  for (const int axis : {-1, 8, 1 << 30}) {
    const auto copy = changed<feedback_t>(run.path(), recording::Topic::feedback,
                                          [&](feedback_t& feedback) { feedback.axis = axis; });
    EXPECT_THROW(static_cast<void>(replay(copy, {})), std::runtime_error) << axis;
  }
  const auto copy = changed<setpoint_t>(run.path(), recording::Topic::setpoint,
                                        [](setpoint_t& one) { one.axis_count = 1 << 30; });
  static_cast<void>(replay(copy, {}));
}

TEST(Replay, OfWhatIsNoRunIsRefused) {
  const config::TemporaryFiles files;
  const auto path = files.write("empty.lcm", "");
  EXPECT_THROW(static_cast<void>(replay(path, {})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(replay(files.folder() / "none.lcm", {})), std::runtime_error);
}

}  // namespace
}  // namespace stanok::runtime
