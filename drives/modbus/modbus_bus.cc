// The bus thread: one round over all drives per poll, at absolute times, and between the rounds
// those again that did not answer.
#include "drives/modbus/modbus_bus.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "base/assert.h"
#include "base/place.h"

namespace stanok::drives {
namespace {

constexpr BusTime pause_max = std::chrono::seconds{1};

// Samples that wait for the cycle: those of a second.
constexpr double kept_s = 1.0;
// Level and frequency are those of a quarter of a second.
constexpr double stretch_s = 0.25;

std::uint32_t cycles_in(int timeout_ms, Duration cycle) {
  return static_cast<std::uint32_t>(std::ceil(timeout_ms * millisecond / cycle));
}

}  // namespace

ModbusBus::ModbusBus(BusConfig config, Duration cycle)
    : ModbusBus(config, cycle, std::make_unique<ModbusLink>(config)) {}

ModbusBus::ModbusBus(BusConfig config, Duration cycle, std::unique_ptr<ModbusLink> link)
    : config_(std::move(config)),
      poll_(std::chrono::milliseconds{config_.poll_ms}),
      timeout_(std::chrono::milliseconds{config_.timeout_ms}),
      timeout_cycles_(cycles_in(config_.timeout_ms, cycle)),
      epoch_(std::chrono::steady_clock::now()),
      drives_(drives_of(config_)),
      boxes_(drives_.size()),
      link_(std::move(link)),
      signals_(config_.signals, timeout_) {
  STANOK_ASSERT(config_.poll_ms > 0 && config_.timeout_ms > 0 && cycle > Duration{});
  status_.endpoint = link_->endpoint();
  for (const AxisDriveConfig& axis : drives_) {
    axes_.emplace_back(axis, poll_, timeout_);
    asking_.push_back({.patience = Patience(timeout_)});
    plans_.push_back({.look = look_plan(axis),
                      .run = exchange_plan(axis, WriteOrder::target_first),
                      .stop = exchange_plan(axis, WriteOrder::control_word_first)});
    images_.emplace_back(checked_size(register_count(axis.map)));
    status_.axes.push_back({.axis = axis.axis});
  }
  signal_patience_.assign(signals_.blocks().size(), Patience(timeout_));
  for (const VibrationSensorConfig& sensor : config_.vibration_sensors) {
    sensors_.emplace_back(sensor, timeout_);
    status_.vibration.push_back({.sensor = sensor.name()});
  }
}

ModbusBus::Sensor::Sensor(const VibrationSensorConfig& config, BusTime timeout)
    : block{.unit = config.unit,
            .table = SignalTable::holding_register,
            .first = config.first_register,
            .bits = {},
            .words = std::vector<std::uint16_t>(checked_size(config.count) + 1)},
      reader(config),
      meter(config.rate_hz, stretch_s),
      samples(checked_size(std::ceil(kept_s * config.rate_hz)) + 1),
      asking{.patience = Patience(timeout)} {}

ModbusBus::~ModbusBus() {
  stop();
}

void ModbusBus::start() {
  STANOK_ASSERT(!thread_.joinable());
  thread_ = std::jthread([this](const std::stop_token& stop_requested) { run(stop_requested); });
}

void ModbusBus::stop() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
}

void ModbusBus::write(std::span<const DriveTarget> targets) RT_SAFE {
  const std::size_t count = std::min(targets.size(), boxes_.size());
  for (std::size_t axis = 0; axis < count; ++axis) {
    boxes_[axis].target.write(targets[axis]);
  }
  writes_.fetch_add(1, std::memory_order_relaxed);
}

void ModbusBus::read(std::span<DriveFeedback> feedback) RT_SAFE {
  const std::size_t count = std::min(feedback.size(), boxes_.size());
  for (std::size_t axis = 0; axis < count; ++axis) {
    Boxes& boxes = boxes_[axis];
    feedback[axis] = boxes.feedback.read();
    const bool is_new = feedback[axis].sequence != boxes.sequence_seen;
    boxes.sequence_seen = feedback[axis].sequence;
    boxes.age_cycles = is_new ? 0 : boxes.age_cycles + 1;
    feedback[axis].age_cycles = boxes.age_cycles;
    feedback[axis].valid = feedback[axis].valid && boxes.age_cycles <= timeout_cycles_;
  }
}

void ModbusBus::write_signals(const Signals& outputs) RT_SAFE {
  outputs_.write(outputs);
}

Signals ModbusBus::read_signals() RT_SAFE {
  return inputs_.read();
}

std::size_t ModbusBus::read_vibration(std::size_t sensor, std::span<double> samples_um) RT_SAFE {
  if (sensor >= sensors_.size()) return 0;
  Ring<double>& ring = sensors_[sensor].samples;
  std::size_t count = 0;
  while (count < samples_um.size() && ring.pop(samples_um[count])) ++count;
  return count;
}

BusStatus ModbusBus::status() const {
  const std::scoped_lock lock(status_mutex_);
  BusStatus status = status_;
  status.round_trip = round_trips_.summary();
  return status;
}

BusTime ModbusBus::now() const {
  return std::chrono::steady_clock::now() - epoch_;
}

// The root of the thread: nothing that happens here ends the process while axes move.
void ModbusBus::run(const std::stop_token& stop_requested) {
  while (!stop_requested.stop_requested()) {
    without_end([&] { poll_until(stop_requested); });
  }
  without_end([this] { take_leave(); });
  link_->close();
}

template <class Work>
void ModbusBus::without_end(const Work& work) {
  try {
    work();
  } catch (const std::exception& fault) {
    lose_contact(fault.what());
  } catch (...) {
    lose_contact("an exception without a text");
  }
}

// As with a connection that breaks: the cycle sees at once that no drive answers, and the drives
// hear nothing until they are told to stop, or until their watchdogs stop them. Allocates nothing:
// memory may be what is missing.
void ModbusBus::lose_contact(std::string_view reason) {
  link_->close();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    axes_[axis].lose_contact();
    boxes_[axis].feedback.write(axes_[axis].feedback());
  }
  {
    const std::scoped_lock lock(status_mutex_);
    ++status_.errors[ExchangeError::own_fault];
    status_.own_fault = reason;
    status_.connected = false;
    for (AxisBusStatus& axis : status_.axes) axis.in_contact = false;
  }
  std::this_thread::sleep_for(poll_);  // a fault of every round takes no processor from others
}

void ModbusBus::poll_until(const std::stop_token& stop_requested) {
  BusTime next_poll = now();
  while (!stop_requested.stop_requested()) {
    if (now() >= next_poll) {
      poll_all();
      next_poll = std::max(next_poll + poll_, now());
    } else {
      ask_again();
    }
    std::unique_lock lock(wait_mutex_);
    wait_.wait_until(lock, stop_requested, epoch_ + next_turn(next_poll), [] { return false; });
  }
}

// The drives are told to stop, and outputs fall.
void ModbusBus::take_leave() {
  for (std::size_t axis = 0; axis < axes_.size() && link_->is_connected(); ++axis) {
    poll_one(axis, TargetAge::stale);
  }
  poll_signals(TargetAge::stale);
}

void ModbusBus::poll_all() {
  const TargetAge age = target_age();
  choose_silent_axis();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const bool is_turn = axis == silent_axis_ && now() >= silent_again_at_;
    if (!axes_[axis].is_lost() || is_turn) {
      poll_one(axis, age);
    }
    axes_[axis].supervise(now());
    publish_axis(axis);
  }
  poll_signals(age);
  for (std::size_t sensor = 0; sensor < sensors_.size(); ++sensor) poll_sensor(sensor);
}

bool ModbusBus::is_asked_again(std::size_t axis) const {
  return !axes_[axis].is_answering() && !axes_[axis].is_lost();
}

// One missed answer costs a poll of 50 ms no more than one of 10 ms.
void ModbusBus::ask_again() {
  const TargetAge age = target_age();
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (!is_asked_again(axis) || now() < asking_[axis].again_at) continue;
    poll_one(axis, age);
    axes_[axis].supervise(now());
    publish_axis(axis);
  }
}

BusTime ModbusBus::next_turn(BusTime next_poll) const {
  BusTime next = next_poll;
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (is_asked_again(axis)) next = std::min(next, asking_[axis].again_at);
  }
  return next;
}

// Outputs fall when the cycle is silent.
void ModbusBus::poll_signals(TargetAge age) {
  const Signals outputs = outputs_.read();
  signals_.fill_outputs(age == TargetAge::fresh ? outputs : Signals{});
  for (std::size_t place = 0; place < signals_.blocks().size(); ++place) {
    SignalBlock& block = signals_.blocks()[place];
    if (!signals_.is_due(block, now()) || !ensure_connected()) continue;
    if (exchange(block, signal_patience_[place])) {
      signals_.fail(block, now());
    } else {
      signals_.take(block);
    }
    const std::scoped_lock lock(status_mutex_);
    ++status_.signal_requests;
  }
  inputs_.write(signals_.inputs());
}

std::optional<ExchangeError> ModbusBus::exchange(SignalBlock& block, Patience& patience) {
  link_->wait_at_most(patience.for_next_answer());
  const BusTime begin = now();
  const auto error = link_->exchange(block);
  note_answer(error, now() - begin, patience);
  return error;
}

void ModbusBus::note_answer(std::optional<ExchangeError> error, BusTime round_trip,
                            Patience& patience) {
  count_exchange(error, round_trip);
  const bool is_answer = !error || *error == ExchangeError::exception;
  if (is_answer) pause_ = BusTime{0};
  is_answer ? patience.note_answer(round_trip) : patience.note_silence();
}

// A sensor that does not answer is left alone for the timeout.
void ModbusBus::poll_sensor(std::size_t place) {
  Sensor& sensor = sensors_[place];
  if (now() < sensor.asking.again_at || !ensure_connected()) return;
  if (exchange(sensor.block, sensor.asking.patience)) {
    ++sensor.errors;
    sensor.asking.again_at = now() + timeout_;
  } else {
    const std::span<const double> fresh = sensor.reader.take(sensor.block.words);
    sensor.meter.add(fresh);
    for (const double sample : fresh) static_cast<void>(sensor.samples.push(sample));
  }
  const std::scoped_lock lock(status_mutex_);
  VibrationStatus& status = status_.vibration[place];
  status.level = sensor.meter.level();
  status.samples = sensor.reader.samples();
  status.lost = sensor.reader.lost();
  status.errors = sensor.errors;
}

// A drive that has been given up is tried once per timeout: every try costs the others the time of
// an answer that does not come.
void ModbusBus::poll_one(std::size_t axis, TargetAge age) {
  asking_[axis].again_at = now() + asking_[axis].patience.between_tries();
  if (!ensure_connected()) {
    return;
  }
  const auto error = exchange(axis, age);
  if (error && axes_[axis].is_lost()) {
    silent_again_at_ = now() + timeout_;
  }
}

// A drive that has never answered is looked at before anything is written to it.
std::optional<ExchangeError> ModbusBus::exchange(std::size_t axis, TargetAge age) {
  AxisExchange& drive = axes_[axis];
  if (!drive.has_answered()) {
    if (const auto error = carry_out(axis, plans_[axis].look)) return error;
  }
  write_block(drives_[axis].map, drive.command(boxes_[axis].target.read(), age), images_[axis]);
  const bool runs = drive.write_order() == WriteOrder::target_first;
  return carry_out(axis, runs ? plans_[axis].run : plans_[axis].stop);
}

std::optional<ExchangeError> ModbusBus::carry_out(std::size_t axis, std::span<const Request> plan) {
  const AxisDriveConfig& config = drives_[axis];
  AxisExchange& drive = axes_[axis];
  Patience& patience = asking_[axis].patience;
  link_->wait_at_most(patience.for_next_answer());
  const BusTime begin = now();
  auto error = link_->exchange(config.unit, plan, images_[axis]);
  const BusTime end = now();
  if (error) {
    drive.fail(*error);
  } else {
    error = drive.take(status_block(config.map, images_[axis]), begin, end);
  }
  note_answer(error, end - begin, patience);
  return error;
}

bool ModbusBus::ensure_connected() {
  if (link_->is_connected()) {
    return true;
  }
  if (now() < connect_again_at_) {
    return false;
  }
  link_->wait_at_most(timeout_ / 3);
  link_->connect();
  const std::scoped_lock lock(status_mutex_);
  if (link_->is_connected()) {
    ++status_.connections;
  } else {
    ++status_.errors[ExchangeError::not_connected];
    back_off();
  }
  return link_->is_connected();
}

void ModbusBus::back_off() {
  connect_again_at_ = now() + pause_;
  pause_ = std::clamp(2 * pause_, timeout_ / 25, pause_max);
}

void ModbusBus::choose_silent_axis() {
  for (std::size_t step = 1; step <= axes_.size(); ++step) {
    const std::size_t axis = (silent_axis_ + step) % axes_.size();
    if (axes_[axis].is_lost()) {
      silent_axis_ = axis;
      return;
    }
  }
}

TargetAge ModbusBus::target_age() {
  const std::uint64_t writes = writes_.load(std::memory_order_relaxed);
  if (writes != writes_seen_) {
    writes_seen_ = writes;
    last_write_ = now();
  }
  return now() - last_write_ > timeout_ ? TargetAge::stale : TargetAge::fresh;
}

void ModbusBus::publish_axis(std::size_t axis) {
  const DriveFeedback& feedback = axes_[axis].feedback();
  boxes_[axis].feedback.write(feedback);
  const std::scoped_lock lock(status_mutex_);
  status_.connected = link_->is_connected();
  AxisBusStatus& status = status_.axes[axis];
  status.in_contact = feedback.valid;
  status.answers = feedback.sequence;
  status.errors = axes_[axis].errors();
  status.errors_by_kind = axes_[axis].errors_by_kind();
  status.feedback = feedback;
}

void ModbusBus::count_exchange(std::optional<ExchangeError> error, BusTime round_trip) {
  const std::scoped_lock lock(status_mutex_);
  ++status_.exchanges;
  if (error) {
    ++status_.errors[*error];
  } else {
    round_trips_.add(round_trip);
  }
}

}  // namespace stanok::drives
