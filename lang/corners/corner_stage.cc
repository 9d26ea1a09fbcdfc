#include "lang/corners/corner_stage.h"

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

std::string name_of(const CornerRequest& request) {
  return request.kind == CornerRequest::Kind::chamfer ? "chamfer `,C`" : "rounding `,R`";
}

}  // namespace

void CornerStage::reset() {
  request_ = {};
  held_.reset();
  waiting_.clear();
  ready_.clear();
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
  return move.kind == MoveKind::line && norm(plane_point(move.end) - start_) > same_point;
}

StageResult CornerStage::take(Command& command) {
  if (held_) {
    if (std::holds_alternative<Move>(command.payload)) return go_on(command);
    if (may_wait(command.payload) && waiting_.size() < commands_waiting_max) {
      waiting_.push_back(std::move(command));
      return std::nullopt;
    }
    return corner_fault(command, "E4151",
                        "the " + name_of(held_->request) + " needs the next move of the contour",
                        "comes between the two moves");
  }
  if (request_.wanted() && move_of(command.payload) != nullptr) return begin(command);
  pass(command);
  return std::nullopt;
}

StageResult CornerStage::begin(Command& command) {
  const Move* const move = std::get_if<Move>(&command.payload);
  const CornerRequest request = std::exchange(request_, {});
  if (move == nullptr || !is_element(*move)) {
    return corner_fault(command, "E4150",
                        "a " + name_of(request) + " needs a line at feed or an arc in the plane",
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
                        "behind a " + name_of(held_->request) +
                            " a line at feed or an arc in the plane must follow",
                        "another motion");
  }
  const PlaneElement next = element_of(move, start_);
  const CornerCut cut = cut_corner(held_->element, next, held_->request);
  if (cut.fit == CornerCut::Fit::too_large) {
    return corner_fault(held_->command, "E4152",
                        "the " + name_of(held_->request) + " does not fit into its corner",
                        "too large for one of the two moves");
  }
  PlanePoint from = start_;
  if (cut.fit == CornerCut::Fit::fits) {
    emit_cut(cut);
    from = cut.start_after;
  } else {
    pass(held_->command);
  }
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
  pass(held_->command);
  held_.reset();
  release();
}

void CornerStage::pass(Command& command) {
  ready_.set_origin(command.origin, command.block);
  ready_.emit(std::move(command.payload));
}

}  // namespace stanok::lang
