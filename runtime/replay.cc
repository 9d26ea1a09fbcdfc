#include "runtime/replay.h"

#include <algorithm>
#include <bit>
#include <concepts>
#include <deque>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/numbered.h"
#include "base/place.h"
#include "channels/contract/operator_action.h"
#include "channels/machine/machine.h"
#include "protocol/contract/version.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "runtime/clock_gaps.h"
#include "runtime/force_controls.h"
#include "runtime/run_stream.h"

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

// Of one field of a setpoint; `axis` below 0: it has one value.
struct FieldDifference {
  const char* field = "";
  int axis = -1;
  double recorded = 0.0;
  double repeated = 0.0;
  std::uint64_t units_in_last_place = 0;
};

// Compares one setpoint, field by field. Axes are numbered: their names come later.
class Comparison {
 public:
  Comparison(const setpoint_t& recorded, const setpoint_t& repeated, std::size_t axes)
      : recorded_(recorded), repeated_(repeated), axes_(axes) {}

  [[nodiscard]] std::optional<FieldDifference> first() {
    axes("position", recorded_.position, repeated_.position);
    axes("velocity", recorded_.velocity, repeated_.velocity);
    axes("acceleration", recorded_.acceleration, repeated_.acceleration);
    axes("jerk", recorded_.jerk, repeated_.jerk);
    axes("programmed position", recorded_.tip_position, repeated_.tip_position);
    axes("programmed velocity", recorded_.tip_velocity, repeated_.tip_velocity);
    axes("position code", recorded_.position_code, repeated_.position_code);
    axes("velocity code", recorded_.velocity_code, repeated_.velocity_code);
    one("path speed", recorded_.path_speed, repeated_.path_speed);
    one("feed", recorded_.feed_commanded, repeated_.feed_commanded);
    one("feed override", recorded_.feed_override, repeated_.feed_override);
    one("state", recorded_.state, repeated_.state);
    one("flags", recorded_.flags, repeated_.flags);
    one("run", recorded_.run, repeated_.run);
    one("line", recorded_.line, repeated_.line);
    one("block", recorded_.block, repeated_.block);
    one("scheme", recorded_.scheme, repeated_.scheme);
    one("drives on", recorded_.drives_enabled, repeated_.drives_enabled);
    one("brakes", recorded_.brakes_closed, repeated_.brakes_closed);
    return difference_;
  }

 private:
  static bool is_same(std::integral auto recorded, std::integral auto repeated) {
    return recorded == repeated;
  }
  static bool is_same(double recorded, double repeated) { return same_bits(recorded, repeated); }
  static std::uint64_t units(std::integral auto /*recorded*/, std::integral auto /*repeated*/) {
    return 0;
  }
  static std::uint64_t units(double recorded, double repeated) {
    return units_between(recorded, repeated);
  }

  template <class Value>
  void one(const char* field, Value recorded, Value repeated, int axis = -1) {
    if (difference_ || is_same(recorded, repeated)) return;
    difference_ = FieldDifference{field, axis, static_cast<double>(recorded),
                                  static_cast<double>(repeated), units(recorded, repeated)};
  }
  template <class Values>
  void axes(const char* field, const Values& recorded, const Values& repeated) {
    for (std::size_t k = 0; k < axes_; ++k)
      one(field, recorded[k], repeated[k], static_cast<int>(k));
  }

  const setpoint_t& recorded_;
  const setpoint_t& repeated_;
  std::size_t axes_;
  std::optional<FieldDifference> difference_;
};

// Records in the order of their cycles, those of one cycle in the order in which they came.
template <class Record>
class Pending {
 public:
  void add(std::vector<Record>& records) {
    for (Record& record : records) {
      const bool is_last = records_.empty() || records_.back().cycle <= record.cycle;
      const auto later = is_last
                             ? records_.end()
                             : std::ranges::upper_bound(records_, record.cycle, {}, &Record::cycle);
      records_.insert(later, std::move(record));
    }
    records.clear();
  }
  // Calls `take` with each up to this cycle, which are forgotten then.
  template <class Take>
  void take_up_to(std::int64_t cycle, const Take& take) {
    for (; !records_.empty() && records_.front().cycle <= cycle; records_.pop_front())
      take(records_.front());
  }

  // Calls `look` with each up to this cycle.
  template <class Look>
  void look_up_to(std::int64_t cycle, const Look& look) const {
    for (const Record& record : records_) {
      if (record.cycle > cycle) return;
      look(record);
    }
  }

 private:
  std::deque<Record> records_;
};

// The machine of the log, given the inputs of each cycle.
class Repetition {
 public:
  // Both outlive the repetition.
  Repetition(RunBeginning& beginning, const RecordedFiles& files)
      : config_(beginning.machine.machine),
        force_controls_(beginning.machine),
        machine_(config_, files, force_controls_.given_to(beginning.setup.options)),
        feedback_(config_.axes.size()),
        sensors_(config_.spindles.size()),
        arrivals_(config_.channels.size()),
        recorded_(config_.channels.size()) {
    for (const auto& [channel, scheme] : beginning.setup.schemes)
      static_cast<void>(machine_.select_scheme_at_start(channel, scheme));
  }

  // What the next cycles are given.
  void add(LogPart& part) {
    has_feedback_ = has_feedback_ || !part.feedback.empty();
    for (const channels::InputRecord& input : part.inputs) know(input);
    pending_.inputs.add(part.inputs);
    pending_.feedback.add(part.feedback);
    pending_.arrivals.add(part.arrivals);
    // Inputs of later cycles may follow in the next part.
    if (!part.setpoints.empty()) know_up_to(part.setpoints.back().cycle);
  }

  // The next cycle. What it needs of the program has been prepared: at least as far ahead as in the
  // recorded run.
  const channels::CycleOutput& cycle() {
    const std::int64_t cycle = output_.cycle + 1;
    events_.clear();
    pending_.inputs.take_up_to(cycle, [&](const channels::InputRecord& input) { take(input); });
    pending_.feedback.take_up_to(cycle, [&](const RecordedFeedback& told) { take(told); });
    pending_.arrivals.take_up_to(cycle, [&](const RecordedArrival& arrival) {
      if (const int index = index_of(arrival.channel); index >= 0) arrivals_[index] = arrival.value;
    });
    prepare();
    channels::CycleInputs inputs{.events = events_, .feedback = {}, .sensors = sensors_};
    if (has_feedback_) inputs.feedback = feedback_;
    inputs.signals = &signals_;
    inputs.arrivals = arrivals_;
    inputs.gap = std::exchange(gap_, {});
    machine_.cycle(inputs, output_);
    forget_news();
    return output_;
  }

 private:
  void know_up_to(std::int64_t cycle) {
    pending_.arrivals.look_up_to(cycle, [&](const RecordedArrival& arrival) {
      if (const int index = index_of(arrival.channel); index >= 0)
        recorded_[index].known = arrival.value;
    });
  }
  void know(const channels::InputRecord& input) {
    const auto* const taking = std::get_if<channels::TableTaking>(&input.content);
    const int index = taking != nullptr ? index_of(input.channel) : -1;
    if (index >= 0) recorded_[index].takings.push_back(*taking);
  }

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
    const channels::Progress progress = machine_.prepare(channel, recorded_[channel]);
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
    gap_ = ClockGaps(config_).gap_of(overrun.periods, machine_);
  }
  // The preparation repeats it.
  void take(const channels::InputRecord& /*input*/, const channels::TableTaking& /*taking*/) {}
  // It changed nothing in the cycle.
  void take(const channels::InputRecord& /*input*/, const channels::LostInputs& /*lost*/) {}

  static void refuse(const channels::InputRecord& input) {
    throw std::runtime_error("the log has an input in cycle " + std::to_string(input.cycle) +
                             " that its machine does not have");
  }

  void take(const RecordedFeedback& feedback) {
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

  const channels::MachineConfig& config_;
  ForceControls force_controls_;
  channels::Machine machine_;
  std::vector<channels::OperatorEvent> events_;
  NumberedList<channels::AxisFeedback> feedback_;
  std::vector<channels::SpindleSensors> sensors_;
  NumberedList<channels::Arrivals> arrivals_;
  NumberedList<channels::RecordedWork> recorded_;
  Signals signals_;
  channels::ClockGap gap_;  // before the next cycle
  channels::CycleOutput output_;
  std::uint64_t last_id_ = 0;
  struct {
    Pending<channels::InputRecord> inputs;
    Pending<RecordedFeedback> feedback;
    Pending<RecordedArrival> arrivals;
  } pending_;
  bool has_feedback_ = false;
};

// Whether the log is as it was written, and whole.
void remark_on_bytes(const recording::LogContents& contents, ReplayResult& result) {
  const recording::LogCoverage& coverage = contents.coverage;
  result.has_checks = coverage.has_checks;
  result.is_cut = contents.is_cut();
  for (const recording::Damage& damage : contents.damage) {
    if (damage.kind == recording::DamageKind::cut) continue;
    result.is_damaged = true;
    result.remarks.push_back("the log is damaged: bytes " + std::to_string(damage.offset) + " to " +
                             std::to_string(damage.offset + damage.bytes - 1) +
                             " have changed since they were written");
  }
  if (!coverage.has_checks) {
    result.remarks.emplace_back(
        "recorded without checksums, as by stanok 0.1.0: only what is compared is covered, "
        "that is setpoints and, through them, the inputs; other bytes of the log may have changed "
        "unnoticed");
  }
  if (coverage.end == recording::LogEnd::next_piece)
    result.remarks.emplace_back("the recording continues in its next file, which is not verified");
}

void remark_on(const recording::LogContents& contents, ReplayResult& result) {
  const auto& description = contents.description;
  if (description && description->format > recording::log_format) {
    result.remarks.push_back("the log has format " + std::to_string(description->format) +
                             ", but this version reads formats up to " +
                             std::to_string(recording::log_format) +
                             ": missing parts may go unnoticed");
  }
  if (description && description->version != protocol::version) {
    result.remarks.push_back("recorded by stanok " + description->version + ", but this is " +
                             std::string(protocol::version) +
                             ": another version may plan motion differently; use the version that "
                             "recorded the log to replay it");
  }
  if (description && !description->build.starts_with(this_build())) {
    result.remarks.push_back("recorded by another build (" + description->build +
                             "): only equal builds are guaranteed to give equal bits");
  }
  if (description && description->libm != recording::this_libm())
    result.remarks.push_back("recorded with another C library: " + description->libm);
  remark_on_bytes(contents, result);
}

void remark_on_gaps(ReplayResult& result) {
  constexpr std::size_t told_max = 10;
  for (std::size_t k = 0; k < std::min(result.gaps.size(), told_max); ++k) {
    const SetpointGap& gap = result.gaps[k];
    result.remarks.push_back(
        "the log has no setpoints of cycles " + std::to_string(gap.first) + " to " +
        std::to_string(gap.last) +
        ", because the recorder was too slow; they are computed again but not compared");
  }
  if (result.gaps.size() > told_max)
    result.remarks.push_back(std::to_string(result.gaps.size() - told_max) +
                             " more gaps of this kind");
}

// When all that can be has been compared.
void remark_on_end(const recording::LogContents& contents, ReplayResult& result) {
  const std::string sound =
      result.lost_cycle || result.difference
          ? std::string()
          : "; everything up to cycle " + std::to_string(result.cycles) + " is sound";
  if (result.is_cut && contents.coverage.has_checks) {
    result.remarks.push_back(
        "the log ends without its trailer: the recording was cut (power failure, kill, full disk) "
        "or is still running" +
        sound);
  } else if (result.is_cut) {
    result.remarks.push_back("the log is cut at byte " +
                             std::to_string(contents.damage.back().offset) + sound);
  }
}

// The setpoints of the log, one by one, each against that of its cycle.
class Verification {
 public:
  Verification(RunStream& stream, const std::function<void(double)>& progress,
               std::uintmax_t bytes_of_log)
      : stream_(stream),
        progress_(progress),
        bytes_of_log_(std::max<double>(1.0, static_cast<double>(bytes_of_log))),
        beginning_(stream.beginning()),
        files_(stream.files()),
        repetition_(beginning_, *files_) {}

  void verify(ReplayResult& result) {
    while (auto part = stream_.next()) {
      for (const channels::InputRecord& input : part->inputs) note_loss(input);
      repetition_.add(*part);
      for (const setpoint_t& recorded : part->setpoints) {
        if (!verify(recorded, *part, result)) return;
      }
    }
    if (lost_cycle_) end_at_loss("inputs", *lost_cycle_, result);
  }

  // The first difference, once the log tells how its axes are called.
  [[nodiscard]] std::optional<SetpointDifference> difference(
      const recording::LogContents& contents) const {
    if (!difference_) return std::nullopt;
    std::string field = difference_->field;
    if (difference_->axis >= 0) {
      const std::size_t axis = checked_size(difference_->axis);
      field +=
          " of " +
          recording::axes_of(contents, different_.channel, axis_count_of(different_)).at(axis).name;
    }
    return SetpointDifference{different_.cycle,      different_.channel,
                              std::move(field),      difference_->recorded,
                              difference_->repeated, difference_->units_in_last_place};
  }

 private:
  static void end_at_loss(const std::string& what, std::int64_t cycle, ReplayResult& result) {
    result.lost_cycle = cycle;
    result.remarks.push_back(
        "W720 " + what + " are missing from cycle " + std::to_string(cycle) +
        " on, because the recorder was too slow; nothing after that can be replayed");
  }
  static int axis_count_of(const setpoint_t& setpoint) {
    return std::clamp(setpoint.axis_count, 0, static_cast<std::int32_t>(motion::axes_max));
  }

  void note_loss(const channels::InputRecord& input) {
    if (std::holds_alternative<channels::LostInputs>(input.content))
      lost_cycle_ = std::min(lost_cycle_.value_or(input.cycle), input.cycle);
  }

  // False: nothing behind it can be compared.
  bool verify(const setpoint_t& recorded, const LogPart& part, ReplayResult& result) {
    if (lost_cycle_ && recorded.cycle >= *lost_cycle_) {
      end_at_loss("inputs", *lost_cycle_, result);
      return false;
    }
    if (recorded.cycle > cycle_ + 1) {
      // With the setpoints stanok 0.1.0 lost inputs, too.
      if (!part.is_checked) {
        end_at_loss("setpoints", cycle_ + 1, result);
        return false;
      }
      result.gaps.push_back({cycle_ + 1, recorded.cycle - 1});
    }
    while (recorded.cycle > cycle_) advance(result, part.bytes_read);
    compare(recorded, result);
    return !difference_;
  }

  void advance(ReplayResult& result, std::int64_t bytes) {
    output_ = &repetition_.cycle();
    cycle_ = output_->cycle;
    ++result.cycles;
    if (progress_ && cycle_ % progress_interval == 0)
      progress_(static_cast<double>(bytes) / bytes_of_log_);
  }

  void compare(const setpoint_t& recorded, ReplayResult& result) {
    const channels::ChannelOutput* channel =
        output_ == nullptr ? nullptr : output_->of_channel(recorded.channel);
    if (channel == nullptr)
      throw std::runtime_error(
          "the log has setpoints of a channel that its "
          "machine does not have");
    const setpoint_t repeated = recording::to_setpoint(
        *channel, {.utime = recorded.utime, .cycle = recorded.cycle, .seq = recorded.seq});
    difference_ = Comparison(recorded, repeated, checked_size(axis_count_of(recorded))).first();
    if (difference_) different_ = recorded;
    ++result.setpoints;
  }

  RunStream& stream_;
  const std::function<void(double)>& progress_;
  double bytes_of_log_;
  RunBeginning beginning_;
  std::shared_ptr<const RecordedFiles> files_;
  Repetition repetition_;
  const channels::CycleOutput* output_ = nullptr;
  std::int64_t cycle_ = 0;
  std::optional<std::int64_t> lost_cycle_;
  std::optional<FieldDifference> difference_;
  setpoint_t different_{};
};

}  // namespace

ReplayResult replay(const std::filesystem::path& log, const std::function<void(double)>& progress) {
  RunStream stream(log);
  std::error_code unknown_size;
  Verification verification(stream, progress, std::filesystem::file_size(log, unknown_size));
  ReplayResult found;
  verification.verify(found);
  const recording::LogContents contents = stream.contents();
  found.difference = verification.difference(contents);
  ReplayResult result = found;
  result.remarks.clear();
  remark_on(contents, result);
  std::ranges::move(found.remarks, std::back_inserter(result.remarks));
  remark_on_gaps(result);
  remark_on_end(contents, result);
  return result;
}

}  // namespace stanok::runtime
