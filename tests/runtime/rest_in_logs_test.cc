// A machine that rests most of the day, with encoders that flicker: its log is small, and repeats
// bit for bit.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "channels/machine/machine.h"
#include "recording/log/log_switch.h"
#include "recording/read/log_contents.h"
#include "recording/stream/message_stream.h"
#include "runtime/drive_side/steady_feedback.h"
#include "runtime/program_files.h"
#include "runtime/replay.h"
#include "runtime/run_setup.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

namespace fs = std::filesystem;

// The mill, whose drives follow at once and tell each position with an increment of noise; its log
// as the daemon writes it.
class FlickeringMill {
 public:
  FlickeringMill()
      : file_(config::read_machine_file(fs::path(stanok::testing::source_folder()) / "config" /
                                        "machines" / "mill3.toml")),
        machine_(file_.machine, programs_, setup_.options),
        steady_(file_.machine, file_.bus),
        told_(file_.machine.axes.size()) {
    auto writer = recording::LogWriter::open(log());
    writer_ = writer->get();
    switch_.turn_to(std::move(*writer), 0);
    stream_ =
        std::make_unique<recording::MessageStream>(description_of(file_, "test", this_build()),
                                                   std::vector<recording::MessageSink*>{&switch_});
    record_setup(setup_, file_, *stream_);
    for (std::size_t k = 0; k < told_.size(); ++k) position_.push_back(file_.machine.axes[k].start);
  }

  void ask(channels::OperatorAction action, const std::string& text = "") {
    channels::OperatorEvent event;
    event.id = ++last_id_;
    event.channel = 1;
    event.command =
        channels::command_of({.action = action, .text = std::string_view(text)}).value();
    events_.push_back(event);
  }
  void run(std::int64_t cycles) {
    for (std::int64_t n = 0; n < cycles; ++n) cycle();
  }
  [[nodiscard]] const channels::ChannelOutput& channel() const { return output_.channels[0]; }
  [[nodiscard]] std::int64_t bytes() const { return writer_->status().bytes; }
  [[nodiscard]] fs::path log() const { return files_.folder() / "run.lcm"; }
  void close() { switch_.turn_to(nullptr, 0); }

 private:
  void cycle() {
    static_cast<void>(machine_.prepare(0));
    for (std::size_t k = 0; k < told_.size(); ++k) {
      const double noise = 0.001 * (static_cast<int>(random_() % 3) - 1);
      told_[k] = {.position = position_[k] + noise,
                  .setpoint = position_[k],
                  .velocity = noise * 100.0,
                  .valid = true,
                  .enabled = is_on_[k],
                  .referenced = true,
                  .brake_closed = !is_on_[k]};
    }
    machine_.cycle({.events = events_, .feedback = steady_.of(told_, output_)}, output_);
    events_.clear();
    for (std::size_t k = 0; k < told_.size(); ++k) {
      position_[k] = channel().axes[k].position;
      is_on_[k] = channel().drives[k].enabled;
    }
    record();
  }
  void record() {
    for (const auto& read : texts_.take()) stream_->program_read(read, output_.cycle);
    channels::InputRecord input;
    while (machine_.input_records().pop(input)) stream_->input(input);
    channels::InputChange change;
    while (machine_.input_changes().pop(change)) stream_->input(change);
    stream_->cycle(output_);
    channels::Event event;
    while (machine_.events().pop(event)) stream_->event(event);
    channels::OperatorReply reply;
    while (machine_.replies().pop(reply)) {
    }
  }

  config::TemporaryFiles files_;
  RunSetup setup_{.options = {.changes_kept_s = 1e-3}};
  config::MachineFile file_;
  TextBook texts_;
  ProgramFiles programs_{{files_.folder()}, program_format(file_.machine), &texts_};
  channels::Machine machine_;
  SteadyFeedback steady_;
  std::vector<channels::AxisFeedback> told_;
  std::vector<double> position_;
  std::array<bool, 64> is_on_{};
  std::vector<channels::OperatorEvent> events_;
  channels::CycleOutput output_;
  std::uint64_t last_id_ = 0;
  std::mt19937 random_{7};
  recording::LogSwitch switch_;
  recording::LogWriter* writer_ = nullptr;
  std::unique_ptr<recording::MessageStream> stream_;
};

TEST(RestInLogs, ADayOfRestHasTwentyMegabytesAndRepeats) {
  constexpr std::int64_t minutes = 5;
  constexpr std::int64_t cycles = minutes * 60'000;
  constexpr std::int64_t of_a_day = std::int64_t{24} * 60 / minutes;
  FlickeringMill mill;
  mill.run(200);
  std::int64_t before = mill.bytes();
  mill.run(cycles);
  const std::int64_t off = (mill.bytes() - before) * of_a_day;
  EXPECT_LT(off, 20'000'000) << "drives off";
  mill.ask(channels::OperatorAction::machine_on);
  mill.run(2000);
  ASSERT_TRUE(mill.channel().drives[0].enabled);
  mill.ask(channels::OperatorAction::mdi, "G1 X5 F600");
  before = mill.bytes();
  mill.run(2000);
  EXPECT_NEAR(mill.channel().axes[0].position, 5.0, 1e-9);
  EXPECT_GT(mill.bytes() - before, 300'000) << "every cycle of a motion";
  before = mill.bytes();
  mill.run(cycles);
  const std::int64_t on = (mill.bytes() - before) * of_a_day;
  EXPECT_LT(on, 20'000'000) << "drives on";
  RecordProperty("bytes_a_day_off", std::to_string(off));
  RecordProperty("bytes_a_day_on", std::to_string(on));
  mill.close();
  const auto contents = recording::read_contents(mill.log());
  ASSERT_TRUE(contents);
  EXPECT_TRUE(contents->is_sound() && !contents->is_cut());
  EXPECT_EQ(contents->channels.at("STANOK_MILL3_CH1_SETPOINT").messages, 2 * cycles + 4200);
  EXPECT_EQ(contents->channels.at("STANOK_MILL3_CH1_SETPOINT").missing, 0);
  const ReplayResult result = replay(mill.log(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_TRUE(result.gaps.empty());
  EXPECT_EQ(result.setpoints, 2 * cycles + 4200);
}

}  // namespace
}  // namespace stanok::runtime
