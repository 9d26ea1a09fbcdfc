#include "runtime/replay.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/numbered.h"
#include "base/place.h"
#include "channels/contract/operator_action.h"
#include "channels/machine/machine.h"
#include "protocol/version.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "runtime/clock_gaps.h"
#include "runtime/force_controls.h"
#include "runtime/recorded_run.h"

namespace stanok::runtime {
namespace {

constexpr std::int64_t progress_interval = 1000;  // cycles

// Doubles in the order of their bits, so that neighbours differ by one.
std::uint64_t units_between(double one, double other) {
  const auto place = [](double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const std::int64_t a = place(one);
  const std::int64_t b = place(other);
  return a > b ? static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b)
               : static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a);
}

bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

// Compares one setpoint, field by field.
class Comparison {
 public:
  Comparison(const setpoint_t& recorded, const setpoint_t& repeated,
             std::vector<recording::AxisDescription> axes)
      : recorded_(recorded), repeated_(repeated), axes_(std::move(axes)) {}

  [[nodiscard]] std::optional<SetpointDifference> first() {
    axes("position", recorded_.position, repeated_.position);
    axes("velocity", recorded_.velocity, repeated_.velocity);
    axes("acceleration", recorded_.acceleration, repeated_.acceleration);
    axes("jerk", recorded_.jerk, repeated_.jerk);
    axes("programmed position", recorded_.tip_position, repeated_.tip_position);
    axes("programmed velocity", recorded_.tip_velocity, repeated_.tip_velocity);
    codes("position code", recorded_.position_code, repeated_.position_code);
    codes("velocity code", recorded_.velocity_code, repeated_.velocity_code);
    real("path speed", recorded_.path_speed, repeated_.path_speed);
    real("feed", recorded_.feed_commanded, repeated_.feed_commanded);
    real("feed override", recorded_.feed_override, repeated_.feed_override);
    whole("state", recorded_.state, repeated_.state);
    whole("flags", recorded_.flags, repeated_.flags);
    whole("run", recorded_.run, repeated_.run);
    whole("line", recorded_.line, repeated_.line);
    whole("block", recorded_.block, repeated_.block);
    whole("scheme", recorded_.scheme, repeated_.scheme);
    whole("drives on", recorded_.drives_enabled, repeated_.drives_enabled);
    whole("brakes", recorded_.brakes_closed, repeated_.brakes_closed);
    return difference_;
  }

 private:
  void real(const std::string& field, double recorded, double repeated) {
    if (difference_ || same_bits(recorded, repeated)) return;
    note(field, recorded, repeated);
    difference_->units_in_last_place = units_between(recorded, repeated);
  }
  void whole(const std::string& field, std::int64_t recorded, std::int64_t repeated) {
    if (difference_ || recorded == repeated) return;
    note(field, static_cast<double>(recorded), static_cast<double>(repeated));
  }
  template <class Values>
  void axes(const std::string& field, const Values& recorded, const Values& repeated) {
    for (std::size_t k = 0; k < axes_.size(); ++k)
      real(field + " of " + axes_[k].name, recorded[k], repeated[k]);
  }
  template <class Values>
  void codes(const std::string& field, const Values& recorded, const Values& repeated) {
    for (std::size_t k = 0; k < axes_.size(); ++k)
      whole(field + " of " + axes_[k].name, recorded[k], repeated[k]);
  }
  void note(const std::string& field, double recorded, double repeated) {
    difference_ = SetpointDifference{recorded_.cycle, recorded_.channel, field, recorded, repeated};
  }

  const setpoint_t& recorded_;
  const setpoint_t& repeated_;
  std::vector<recording::AxisDescription> axes_;
  std::optional<SetpointDifference> difference_;
};

// The machine of the log, given the inputs of each cycle.
class Repetition {
 public:
  explicit Repetition(RecordedRun& run)
      : run_(run),
        config_(run.machine.machine),
        force_controls_(run.machine),
        machine_(config_, run.files, force_controls_.given_to(run.setup.options)),
        feedback_(config_.axes.size()),
        sensors_(config_.spindles.size()),
        arrivals_(config_.channels.size()),
        gaps_(config_) {
    for (const auto& [channel, scheme] : run.setup.schemes)
      static_cast<void>(machine_.select_scheme_at_start(channel, scheme));
  }

  // The next cycle. What it needs of the program has been prepared: at least as far ahead as in the
  // recorded run.
  const channels::CycleOutput& cycle() {
    const std::int64_t cycle = output_.cycle + 1;
    events_.clear();
    for (; next_input_ < run_.inputs.size() && run_.inputs[next_input_].cycle <= cycle;
         ++next_input_) {
      take(run_.inputs[next_input_]);
    }
    for (; next_feedback_ < run_.feedback.size() && run_.feedback[next_feedback_].cycle <= cycle;
         ++next_feedback_) {
      take(run_.feedback[next_feedback_]);
    }
    for (; next_arrival_ < run_.arrivals.size() && run_.arrivals[next_arrival_].cycle <= cycle;
         ++next_arrival_) {
      const RecordedRun::Arrival& arrival = run_.arrivals[next_arrival_];
      if (const int index = index_of(arrival.channel); index >= 0) arrivals_[index] = arrival.value;
    }
    prepare();
    channels::CycleInputs inputs{.events = events_, .feedback = {}, .sensors = sensors_};
    if (!run_.feedback.empty()) inputs.feedback = feedback_;
    inputs.signals = &signals_;
    inputs.arrivals = arrivals_;
    inputs.gap = std::exchange(gap_, {});
    machine_.cycle(inputs, output_);
    forget_news();
    return output_;
  }

 private:
  // A preparation that only computes goes on until it has made what the recorded cycle saw.
  void prepare() {
    bool worked = true;
    while (worked) {
      worked = false;
      for (int k = 0; k < static_cast<int>(config_.channels.size()); ++k) {
        while (prepare_step(k)) worked = true;
      }
    }
  }
  bool prepare_step(int channel) {
    const channels::Progress progress = machine_.prepare(channel);
    if (progress != channels::Progress::computing) return progress == channels::Progress::worked;
    return !machine_.has_prepared(channel, arrivals_[channel]);
  }

  [[nodiscard]] int index_of(int channel) const {
    for (std::size_t k = 0; k < config_.channels.size(); ++k) {
      if (config_.channels[k].id == channel) return static_cast<int>(k);
    }
    return -1;
  }

  void take(const channels::InputRecord& input) {
    std::visit([&](const auto& content) { take(input, content); }, input.content);
  }
  void take(const channels::InputRecord& input, const channels::OperatorCommand& command) {
    channels::OperatorEvent event;
    event.id = ++last_id_;
    event.channel = input.channel;
    event.command = command;
    events_.push_back(event);
  }
  void take(const channels::InputRecord& /*input*/, const channels::DigitalInput& input) {
    signals_.set(input.number, input.is_on);
  }
  void take(const channels::InputRecord& /*input*/, const channels::AnalogInput& input) {
    signals_.analog.at(checked_size(input.number)) = input.value;
  }
  void take(const channels::InputRecord& record, const channels::SpindleInput& input) {
    const auto spindle = checked_size(input.spindle);
    if (spindle >= sensors_.size()) return refuse(record);
    switch (input.quantity) {
      case channels::SpindleQuantity::power_w:
        sensors_[spindle].power_w = input.value;
        break;
      case channels::SpindleQuantity::vibration_um:
        sensors_[spindle].vibration_um = input.value;
        break;
      case channels::SpindleQuantity::vibration_hz:
        sensors_[spindle].vibration_hz = input.value;
        break;
    }
  }
  // Logs may come from anywhere.
  void take(const channels::InputRecord& input, const channels::UnknownInput& /*unknown*/) {
    refuse(input);
  }
  void take(const channels::InputRecord& /*input*/, const channels::Overrun& overrun) {
    gap_ = gaps_.gap_of(overrun.periods);
  }
  // It changed nothing in the cycle.
  void take(const channels::InputRecord& /*input*/, const channels::LostInputs& /*lost*/) {}

  static void refuse(const channels::InputRecord& input) {
    throw std::runtime_error("the log has an input in cycle " + std::to_string(input.cycle) +
                             " that its machine does not have");
  }

  void take(const RecordedRun::Feedback& feedback) {
    const int index = index_of(feedback.channel);
    if (index < 0) return;
    const std::vector<int>& axes = config_.channels[index].axes;
    if (feedback.axis < 0 || feedback.axis >= static_cast<int>(axes.size())) {
      throw std::runtime_error("the log has feedback of an axis that its machine does not have");
    }
    feedback_[axes[checked_size(feedback.axis)]] = feedback.value;
  }

  void forget_news() {
    channels::Event event;
    while (machine_.events().pop(event)) {
    }
    channels::InputRecord input;
    while (machine_.input_records().pop(input)) {
    }
    channels::OperatorReply reply;
    while (machine_.replies().pop(reply) || machine_.stop_replies().pop(reply)) {
    }
  }

  RecordedRun& run_;
  const channels::MachineConfig& config_;
  ForceControls force_controls_;
  channels::Machine machine_;
  std::vector<channels::OperatorEvent> events_;
  NumberedList<channels::AxisFeedback> feedback_;
  std::vector<channels::SpindleSensors> sensors_;
  NumberedList<channels::Arrivals> arrivals_;
  Signals signals_;
  ClockGaps gaps_;
  channels::ClockGap gap_;  // before the next cycle
  channels::CycleOutput output_;
  std::uint64_t last_id_ = 0;
  std::size_t next_input_ = 0;
  std::size_t next_feedback_ = 0;
  std::size_t next_arrival_ = 0;
};

// Whether the log is as it was written, and whole.
void remark_on_bytes(const recording::LogContents& contents, ReplayResult& result) {
  const recording::LogCoverage& coverage = contents.coverage;
  result.has_checks = coverage.has_checks;
  result.is_cut = contents.is_cut();
  for (const recording::Damage& damage : contents.damage) {
    if (damage.kind == recording::DamageKind::cut) continue;
    result.is_damaged = true;
    result.remarks.push_back("the log is damaged: the bytes " + std::to_string(damage.offset) +
                             " to " + std::to_string(damage.offset + damage.bytes - 1) +
                             " are not as they were written");
  }
  if (!coverage.has_checks) {
    result.remarks.emplace_back(
        "recorded without check sums, as by stanok 0.1.0: only what is compared is covered, "
        "setpoints and through them the inputs; other bytes of the log may have changed "
        "unnoticed");
  }
  if (coverage.end == recording::LogEnd::next_piece)
    result.remarks.emplace_back("the recording goes on in its next file, which is not verified");
}

void remark_on(const RecordedRun& run, ReplayResult& result) {
  const auto& description = run.contents.description;
  if (description && description->version != protocol::version) {
    result.remarks.push_back("recorded by stanok " + description->version + ", and this is " +
                             std::string(protocol::version) +
                             ": another version may plan motion anew; a log repeats with the "
                             "version that recorded it");
  }
  if (description && !description->build.starts_with(this_build())) {
    result.remarks.push_back("recorded by another build (" + description->build +
                             "): equal bits are promised for equal builds only");
  }
  if (description && description->libm != recording::this_libm())
    result.remarks.push_back("recorded with another C library: " + description->libm);
  remark_on_bytes(run.contents, result);
}

void remark_on_gaps(ReplayResult& result) {
  constexpr std::size_t told_max = 10;
  for (std::size_t k = 0; k < std::min(result.gaps.size(), told_max); ++k) {
    const SetpointGap& gap = result.gaps[k];
    result.remarks.push_back("the log has no setpoints of the cycles " + std::to_string(gap.first) +
                             " to " + std::to_string(gap.last) +
                             ", the recorder fell behind; they are repeated and not compared");
  }
  if (result.gaps.size() > told_max)
    result.remarks.push_back(std::to_string(result.gaps.size() - told_max) + " more such gaps");
}

// When all that can be has been compared.
void remark_on_end(const RecordedRun& run, ReplayResult& result) {
  const std::string sound =
      result.lost_cycle || result.difference
          ? std::string()
          : ", everything up to cycle " + std::to_string(result.cycles) + " is sound";
  if (result.is_cut && run.contents.coverage.has_checks) {
    result.remarks.push_back(
        "the log ends without its trailer: the recording was cut (power failure, kill, full disk) "
        "or still goes on" +
        sound);
  } else if (result.is_cut) {
    result.remarks.push_back("the log is cut at byte " +
                             std::to_string(run.contents.damage.back().offset) + sound);
  }
}

// The setpoints of the log, one by one, each against that of its cycle.
class Verification {
 public:
  Verification(RecordedRun& run, const std::function<void(double)>& progress)
      : run_(run), progress_(progress), repetition_(run) {}

  void verify(const std::filesystem::path& log, ReplayResult& result) {
    auto reader = recording::LogReader::open(log);
    if (!reader) throw std::runtime_error(reader.error().text);
    const std::int64_t end = usable_bytes(run_.contents);
    for (auto event = reader->next(); event && event->offset < end; event = reader->next()) {
      if (recording::topic_of(event->channel) != recording::name_of(recording::Topic::setpoint))
        continue;
      const auto recorded = recording::decode<setpoint_t>(event->bytes);
      if (!recorded) continue;
      if (run_.lost_cycle && recorded->cycle >= *run_.lost_cycle)
        return end_at_loss("inputs", *run_.lost_cycle, result);
      if (recorded->cycle > cycle_ + 1) {
        // With the setpoints stanok 0.1.0 lost inputs, too.
        if (!result.has_checks) return end_at_loss("setpoints", cycle_ + 1, result);
        result.gaps.push_back({cycle_ + 1, recorded->cycle - 1});
      }
      while (recorded->cycle > cycle_) advance(result, reader->bytes_read());
      compare(*recorded, result);
      if (result.difference) return;
    }
    if (run_.lost_cycle) end_at_loss("inputs", *run_.lost_cycle, result);
  }

 private:
  static void end_at_loss(const std::string& what, std::int64_t cycle, ReplayResult& result) {
    result.lost_cycle = cycle;
    result.remarks.push_back("W720 " + what + " are missing from cycle " + std::to_string(cycle) +
                             " on, the recorder fell behind; nothing from there on can be "
                             "repeated");
  }

  void advance(ReplayResult& result, std::int64_t bytes) {
    output_ = &repetition_.cycle();
    cycle_ = output_->cycle;
    ++result.cycles;
    if (progress_ && cycle_ % progress_interval == 0) {
      progress_(static_cast<double>(bytes) /
                static_cast<double>(std::max<std::int64_t>(1, run_.contents.bytes)));
    }
  }

  void compare(const setpoint_t& recorded, ReplayResult& result) const {
    const channels::ChannelOutput* channel = output_->of_channel(recorded.channel);
    if (channel == nullptr)
      throw std::runtime_error(
          "the log has setpoints of a channel that its "
          "machine does not have");
    const setpoint_t repeated = recording::to_setpoint(
        *channel, {.utime = recorded.utime, .cycle = recorded.cycle, .seq = recorded.seq});
    result.difference =
        Comparison(recorded, repeated,
                   recording::axes_of(run_.contents, recorded.channel,
                                      std::clamp(recorded.axis_count, 0,
                                                 static_cast<std::int32_t>(motion::axes_max))))
            .first();
    ++result.setpoints;
  }

  RecordedRun& run_;
  const std::function<void(double)>& progress_;
  Repetition repetition_;
  const channels::CycleOutput* output_ = nullptr;
  std::int64_t cycle_ = 0;
};

}  // namespace

ReplayResult replay(const std::filesystem::path& log, const std::function<void(double)>& progress) {
  const auto run = read_run(log);
  ReplayResult result;
  remark_on(*run, result);
  Verification(*run, progress).verify(log, result);
  remark_on_gaps(result);
  remark_on_end(*run, result);
  return result;
}

}  // namespace stanok::runtime
