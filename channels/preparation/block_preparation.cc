#include "channels/preparation/block_preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <utility>

#include "motion/path/block_metric.h"
#include "motion/path/nurbs.h"
#include "motion/path/shape.h"

namespace stanok::channels {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double same_angle = 1e-12;  // rad; below, start and end of an arc are the same direction

// An arc whose radii at both ends differ more is as small as the tolerance within which they may
// differ, and rounded beyond recognition: the straight path is as near to what was meant.
constexpr double radius_ratio_max = 2.0;

// Nearer to the centre of a face its rotary axis turns faster than it is worth.
constexpr double pole_distance_min_mm = 0.02;

std::string four_decimals(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data();
}

// How far stretches may deviate from the programmed curve.
constexpr double curve_deviation_mm = 1e-7;

// Where a stretch ends: on the curve in the plane, on the way from start to end in all other axes.
motion::Point point_on(const motion::Point& start, const motion::Point& end,
                       const motion::CurveStretch& stretch, const std::array<int, 2>& plane) {
  motion::Point point;
  for (std::size_t k = 0; k < point.size(); ++k)
    point[k] = start[k] + (end[k] - start[k]) * stretch.end;
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& coefficients = stretch.coefficients[c];
    point[plane[c]] = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
  }
  return point;
}

}  // namespace

BlockPreparation::BlockPreparation(const MachineConfig& machine, const ChannelConfig& channel,
                                   const motion::MotionConfig& motion, const ChannelTables* tables)
    : motion_(motion),
      channel_(channel),
      process_(machine, channel),
      face_(motion),
      tables_(tables),
      transforms_(1) {}

void BlockPreparation::begin_run() {
  transforms_before_ = std::exchange(transforms_, {transforms_.back()});
  face_.begin_run();
}

void BlockPreparation::restart(const kinematics::Scheme* scheme, const motion::Point& axes_M) {
  face_.end();
  row_ = {};
  programmed_ = {};
  programmed_.scheme = scheme;
  transforms_.push_back(programmed_);
  stand_at(axes_M);
}

void BlockPreparation::change_scheme(const kinematics::Scheme* scheme,
                                     const motion::Point& axes_M) {
  static_cast<void>(take_lengths());
  face_.end();
  programmed_.scheme = scheme;
  transforms_.push_back(programmed_);
  stand_at(axes_M);
}

// Where the row of the tool counts the programmed point stays, otherwise the axes do.
bool BlockPreparation::take_lengths() {
  if (tables_ == nullptr) return false;
  const kinematics::LengthChanges& changes = tables_->length_changes();
  const kinematics::ToolRow before = std::exchange(row_, row_.behind(tables_->version()));
  if (!changes.concern(before)) return false;
  const bool keeps_point = programmed_.row.sign != 0;
  const motion::Point standing = axes_M();
  programmed_.row = before;
  programmed_ = kinematics::with_changes(programmed_, changes);
  programmed_.row = keeps_point ? row_ : kinematics::ToolRow{};
  transforms_.push_back(face_.applied_to(programmed_));
  if (!keeps_point) stand_at(standing);
  return true;
}

bool BlockPreparation::stand_for(const lang::Move& move) {
  const bool is_new = take_lengths();
  const kinematics::ToolRow wanted = move.machine_coordinates ? kinematics::ToolRow{} : row_;
  if (wanted.is_same(programmed_.row)) return is_new;
  programmed_.row = wanted;
  transforms_.push_back(face_.applied_to(programmed_));
  return true;
}

bool BlockPreparation::take_state(const lang::Payload& command) {
  const bool is_new = take_lengths();
  if (const auto* frame = std::get_if<lang::FrameChange>(&command))
    return set_frame(*frame) || is_new;
  if (const auto* length = std::get_if<lang::ToolLength>(&command))
    return set_tool_length(*length) || is_new;
  if (const auto* change = std::get_if<lang::TransformationChange>(&command))
    return set_transformation(*change);
  process_.take_state(command, diameter_of(motion_, position_W_));
  return is_new;
}

void BlockPreparation::settle(const lang::MeaningTerms& standing) {
  static_cast<void>(take_lengths());
  const bool is_transformed = standing.transformation.kind != lang::Transformation::off;
  if (face_.is_on() && !is_transformed)
    static_cast<void>(set_transformation(standing.transformation));
  static_cast<void>(set_frame(standing.frame));
  static_cast<void>(set_tool_length(standing.length));
  if (!face_.is_on() && is_transformed)
    static_cast<void>(set_transformation(standing.transformation));
}

bool BlockPreparation::set_frame(const lang::FrameChange& change) {
  kinematics::Transform next = programmed_;
  next.frame = {{change.offset}, change.rotation, motion_.geometry};
  return take_programmed(next);
}

bool BlockPreparation::set_tool_length(const lang::ToolLength& length) {
  const lang::ToolLength now = tables_ == nullptr ? length : tables_->in_force(length);
  kinematics::Transform next = programmed_;
  next.mode =
      now.mode == lang::LengthMode::tip ? kinematics::PointMode::tip : kinematics::PointMode::axes;
  next.tool.nose_to_tip_mm = Vector3<double>::Zero() - vector3(now.offset_mm);
  next.row = row_ = row_of(now);
  return take_programmed(next);
}

bool BlockPreparation::set_transformation(const lang::TransformationChange& change) {
  const motion::Point standing = axes_M();
  if (change.kind == lang::Transformation::off) {
    face_.end();
  } else {
    face_.begin(change, *programmed_.scheme, standing);
  }
  transforms_.push_back(face_.applied_to(programmed_));
  stand_at(standing);
  return true;
}

bool BlockPreparation::take_programmed(const kinematics::Transform& next) {
  if (next == programmed_) return false;
  const motion::Point standing = axes_M();
  programmed_ = next;
  transforms_.push_back(face_.applied_to(programmed_));
  stand_at(standing);
  return true;
}

void BlockPreparation::stand_at(const motion::Point& axes_M) {
  kinematics::forward(transform(), axes_M, position_W_);
  if (face_.is_on_face()) face_axis_M_ = motion::at(axes_M, face_.rotary_axis());
}

// The position on the face says nothing of the turns that its rotary axis has made.
double BlockPreparation::face_axis_at(const motion::PathBlock& block, double part) const {
  motion::Point point_W = position_W_;
  for (std::size_t k = 0; k < point_W.size(); ++k)
    point_W[k] += (block.end[k] - position_W_[k]) * part;
  if (block.kind == motion::BlockKind::arc) {
    const double angle = block.sweep_rad * part;
    const double x = motion::at(position_W_, block.plane[0]) - block.centre[0];
    const double y = motion::at(position_W_, block.plane[1]) - block.centre[1];
    point_W[block.plane[0]] = block.centre[0] + x * std::cos(angle) - y * std::sin(angle);
    point_W[block.plane[1]] = block.centre[1] + x * std::sin(angle) + y * std::cos(angle);
  }
  motion::Point axes_M{};
  kinematics::inverse(*block.transform, point_W, axes_M);
  return motion::at(axes_M, face_.rotary_axis());
}

// How far the rotary axis turns between two parts of the block, deg: halved until the shorter way
// round is the way that the path takes.
double BlockPreparation::face_turn(const motion::PathBlock& block, double from, double to) const {
  constexpr double sure_deg = 60.0;
  constexpr double part_min = 1e-7;
  const double turn = std::remainder(face_axis_at(block, to) - face_axis_at(block, from), 360.0);
  const bool is_line = block.kind == motion::BlockKind::line;
  if (is_line || (std::abs(turn) < sure_deg && to - from < 0.1) || to - from < part_min)
    return turn;
  const double middle = 0.5 * (from + to);
  return face_turn(block, from, middle) + face_turn(block, middle, to);
}

motion::Point BlockPreparation::axes_M() const {
  motion::Point axes_M{};
  kinematics::inverse(transform(), position_W_, axes_M);
  if (face_.is_on_face()) {
    constexpr double turn = 360.0;
    double& rotary = axes_M[face_.rotary_axis()];
    rotary += turn * std::round((face_axis_M_ - rotary) / turn);
  }
  return axes_M;
}

motion::Point BlockPreparation::position_B() const {
  return kinematics::base_from_workpiece(programmed_.frame, face_.to_program(position_W_));
}

motion::Point BlockPreparation::base_of(const motion::Point& axes_M) const {
  motion::Point point_W{};
  kinematics::forward(transform(), axes_M, point_W);
  return kinematics::base_from_workpiece(programmed_.frame, face_.to_program(point_W));
}

std::optional<Diagnostic> BlockPreparation::refusal(
    const lang::TransformationChange& change) const {
  return face_.refusal(change, *programmed_.scheme);
}

motion::Point BlockPreparation::end_of(const lang::Move& move) const {
  const auto with_words = [&](motion::Point point) {
    for (int k = 0; k < motion_.axis_count; ++k) {
      if ((move.words >> k & 1U) != 0) point[k] = move.end[k];
    }
    return point;
  };
  if (!move.machine_coordinates) {
    const motion::Point end = face_.to_path(with_words(face_.to_program(position_W_)));
    motion::Point kept = position_W_;  // to the bit where no word is
    for (int k = 0; k < motion_.axis_count; ++k) {
      if ((move.words >> k & 1U) != 0) kept[k] = end[k];
    }
    return kept;
  }
  motion::Point end{};
  kinematics::forward(transform(), with_words(axes_M()), end);
  return end;
}

// First and second axis of a plane: XY, ZX, YZ (ISO 841), XC on a face, CZ on a cylinder
// about Z, XA and BY on those about X and Y.
std::array<int, 2> BlockPreparation::plane_axes(lang::Plane plane) const {
  const std::array<int, 3> axes = face_.geometry();
  if (face_.is_on_face()) return {axes[0], axes[1]};
  switch (plane) {
    case lang::Plane::xy:
      return {axes[0], axes[1]};
    case lang::Plane::zx:
      return {axes[2], axes[0]};
    case lang::Plane::yz:
      return {axes[1], axes[2]};
  }
  return {0, 1};
}

// Signed sweep from start to end direction: counter-clockwise positive, full turns for P > 1 and
// for equal ends.
void BlockPreparation::shape_arc(const lang::Move& move, motion::PathBlock& block) const {
  block.plane = plane_axes(move.plane);
  block.centre = move.centre;
  const auto radius = [&](const motion::Point& point) {
    return std::hypot(motion::at(point, block.plane[0]) - block.centre[0],
                      motion::at(point, block.plane[1]) - block.centre[1]);
  };
  const auto [smaller, larger] = std::minmax({radius(position_W_), radius(block.end)});
  if (larger > radius_ratio_max * smaller) return;  // a line
  block.kind = motion::BlockKind::arc;
  const auto direction = [&](const motion::Point& point) {
    return std::atan2(motion::at(point, block.plane[1]) - block.centre[1],
                      motion::at(point, block.plane[0]) - block.centre[0]);
  };
  double sweep = direction(block.end) - direction(position_W_);
  if (move.counter_clockwise) {
    while (sweep <= same_angle) sweep += full_turn;
    block.sweep_rad = sweep + full_turn * (move.turns - 1);
  } else {
    while (sweep >= -same_angle) sweep -= full_turn;
    block.sweep_rad = sweep - full_turn * (move.turns - 1);
  }
}

void BlockPreparation::shape_ending(const lang::Move& move, motion::PathBlock& block) const {
  const bool continuous = move.path.mode == lang::PathMode::continuous;
  const bool stops = move.stop_at_end || move.path.mode == lang::PathMode::exact_stop;
  block.ending = stops ? motion::BlockEnding::exact_stop : motion::BlockEnding::continuous;
  if (!continuous) return;
  block.tolerance_mm =
      move.path.tolerance_mm < 0.0 ? channel_.path_tolerance_mm : move.path.tolerance_mm;
  if (block.tolerance_mm > 0.0) {
    block.tolerance_deg = channel_.orientation_tolerance_deg;
    if (move.path.orientation_deg >= 0.0)
      block.tolerance_deg = std::min(block.tolerance_deg, move.path.orientation_deg);
  }
  block.straightening_mm = move.path.straightening_mm;
}

std::optional<Diagnostic> BlockPreparation::refuse_parked_axes(const lang::Move& move) const {
  const kinematics::Scheme* scheme = transform().scheme;
  if (scheme == nullptr) return std::nullopt;
  const unsigned refused = move.words & ~scheme->participants();
  if (refused == 0) return std::nullopt;
  std::size_t axis = 0;
  while ((refused >> axis & 1U) == 0) ++axis;
  Diagnostic d;
  d.code = "E5102";
  d.message = "axis " + channel_.words.at(axis) + " is not part of scheme " +
              std::to_string(scheme->config().id);
  d.help = {"use #kinematics to change to a scheme with this axis, or remove the word"};
  return d;
}

// From `from_W`, in the current workspace: that of a face or cylinder, too.
double BlockPreparation::length_of(const motion::Point& from_W,
                                   const motion::PathBlock& block) const {
  motion::MotionConfig motion = motion_;
  motion.geometry = face_.geometry();
  return motion::length_of(block, from_W, motion);
}

// In the diameters of a turned part around Z; without an X axis there are none.
double diameter_of(const motion::MotionConfig& motion, const motion::Point& point_W) {
  const int x = motion.geometry[0];
  return x < 0 ? 0.0 : 2.0 * std::abs(motion::at(point_W, x));
}

ProcessPreparation::Travel BlockPreparation::travel_of(const motion::PathBlock& block,
                                                       double length) const {
  const int x = motion_.geometry[0];
  const bool passes_centre =
      x >= 0 && std::signbit(motion::at(position_W_, x)) != std::signbit(motion::at(block.end, x));
  const double smaller =
      std::min(diameter_of(motion_, position_W_), diameter_of(motion_, block.end));
  motion::MotionConfig motion = motion_;
  motion.geometry = face_.geometry();
  const bool in_mm = motion::travel_of(block, position_W_, motion) == motion::BlockTravel::geometry;
  return {.length = length, .in_mm = in_mm, .diameter_min_mm = passes_centre ? 0.0 : smaller};
}

// A blend at the end of the block may come nearer than the block itself.
std::optional<Diagnostic> BlockPreparation::refuse_pole(const motion::PathBlock& block) const {
  if (!face_.is_on_face()) return std::nullopt;
  const double distance = face_.distance_to_pole(position_W_, block);
  if (distance >= pole_distance_min_mm + block.tolerance_mm) return std::nullopt;
  Diagnostic d;
  d.code = "E5103";
  d.message = "the path comes within " + four_decimals(distance) +
              " mm of the center of the face, where the rotary axis would have to jump";
  d.help = {"keep 0.02 mm plus the path tolerance away from the center, or leave G12.1"};
  return d;
}

Expected<motion::PathBlock, Diagnostic> BlockPreparation::block_without_feed(
    const lang::Move& move, const motion::BlockTag& tag) const {
  if (auto refusal = refuse_parked_axes(move)) return Unexpected<Diagnostic>(std::move(*refusal));
  motion::PathBlock block;
  block.tag = tag;
  block.rapid = move.kind == lang::MoveKind::rapid;
  block.end = end_of(move);
  block.transform = &transform();
  shape_ending(move, block);
  if (move.kind == lang::MoveKind::arc) shape_arc(move, block);
  if (auto refusal = refuse_pole(block)) return Unexpected<Diagnostic>(std::move(*refusal));
  return block;
}

Expected<motion::PathBlock, Diagnostic> BlockPreparation::block(const lang::Move& move,
                                                                const motion::BlockTag& tag) {
  auto block = block_without_feed(move, tag);
  if (!block) return block;
  const auto travel = travel_of(*block, length_of(position_W_, *block));
  if (auto refusal = process_.apply(move, travel, *block))
    return Unexpected<Diagnostic>(std::move(*refusal));
  if (face_.is_on_face()) face_axis_M_ += face_turn(*block, 0.0, 1.0);
  position_W_ = block->end;
  return block;
}

Expected<motion::PathBlock, Diagnostic> BlockPreparation::thread_line(const lang::Move& move,
                                                                      const motion::BlockTag& tag) {
  auto block = block_without_feed(move, tag);
  if (block) position_W_ = block->end;
  return block;
}

// All stretches end like the curve does; only the last one may stop.
Expected<std::vector<motion::PathBlock>, Diagnostic> BlockPreparation::curve(
    const lang::SplineMove& spline, const motion::BlockTag& tag) {
  const std::array<int, 2> plane = plane_axes(spline.base.plane);
  motion::PlanarNurbs nurbs{
      spline.degree, {{motion::at(position_W_, plane[0]), motion::at(position_W_, plane[1])}}, {}};
  nurbs.points.insert(nurbs.points.end(), spline.points.begin(), spline.points.end());
  nurbs.weights = spline.weights;
  const auto stretches = motion::stretches_of(nurbs, curve_deviation_mm);
  if (stretches.empty()) {  // a point, in the plane
    auto point = block(spline.base, tag);
    if (!point) return Unexpected<Diagnostic>(point.error());
    return std::vector{*point};
  }
  auto whole = block_without_feed(spline.base, tag);
  if (!whole) return Unexpected<Diagnostic>(whole.error());
  std::vector<motion::PathBlock> blocks;
  std::vector<double> lengths;
  motion::Point from_W = position_W_;
  for (const motion::CurveStretch& stretch : stretches) {
    motion::PathBlock part = *whole;
    part.kind = motion::BlockKind::curve;
    part.plane = plane;
    part.curve = stretch.coefficients;
    if (&stretch != &stretches.back()) {
      part.ending = motion::BlockEnding::continuous;
      part.end = point_on(position_W_, whole->end, stretch, plane);
    }
    lengths.push_back(length_of(from_W, part));
    from_W = part.end;
    blocks.push_back(part);
  }
  const auto travel = travel_of(*whole, std::accumulate(lengths.begin(), lengths.end(), 0.0));
  if (auto refusal = process_.apply(spline.base, travel, *whole))
    return Unexpected<Diagnostic>(std::move(*refusal));
  position_W_ = whole->end;
  double path_start = whole->process.path_start;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].feed_per_s = whole->feed_per_s;
    blocks[k].process = whole->process;
    blocks[k].process.path_start = path_start;
    blocks[k].process.path_length = lengths[k];
    path_start += lengths[k];
  }
  return blocks;
}

}  // namespace stanok::channels
