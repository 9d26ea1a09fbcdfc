#include "simulation/workpiece_follower.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace stanok::simulation {
namespace {

constexpr std::size_t stations_max = 64;  // bound of the work for a sample
// mm: how far a probe may go from a place where nothing is near, before it is looked at again.
constexpr std::array free_distances{2.0, 0.4, 0.08, 0.016};
constexpr double standing = 1e-9;  // mm, and parts of a radian: rounding of the readings

double deviation_from_way(const Vector& begin, const Vector& end, const Vector& point) {
  const Vector way = end - begin;
  const double length2 = way.squaredNorm();
  if (length2 <= 0.0) return (point - begin).norm();
  const double part = std::clamp((point - begin).dot(way) / length2, 0.0, 1.0);
  return (begin + part * way - point).norm();
}

Pose turned(const Vector& angles_deg) {
  const Vector angles = angles_deg * (std::numbers::pi / 180.0);
  return Pose(Eigen::AngleAxisd(angles.x(), Vector::UnitZ()) *
              Eigen::AngleAxisd(angles.y(), Vector::UnitX()) *
              Eigen::AngleAxisd(angles.z(), Vector::UnitZ()));
}

}  // namespace

WorkpieceFollower::WorkpieceFollower(ChannelGeometry geometry, ToolRecords tools,
                                     std::uint64_t memory_max, Complaint complain)
    : machine_(std::move(geometry)),
      tools_(std::move(tools)),
      memory_max_(memory_max),
      complain_(std::move(complain)) {}

void WorkpieceFollower::complain_once(const std::string& code, const std::string& subject,
                                      std::uint32_t line) {
  const std::string complaint = code + subject;
  if (std::ranges::find(complaints_, complaint) != complaints_.end()) return;
  complaints_.push_back(complaint);
  complain_(code, line == 0 ? subject : fmt::format("line {}: {}", line, subject));
}

void WorkpieceFollower::announce(const Announcement& announcement, const Sample& now) {
  flush();
  workpiece_ = nullptr;
  const auto grid = grid_of(announcement.blank, memory_max_);
  if (!grid) return complain_once(grid.error().code, grid.error().text, now.origin.line);
  workpieces_.push_back(std::make_unique<Workpiece>(announcement.blank, *grid));
  workpiece_ = workpieces_.back().get();
  home_ = now.scheme;
  blank_in_base_ = announcement.program_in_base * Eigen::Translation3d(-announcement.blank.zero);
  base_in_blank_ = blank_in_base_.inverse();
  ready_.clear();
  begin_.reset();
  latest_.reset();
}

void WorkpieceFollower::place(const Placement& placement, const Sample& now) {
  flush();
  for (auto& [key, tool] : ready_) tool.free.reset();
  if (workpiece_ == nullptr) {
    return complain_once("W926", "there is no blank to be moved", now.origin.line);
  }
  home_ = now.scheme;
  blank_in_base_ = machine_.machine_in(home_, now.axes_M) *
                   Eigen::Translation3d(placement.position) * turned(placement.angles_deg) *
                   Eigen::Translation3d(-workpiece_->blank().zero);
  base_in_blank_ = blank_in_base_.inverse();
  begin_.reset();
  latest_.reset();
}

Pose WorkpieceFollower::program_in_base() const {
  if (workpiece_ == nullptr) return blank_in_base_;
  return blank_in_base_ * Eigen::Translation3d(workpiece_->blank().zero);
}

void WorkpieceFollower::change_tool(int number, int edge, const ToolRecord& record) {
  const bool is_at_work = latest_ && latest_->tool == number && latest_->edge == edge;
  if (is_at_work) flush();
  tools_[{number, edge}] = record;
  ready_.erase({number, edge});
  if (!is_at_work) return;
  tool_ = nullptr;
  begin_.reset();
  if (workpiece_ == nullptr) return;
  tool_ = tool_of(*latest_);
  if (tool_ != nullptr) begin_ = station_of(*latest_);
}

const ToolRecord* WorkpieceFollower::record_of(const Sample& sample) const {
  const auto found = tools_.find({sample.tool, sample.edge});
  return found == tools_.end() ? nullptr : &found->second;
}

WorkpieceFollower::ReadyTool WorkpieceFollower::prepared(const ToolRecord& record) const {
  ReadyTool ready;
  if (record.shape.kind == ToolKind::insert) {
    const bool is_opposite = base_in_blank_(2, 2) < 0.0;
    ready.insert = workpiece_->turning_tool(
        record.shape, is_opposite ? DirectionOfZ::opposite : DirectionOfZ::same);
  } else {
    ready.mill = workpiece_->milling_tool(record.shape);
    ready.reach = ready.mill->solid.bodies.front().top();
    if (record.shape.kind == ToolKind::probe) {
      for (const double distance : free_distances)
        ready.widened.push_back(widened_probe(ready.mill->solid, distance));
    }
  }
  return ready;
}

// The tool of the sample, or nothing when it cannot be seen.
WorkpieceFollower::ReadyTool* WorkpieceFollower::tool_of(const Sample& sample) {
  const std::pair key{sample.tool, sample.edge};
  if (const auto found = ready_.find(key); found != ready_.end()) return &found->second;
  const ToolRecord* record = record_of(sample);
  const std::string defect =
      record == nullptr ? "the tool table does not have it" : defect_of(record->shape);
  if (record == nullptr || !defect.empty()) {
    if (sample.tool != 0 && !sample.rapid) {
      complain_once("W925", fmt::format("tool {} cannot be seen: {}", sample.tool, defect),
                    sample.origin.line);
    }
    return nullptr;
  }
  return &ready_.emplace(key, prepared(*record)).first->second;
}

ToolPlace WorkpieceFollower::place_in_base(const Sample& sample) const {
  return machine_.place_in(home_, sample.scheme, sample.axes_M, record_of(sample)->mount);
}

// x the distance from the axis of the spindle, z along K.
ToolPlace WorkpieceFollower::turning_place(const Sample& sample) const {
  const ToolPlace place_B = place_in_base(sample);
  const Vector on_axis = base_in_blank_ * Vector(0.0, 0.0, place_B.tip.z());
  return {{place_B.tip.x(), 0.0, on_axis.z()}, Vector::UnitZ()};
}

// Tip and axis in K.
ToolPlace WorkpieceFollower::milling_place(const Sample& sample) const {
  const ToolPlace place_B = place_in_base(sample);
  const ToolPlace turned_B = machine_.turned_with_workpiece(home_, sample.axes_M, place_B);
  return {base_in_blank_ * turned_B.tip, base_in_blank_.linear() * turned_B.axis};
}

bool WorkpieceFollower::continues(const Sample& sample) const {
  return latest_ && latest_->origin.run == sample.origin.run && latest_->tool == sample.tool &&
         latest_->edge == sample.edge && latest_->rapid == sample.rapid &&
         latest_->spindle_turns == sample.spindle_turns && latest_->scheme == sample.scheme;
}

// Where the tool that is ready is at a sample.
WorkpieceFollower::Station WorkpieceFollower::station_of(const Sample& sample) const {
  return {tool_->insert ? turning_place(sample) : milling_place(sample), sample.time_s,
          sample.origin};
}

void WorkpieceFollower::follow(const Sample& sample) {
  if (workpiece_ == nullptr || !machine_.has_scheme(sample.scheme)) return;
  // The way to this sample is made under its own circumstances.
  if (!continues(sample)) {
    flush();
    tool_ = tool_of(sample);
    if (latest_ && (latest_->tool != sample.tool || latest_->edge != sample.edge)) begin_.reset();
  }
  if (latest_) workpiece_->add_time(sample.origin, sample.time_s - latest_->time_s);
  latest_ = sample;
  if (tool_ == nullptr) return begin_.reset();
  const Station station = station_of(sample);
  if (!begin_) {
    begin_ = station;
    return;
  }
  const Station& before = stations_.empty() ? *begin_ : stations_.back();
  if ((station.place_K.tip - before.place_K.tip).norm() <= standing &&
      (station.place_K.axis - before.place_K.axis).norm() <= standing)
    return;
  if (!stations_.empty() && !extends_motion(station)) flush();
  stations_.push_back(station);
}

// Blocks stay apart, unless one step of the cut covers them.
bool WorkpieceFollower::extends_motion(const Station& station) const {
  if (stations_.size() >= stations_max) return false;
  if (!(stations_.front().origin == station.origin)) {
    if (!tool_->mill || steps_between(tool_->mill->solid, begin_->place_K, station.place_K,
                                      workpiece_->deviation()) > 1)
      return false;
  }
  return lies_on_the_way(station.place_K);
}

// Samples of a smooth path: some of them, evenly taken, stand for all.
bool WorkpieceFollower::lies_on_the_way(const ToolPlace& end) const {
  constexpr std::size_t looked_at = 8;
  const ToolPlace& begin = begin_->place_K;
  const std::size_t stride = 1 + stations_.size() / looked_at;
  for (std::size_t i = stations_.size(); i > 0; i -= std::min(i, stride)) {
    for (const double height : {0.0, tool_->reach}) {
      if (deviation_from_way(begin.at(height), end.at(height),
                             stations_[i - 1].place_K.at(height)) > workpiece_->way_deviation())
        return false;
    }
  }
  return true;
}

void WorkpieceFollower::forget_former() {
  if (workpieces_.size() > 1) workpieces_.erase(workpieces_.begin(), workpieces_.end() - 1);
}

void WorkpieceFollower::flush() {
  if (stations_.empty()) return;
  cut(stations_.back());
  begin_ = stations_.back();
  stations_.clear();
}

std::optional<WorkpieceFollower::ToolAtWork> WorkpieceFollower::milling_tool() const {
  if (workpiece_ == nullptr || tool_ == nullptr || !tool_->mill || !latest_) return std::nullopt;
  return ToolAtWork{.tool = &*tool_->mill, .place_K = milling_place(*latest_)};
}

// The shares of the blocks in the motion, by the travel of tip and flutes.
std::vector<Share> WorkpieceFollower::shares() const {
  std::vector<Share> shares;
  const ToolPlace* before = &begin_->place_K;
  double whole = 0.0;
  for (const Station& station : stations_) {
    const double way = (station.place_K.tip - before->tip).norm() +
                       tool_->reach * (station.place_K.axis - before->axis).norm();
    if (shares.empty() || !(shares.back().origin == station.origin))
      shares.push_back({station.origin, 0.0});
    shares.back().part += way;
    whole += way;
    before = &station.place_K;
  }
  for (Share& share : shares) share.part /= whole;
  return shares;
}

bool WorkpieceFollower::is_free(const ReadyTool& probe, const ToolPlace& place_K) {
  if (!probe.free) return false;
  const double top = probe.mill->solid.bodies.back().top();
  const double way = (place_K.tip - probe.free->place_K.tip).norm() +
                     top * (place_K.axis - probe.free->place_K.axis).norm();
  return way < probe.free->distance;
}

bool WorkpieceFollower::touches_workpiece(const Sample& now) {
  if (workpiece_ == nullptr || !machine_.has_scheme(now.scheme)) return false;
  ReadyTool* probe = tool_of(now);
  if (probe == nullptr || !probe->probes()) return false;
  const ToolPlace place_K = milling_place(now);
  if (is_free(*probe, place_K)) return false;
  flush();
  for (std::size_t i = 0; i < free_distances.size(); ++i) {
    if (workpiece_->touches(probe->widened[i], place_K)) continue;
    probe->free = {free_distances[i], place_K};
    return false;
  }
  probe->free.reset();
  return workpiece_->touches(probe->mill->solid, place_K);
}

void WorkpieceFollower::find_probe_at_rapid(const Sample& now) {
  workpiece_->find_probe_at_rapid(
      milling_place(now).tip,
      {.shares = {{now.origin}}, .tool = now.tool, .rapid = true, .time_s = now.time_s});
}

bool WorkpieceFollower::touches(const Sample& now, const Disc& disc_M) const {
  constexpr double rounding = 1e-3;  // mm, of rounded corners
  const ToolRecord* record = record_of(now);
  if (record == nullptr || !machine_.has_scheme(now.scheme)) return false;
  if (record->shape.kind == ToolKind::insert || !defect_of(record->shape).empty()) return false;
  const Pose base_M = machine_.machine_in(now.scheme, now.axes_M).inverse();
  const ToolPlace place_B = machine_.place_in(now.scheme, now.scheme, now.axes_M, record->mount);
  const ToolPlace place_M{base_M * place_B.tip, base_M.linear() * place_B.axis};
  if (place_M.tip.z() > disc_M.top.z()) return false;
  return simulation::touches(solid_of(record->shape, rounding), place_M, disc_M);
}

void WorkpieceFollower::cut(const Station& to) {
  if (tool_->probes()) return;
  const Circumstances circumstances{.shares = shares(),
                                    .tool = latest_->tool,
                                    .rapid = latest_->rapid,
                                    .spindle_turns = latest_->spindle_turns,
                                    .time_s = begin_->time_s};
  if (tool_->mill) {
    workpiece_->mill(*tool_->mill, begin_->place_K, to.place_K, circumstances);
    return;
  }
  const auto point = [](const Station& station) {
    return PlanePoint{station.place_K.tip.z(), station.place_K.tip.x()};
  };
  const Vector axis = base_in_blank_ * Vector(0.0, 0.0, 0.0);
  workpiece_->turn(*tool_->insert, {axis.x(), axis.y()}, point(*begin_), point(to), circumstances);
}

}  // namespace stanok::simulation
