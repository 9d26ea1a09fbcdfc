#include "lang/corners/corner_stage.h"

#include <cmath>
#include <string>
#include <utility>

namespace stanok::lang {
namespace {

constexpr std::size_t commands_waiting_max = 100;

FaultOfCommand corner_fault(const Command& command, std::string_view code, std::string message,
                            std::string label) {
  return {{code, {}, std::move(message), std::move(label), {}, {}}, command.origin};
}

// What neither moves axes nor changes what their coordinates mean.
bool may_wait(const Payload& payload) {
  return std::holds_alternative<Dwell>(payload) ||
         std::holds_alternative<SpindleCommand>(payload) ||
         std::holds_alternative<CoolantCommand>(payload) ||
         std::holds_alternative<OutputCommand>(payload) ||
         std::holds_alternative<MachineFunction>(payload) ||
         std::holds_alternative<MarkCommand>(payload) || std::holds_alternative<Message>(payload) ||
         std::holds_alternative<OverrideControl>(payload);
}

bool ends_at_next_line(const CornerRequest& request) {
  return request.line.end == LineByAngle::End::at_next_line;
}

std::string name_of_corner(const CornerRequest& request) {
  if (ends_at_next_line(request)) return "line by its angle `,A`";
  return request.kind == CornerRequest::Kind::chamfer ? "chamfer `,C`" : "rounding `,R`";
}

}  // namespace

void CornerStage::reset() {
  request_ = {};
  held_.reset();
  waiting_.clear();
  ready_.clear();
}

bool CornerStage::awaits_end() const {
  return held_ && ends_at_next_line(held_->request);
}

void CornerStage::select(const CornerRequest& request, Plane plane, const AxisValues& start_W) {
  request_ = request;
  if (!request.wanted() || held_) return;
  plane_ = plane;
  first_ = words_.geometry_axis(plane_coordinates[plane].first);
  second_ = words_.geometry_axis(plane_coordinates[plane].second);
  start_ = plane_point(start_W);
}

PlanePoint CornerStage::plane_point(const AxisValues& values) const {
  return {values[first_], values[second_]};
}

PlaneElement CornerStage::element_of(const Move& move, PlanePoint start) const {
  const PlanePoint end = plane_point(move.end);
  if (move.kind != MoveKind::arc) return {start, end, false, {}, false, 0.0};
  const PlanePoint centre{move.centre[0], move.centre[1]};
  return with_sweep({start, end, true, centre, move.counter_clockwise, 0.0}, move.turns);
}

// A line at feed or an arc with a way in the plane.
bool CornerStage::is_element(const Move& move) const {
  if (move.machine_coordinates || move.feed_mode == FeedMode::inverse_time) return false;
  if (move.kind == MoveKind::arc) return move.plane == plane_;
  if (move.kind != MoveKind::line) return false;
  return ends_at_next_line(request_) || norm(plane_point(move.end) - start_) > same_point;
}

StageResult CornerStage::take(Command& command) {
  if (held_) {
    if (std::holds_alternative<Move>(command.payload)) return go_on(command);
    if (may_wait(command.payload) && waiting_.size() < commands_waiting_max) {
      waiting_.push_back(std::move(command));
      return std::nullopt;
    }
    return corner_fault(
        command, "E4151",
        "the " + name_of_corner(held_->request) + " needs the next move of the contour",
        "comes between the two moves");
  }
  if (request_.wanted() && move_of(command.payload) != nullptr) return begin(command);
  pass(command);
  return std::nullopt;
}

StageResult CornerStage::begin(Command& command) {
  const Move* const move = std::get_if<Move>(&command.payload);
  const bool is_good = move != nullptr && is_element(*move);
  const CornerRequest request = std::exchange(request_, {});
  if (request.line.end == LineByAngle::End::given) {
    return corner_fault(command, "E4153",
                        "the end is given twice, by an angle and by both coordinates",
                        "`,A` is one too many");
  }
  if (!is_good) {
    return corner_fault(
        command, "E4150",
        "a " + name_of_corner(request) + " needs a line at feed or an arc in the plane",
        "no such motion");
  }
  held_ = Held{command, element_of(*move, start_), request};
  start_ = held_->element.end;
  return std::nullopt;
}

StageResult CornerStage::go_on(Command& command) {
  const Move& move = std::get<Move>(command.payload);
  if (!is_element(move)) {
    return corner_fault(command, "E4151",
                        "after a " + name_of_corner(held_->request) +
                            " a line at feed or an arc in the plane must follow",
                        "another motion");
  }
  if (ends_at_next_line(held_->request)) {
    if (auto fault = meet(command)) return fault;
  } else if (ends_at_next_line(request_)) {
    return go_on_without_end(command);
  } else if (request_.line.end == LineByAngle::End::given) {
    return begin(command);
  }
  PlanePoint from = start_;
  if (auto fault = cut(move, from)) return fault;
  held_.reset();
  release();
  if (!request_.wanted()) {
    pass(command);
    return std::nullopt;
  }
  held_ = Held{command, element_of(move, from), std::exchange(request_, {})};
  start_ = held_->element.end;
  return std::nullopt;
}

// A line whose end comes later, behind the corner of the held move: the corner needs its direction,
// and where it meets the next line it must have a rest left.
StageResult CornerStage::go_on_without_end(Command& command) {
  constexpr double far_mm = 1e4;  // longer than the line will be
  const PlanePoint along = request_.line.direction;
  Move line = std::get<Move>(command.payload);
  const PlanePoint far = start_ + far_mm / norm(along) * along;
  line.end[first_] = far.first;
  line.end[second_] = far.second;
  PlanePoint from = start_;
  if (auto fault = cut(line, from)) return fault;
  held_.reset();
  release();
  held_ = Held{command, {from, from, false, {}, false, 0.0}, std::exchange(request_, {})};
  start_ = from;
  return std::nullopt;
}

// The held line ends where it meets that of the next move.
StageResult CornerStage::meet(const Command& command) {
  constexpr double parallel = 1e-6;  // sine of the angle between the lines: rounding of angles
  const Move& next = std::get<Move>(command.payload);
  const LineByAngle other = std::exchange(request_.line, {});
  if (other.end != LineByAngle::End::given || next.kind != MoveKind::line) {
    return corner_fault(command, "E4153",
                        "the previous line ends where it meets this one: this block needs G1, both "
                        "coordinates of its end and its angle `,A`",
                        "no line with end and angle");
  }
  const PlanePoint along = held_->request.line.direction;
  const PlanePoint way = plane_point(next.end) - start_;
  const double sine = cross(along, other.direction) / (norm(along) * norm(other.direction));
  const double ahead = cross(way, other.direction) / cross(along, other.direction);
  const double behind = cross(along, way) / cross(along, other.direction);
  const bool meets = std::abs(sine) > parallel && ahead * norm(along) > same_point &&
                     behind * norm(other.direction) > same_point;
  if (!meets) {
    return corner_fault(command, "E4153",
                        "the previous line and this one do not meet within their length",
                        "check the two angles");
  }
  Move& move = std::get<Move>(held_->command.payload);
  const PlanePoint corner = start_ + ahead * along;
  move.words = static_cast<AxisSet>(move.words | axis_bit(first_) | axis_bit(second_));
  move.end[first_] = corner.first;
  move.end[second_] = corner.second;
  held_->element.end = corner;
  start_ = corner;
  return std::nullopt;
}

// Gives out the held move, with its corner where it has one; `from`: where `move` starts then.
StageResult CornerStage::cut(const Move& move, PlanePoint& from) {
  if (!held_->request.cuts()) {
    pass(held_->command);
    return std::nullopt;
  }
  const CornerCut found = cut_corner(held_->element, element_of(move, start_), held_->request);
  switch (found.fit) {
    case CornerCut::Fit::too_large:
      return corner_fault(held_->command, "E4152",
                          "the " + name_of_corner(held_->request) + " does not fit into its corner",
                          "too large for one of the two moves");
    case CornerCut::Fit::fits:
      emit_cut(found);
      from = found.start_after;
      break;
    case CornerCut::Fit::is_smooth:
      pass(held_->command);
      break;
  }
  return std::nullopt;
}

// The held move up to the cut, where something is left of it, and the cut at its feed.
void CornerStage::emit_cut(const CornerCut& cut) {
  Move move = std::get<Move>(held_->command.payload);
  ready_.set_origin(held_->command.origin, held_->command.block);
  move.words = static_cast<AxisSet>(move.words | axis_bit(first_) | axis_bit(second_));
  move.end[first_] = cut.end_before.first;
  move.end[second_] = cut.end_before.second;
  if (extent(held_->element) - cut.cut_before > same_point) ready_.emit(move);
  const bool rounds = held_->request.kind == CornerRequest::Kind::rounding;
  move.kind = rounds ? MoveKind::arc : MoveKind::line;
  move.plane = plane_;
  move.counter_clockwise = cut.counter_clockwise;
  move.turns = 1;
  move.centre = {cut.centre.first, cut.centre.second};
  move.end[first_] = cut.start_after.first;
  move.end[second_] = cut.start_after.second;
  ready_.emit(move);
}

void CornerStage::release() {
  for (Command& command : waiting_) pass(command);
  waiting_.clear();
}

void CornerStage::finish() {
  request_ = {};
  if (!held_) return;
  if (!awaits_end()) pass(held_->command);
  held_.reset();
  release();
}

void CornerStage::pass(Command& command) {
  ready_.set_origin(command.origin, command.block);
  ready_.emit(std::move(command.payload));
}

}  // namespace stanok::lang
