#include "jobs/cutting/milling_log.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <stanok_messages/process_status_t.hpp>
#include <stanok_messages/setpoint_t.hpp>
#include <stanok_messages/tool_t.hpp>
#include <stdexcept>

#include "base/place.h"
#include "jobs/cutting/load_ahead.h"
#include "jobs/cutting/power_readings.h"
#include "recording/format/channel_names.h"
#include "recording/format/decode.h"
#include "runtime/recorded_run.h"
#include "runtime/workpiece/workpiece_stream.h"

namespace stanok::jobs {
namespace {

using recording::Topic;
using simulation::Vector;

// The torque for K_t = 1 N/mm2 and a feed of 1 mm per tooth, and for K_te = 1 N/mm.
struct UnitLoad {
  double chip = 0.0;
  double edge = 0.0;
};

UnitLoad unit_load(const process::MillingLoad& load) {
  const double edge = load.at(0.0).torque_n_mm;
  return {.chip = load.at(1.0).torque_n_mm - edge, .edge = edge};
}

// Loads are looked at here and there along the path; between two places they go from one to the
// other.
class LoadByRow {
 public:
  void add(std::size_t row, const UnitLoad& load) {
    by_row_.resize(row + 1);
    by_row_[row] = load;
    if (looked_) {
      const UnitLoad from = by_row_[*looked_];
      for (std::size_t k = *looked_ + 1; k < row; ++k) {
        const double part = static_cast<double>(k - *looked_) / static_cast<double>(row - *looked_);
        by_row_[k] = {.chip = std::lerp(from.chip, load.chip, part),
                      .edge = std::lerp(from.edge, load.edge, part)};
      }
    }
    looked_ = row;
  }
  // The tool goes on at feed no more; up to this row it met what it met last.
  void end(std::size_t row) {
    if (!looked_) return;
    by_row_.resize(row, by_row_[*looked_]);
    looked_.reset();
  }
  [[nodiscard]] UnitLoad at(std::size_t row) const {
    return row < by_row_.size() ? by_row_[row] : UnitLoad{};
  }

 private:
  std::vector<UnitLoad> by_row_;
  std::optional<std::size_t> looked_;
};

// Takes the events of a log one after the other.
class MillingReading {
 public:
  MillingReading(const runtime::RecordedRun& run, const MillingLogRequest& request)
      : request_(request),
        readings_(request.spindle),
        stream_(
            run.beginning.machine.machine, request.memory_max,
            [this](int, const std::string& code, const std::string& text) {
              if (refusal_.empty() && code.front() == 'E') refusal_ = code + ": " + text;
            },
            run.files.get()),
        cycle_s_(run.beginning.machine.machine.cycle_us * 1e-6) {
    request_.cut.force_n_per_mm2 = 1.0;
    request_.cut.edge_n_per_mm = 1.0;
    feed_ = stream_.feed(request.channel);
    if (feed_ == nullptr)
      throw std::runtime_error("the log has no channel " + std::to_string(request.channel));
  }

  void take(const recording::LogEvent& event) {
    readings_.take(event);
    stream_.take(event.channel, event.bytes);
    const std::string_view topic = recording::topic_of(event.channel);
    if (topic == recording::name_of(Topic::process)) {
      const auto message = recording::decode<process_status_t>(event.bytes);
      if (message && message->channel == request_.channel) rev_per_min_ = message->spindle_speed;
    } else if (topic == recording::name_of(Topic::tool)) {
      const auto message = recording::decode<tool_t>(event.bytes);
      if (message && message->channel == request_.channel) tool_ = message->number;
    } else if (topic == recording::name_of(Topic::setpoint)) {
      const auto message = recording::decode<setpoint_t>(event.bytes);
      if (message && message->channel == request_.channel) take_setpoint(*message);
    }
  }

  // Why the workpiece cannot be followed; empty: it can.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  [[nodiscard]] bool has_workpiece() { return feed_->follower().at_work() != nullptr; }

  [[nodiscard]] MillingLog end() {
    readings_.check_any();
    loads_.end(speeds_mm_per_s_.size());
    const std::vector<double> power = readings_.by_row(first_cycle_, speeds_rev_per_min_, cycle_s_);
    constexpr double full_turn = 2.0 * std::numbers::pi;
    constexpr double seconds_of_minute = 60.0;
    MillingLog log;
    log.record.cycle_s = cycle_s_;
    for (std::size_t row = 0; row < power.size(); ++row) {
      const UnitLoad load = loads_.at(row);
      const double turns_per_s = speeds_rev_per_min_[row] / seconds_of_minute;
      log.record.rows.push_back(
          {.rev_per_min = speeds_rev_per_min_[row],
           .removal_mm3_per_s = load.chip * speeds_mm_per_s_[row] * full_turn / request_.cut.teeth,
           .rubbing_mm2_per_s = load.edge * full_turn * turns_per_s,
           .power_w = power[row]});
      log.time_s.push_back(static_cast<double>(row) * cycle_s_);
    }
    return log;
  }

 private:
  void take_setpoint(const setpoint_t& message) {
    request_.bounds.check(speeds_mm_per_s_.size());
    if (first_cycle_ < 0) first_cycle_ = message.cycle;
    const std::size_t row = speeds_mm_per_s_.size();
    speeds_rev_per_min_.push_back(std::abs(rev_per_min_));
    speeds_mm_per_s_.push_back(0.0);
    const auto mill = feed_->follower().milling_tool();
    const bool cuts = mill && has_workpiece() && message.feed_commanded > 0.0 &&
                      rev_per_min_ != 0.0 && (request_.tool == 0 || request_.tool == tool_);
    if (!cuts) {
      loads_.end(row);
      tip_.reset();
      return;
    }
    const Vector tip = mill->place_K.tip;
    const double distance = tip_ ? (tip - *tip_).norm() : 0.0;
    constexpr double standing_mm = 1e-9;
    if (distance > standing_mm) {
      speeds_mm_per_s_.back() = distance / cycle_s_;
      since_mm_ += distance;
      const Vector direction = (tip - *tip_) / distance;
      if (since_mm_ >= feed_->follower().at_work()->blank().resolution ||
          direction.dot(direction_) < same_direction)
        look(row, *mill, direction);
    }
    tip_ = tip;
  }

  void look(std::size_t row, const simulation::WorkpieceFollower::ToolAtWork& mill,
            const Vector& direction_K) {
    since_mm_ = 0.0;
    direction_ = direction_K;
    loads_.add(row, unit_load(load_ahead(feed_->follower(), mill, direction_K, rev_per_min_,
                                         request_.cut)));
  }

  static constexpr double same_direction = 0.98;

  MillingLogRequest request_;
  std::string refusal_;
  PowerReadings readings_;
  runtime::WorkpieceStream stream_;
  double cycle_s_;
  runtime::ChannelFeed* feed_ = nullptr;
  LoadByRow loads_;
  std::vector<double> speeds_rev_per_min_;
  std::vector<double> speeds_mm_per_s_;  // of the tip, at feed
  std::optional<Vector> tip_;
  Vector direction_ = Vector::Zero();  // where it was looked last
  double since_mm_ = 0.0;
  double rev_per_min_ = 0.0;
  int tool_ = 0;
  std::int64_t first_cycle_ = -1;
};

}  // namespace

MillingLog read_milling_log(const std::filesystem::path& file, const MillingLogRequest& request) {
  const auto run = runtime::read_run(file);
  auto reader = recording::LogReader::open(file);
  if (!reader) throw std::runtime_error(reader.error().text);
  MillingReading reading(*run, request);
  while (const auto event = reader->next()) reading.take(*event);
  if (!reading.refusal().empty()) throw std::runtime_error(reading.refusal());
  if (!reading.has_workpiece()) {
    throw std::runtime_error(
        "the log has no workpiece; announce the blank in the program with #workpiece (on a "
        "machine, `stanok workpiece allow` lets the daemon tell of it)");
  }
  return reading.end();
}

}  // namespace stanok::jobs
