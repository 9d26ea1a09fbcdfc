#include "lang/block/radius_compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stanok::lang {
namespace {

// Commands without plane motion that may follow an element before the next one.
constexpr std::size_t waiting_max = 100;

// Full turns of an arc are recognised within this (rad).
constexpr double same_angle = 1e-9;

FaultOfCommand compensation_fault(const Origin& origin, std::string_view code, std::string message,
                                  std::string label) {
  return {{code, {}, std::move(message), std::move(label), {}, {}}, origin};
}

// Imaginary tip of a lathe tool from the centre of its nose, in (Z, X) and radii; orientations 1 to
// 8 as in LinuxCNC. 0 and 9: the centre itself.
PlanePoint tip_direction(int orientation) {
  static constexpr PlanePoint directions[] = {{0, 0}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1},
                                              {1, 0}, {0, -1}, {-1, 0},  {0, 1},  {0, 0}};
  return directions[orientation];
}

Move* straight_or_arc(Payload& payload) {
  if (auto* move = std::get_if<Move>(&payload)) return move;
  if (auto* synchronous = std::get_if<SynchronousMove>(&payload)) return &synchronous->line;
  if (auto* probe = std::get_if<ProbeMove>(&payload)) return &probe->line;
  return nullptr;
}

bool is_arc(const Command& command, const Move& move) {
  return move.kind == MoveKind::arc || std::holds_alternative<SplineMove>(command.payload);
}

bool changes_coordinates(const Command& command) {
  return std::holds_alternative<ToolLength>(command.payload) ||
         std::holds_alternative<FrameChange>(command.payload);
}

// Travel of an element in mm.
double travel_along(const PlaneElement& element) {
  return element.arc ? element.sweep * norm(element.start - element.centre) : extent(element);
}

}  // namespace

void CompensationStage::reset() {
  state_ = State::off;
  selected_ = {};
  deviation_ = {};
  held_.reset();
  law_.reset();
  waiting_.clear();
  ready_.clear();
}

PlanePoint CompensationStage::plane_point(const AxisValues& values) const {
  return {values[first_], values[second_]};
}

void CompensationStage::set_plane_point(AxisValues& values, PlanePoint point) const {
  values[first_] = point.first;
  values[second_] = point.second;
}

StageResult CompensationStage::select(const RadiusCompensation& wanted, const AxisValues& start_W) {
  if (wanted == selected_) return std::nullopt;
  if (!wanted.on()) {
    auto fault = finish();
    selected_ = wanted;
    const bool stands_off = norm(deviation_) > same_point;
    state_ = stands_off ? State::leaving : State::off;
    coordinates_changed_ = false;
    return fault;
  }
  if (wanted.radius_mm == 0.0) {
    selected_ = wanted;
    return std::nullopt;
  }
  first_ = words_.geometry_axis(plane_coordinates[wanted.plane].first);
  second_ = words_.geometry_axis(plane_coordinates[wanted.plane].second);
  selected_ = wanted;
  offset_ = wanted.side == RadiusCompensation::Side::left ? wanted.radius_mm : -wanted.radius_mm;
  tip_ = wanted.plane == Plane::zx ? wanted.radius_mm * tip_direction(wanted.orientation)
                                   : PlanePoint{};
  programmed_W_ = start_W;
  emitted_ = start_W;
  state_ = State::armed;
  coordinates_changed_ = false;
  return std::nullopt;
}

void CompensationStage::adopt_position() {
  deviation_ = {};
  if (state_ == State::leaving) state_ = State::off;
}

StageResult CompensationStage::take(Command& command) {
  if (state_ == State::off) {
    pass(command);
    return std::nullopt;
  }
  if (const auto* law = std::get_if<FeedLawChange>(&command.payload); law && law->of_next_block) {
    law_ = std::move(command);
    return std::nullopt;
  }
  if (Move* const move = straight_or_arc(command.payload)) return take_move(command, *move);
  if (state_ == State::leaving && changes_coordinates(command)) coordinates_changed_ = true;
  if (auto* const spline = std::get_if<SplineMove>(&command.payload)) {
    return lead_out(command, spline->base);
  }
  if (const auto* request = std::get_if<ProgramRequest>(&command.payload)) {
    if (compensating() && request->kind != RequestKind::terminate) {
      FaultOfCommand fault = compensation_fault(command.origin, "E4140",
                                                "the program must wait here until the axes stop",
                                                "radius compensation is active");
      fault.fault.help.push_back("switch it off with `G40` first");
      return fault;
    }
  }
  const bool end = std::holds_alternative<ProgramEnd>(command.payload);
  if (!end && !std::holds_alternative<ProgramRequest>(command.payload))
    return wait_with_element(command);
  auto fault = finish();
  pass(command);
  if (end) state_ = State::off;
  return fault;
}

StageResult CompensationStage::wait_with_element(Command& command) {
  if (!held_) {
    pass(command);
    return std::nullopt;
  }
  if (waiting_.size() == waiting_max) {
    return compensation_fault(command.origin, "E4148",
                              "too many blocks follow without a move in the plane",
                              "radius compensation needs the next move");
  }
  waiting_.push_back(command);
  return std::nullopt;
}

// A move that is no element of the contour, with the law of its block.
StageResult CompensationStage::wait_with_law(Command& command) {
  if (law_) {
    Command law = std::move(*law_);
    law_.reset();
    if (auto fault = wait_with_element(law)) return fault;
  }
  return wait_with_element(command);
}

void CompensationStage::pass_law() {
  if (!law_) return;
  Command law = std::move(*law_);
  law_.reset();
  pass(law);
}

bool CompensationStage::moves_in_plane(const Move& move) const {
  if (move.kind == MoveKind::arc) return true;
  if (move.machine_coordinates || coordinates_changed_) {
    return (move.words & (axis_bit(first_) | axis_bit(second_))) != 0;
  }
  return norm(plane_point(move.end) - plane_point(programmed_W_)) > same_point;
}

StageResult CompensationStage::take_move(Command& command, Move& move) {
  if (!moves_in_plane(move)) {
    programmed_W_ = move.end;
    return wait_with_law(command);
  }
  if (!compensating()) return lead_out(command, move);
  if (state_ == State::armed) return lead_in(command, move);
  return continue_contour(command, move);
}

StageResult CompensationStage::lead_in(Command& command, Move& move) {
  if (move.kind == MoveKind::arc) return lead_in_by_arc(command, move);
  const PlanePoint start = plane_point(programmed_W_) + deviation_;
  const PlanePoint end = plane_point(move.end);
  if (norm(end - start) <= std::abs(offset_)) {
    return compensation_fault(
        command.origin, "E4144",
        "the move that leads in to radius compensation is not longer than the radius", "too short");
  }
  held_ = Held{{start, end, false, {}, false, 0.0}, command, start, 0.0, true,
               std::exchange(law_, std::nullopt)};
  programmed_W_ = move.end;
  state_ = State::active;
  return std::nullopt;
}

// The arc from where the tool is to the perpendicular at the end of the programmed arc, which it
// leaves in the programmed direction. It goes on as the parallel of an arc about its own centre.
StageResult CompensationStage::lead_in_by_arc(Command& command, Move& move) {
  if (!selected_.arc_leads_in) {
    return compensation_fault(command.origin, "E4143", "radius compensation begins with an arc",
                              "G0 or G1 must come first");
  }
  PlaneElement element = element_of(move);
  if (parallel_end_radius(element, offset_) < same_point) {
    return compensation_fault(command.origin, "E4145",
                              "the tool is too large for the inside of this arc",
                              "the radius is smaller than the tool's");
  }
  const PlanePoint start = plane_point(programmed_W_) + deviation_ - tip_;
  const PlanePoint way = element.end + offset_ * left_of(end_tangent(element)) - start;
  const PlanePoint inwards =
      (1.0 / norm(element.centre - element.end)) * (element.centre - element.end);
  // From the end of the way along `inwards`, as far from its start.
  const double radius = dot(way, way) / (-2.0 * dot(way, inwards));
  const double outside = element.counter_clockwise ? -offset_ : offset_;
  if (!(radius > std::max(outside, 0.0) + same_point)) {
    return compensation_fault(command.origin, "E4143",
                              "an arc cannot lead in to radius compensation from here",
                              "begin with G0 or G1");
  }
  element.centre = start + way + radius * inwards;
  const PlanePoint outwards = (1.0 / radius) * (start - element.centre);
  element.start = element.centre + (radius - outside) * outwards;
  element = with_sweep(element, move.turns);
  move.centre = {element.centre.first, element.centre.second};
  held_ = Held{element, command, start, 0.0, false, std::exchange(law_, std::nullopt)};
  programmed_W_ = move.end;
  state_ = State::active;
  return std::nullopt;
}

PlaneElement CompensationStage::element_of(const Move& move) const {
  const PlanePoint start = plane_point(programmed_W_);
  const PlanePoint end = plane_point(move.end);
  if (move.kind != MoveKind::arc) return {start, end, false, {}, false, 0.0};
  const PlanePoint centre{move.centre[0], move.centre[1]};
  return with_sweep({start, end, true, centre, move.counter_clockwise, 0.0}, move.turns);
}

StageResult CompensationStage::continue_contour(Command& command, const Move& move) {
  Held next{element_of(move), command, {}, 0.0, false, std::exchange(law_, std::nullopt)};
  if (next.element.arc && std::min(parallel_start_radius(next.element, offset_),
                                   parallel_end_radius(next.element, offset_)) < -same_point) {
    return compensation_fault(command.origin, "E4145",
                              "the tool is too large for the inside of this arc",
                              "the radius is smaller than the tool's");
  }
  Corner corner = corner_between(held_->element, next.element, offset_);
  const bool inside = corner.turn * offset_ > 0.0;
  if (held_->lead_in && inside) {
    corner = {};
    corner.start_after = next.element.start + offset_ * left_of(start_tangent(next.element));
    corner.end_before = corner.start_after;
  }
  if (corner.kind == CornerKind::none) {
    return compensation_fault(command.origin, "E4146",
                              "the tool cannot reach the corner before this block",
                              "the offset paths do not meet");
  }
  const Held before = *held_;
  if (auto fault = emit_held(corner.end_before, corner.cut_before)) return fault;
  release_waiting();
  if (corner.kind == CornerKind::round) emit_round(corner, before, command);
  next.start = corner.start_after;
  next.cut = corner.cut_after;
  held_ = std::move(next);
  programmed_W_ = move.end;
  return std::nullopt;
}

// The first plane move after G40; without one to leave from, it just passes.
StageResult CompensationStage::lead_out(Command& command, Move& move) {
  if (is_arc(command, move)) {
    return compensation_fault(command.origin, "E4143", "radius compensation ends with an arc",
                              "G0 or G1 must come first");
  }
  pass_law();
  if (move.machine_coordinates) {
    pass(command);
  } else {
    move.words = static_cast<AxisSet>(move.words | axis_bit(first_) | axis_bit(second_));
    deviation_ = {};
    pass(command);
  }
  deviation_ = {};
  state_ = State::off;
  return std::nullopt;
}

StageResult CompensationStage::finish() {
  if (!held_) return std::nullopt;
  const PlaneElement element = held_->element;
  auto fault = emit_held(element.end + offset_ * left_of(end_tangent(element)), 0.0);
  if (!fault) release_waiting();
  held_.reset();
  waiting_.clear();
  state_ = State::armed;
  return fault;
}

// The held element up to `end` of its parallel, which cuts `cut` from it.
StageResult CompensationStage::emit_held(PlanePoint end, double cut) {
  const Held held = std::move(*held_);
  held_.reset();
  const double remaining = extent(held.element) - held.cut - cut;
  if (!held.lead_in && remaining < -same_point) {
    waiting_.clear();
    return compensation_fault(held.command.origin, "E4147",
                              "the tool is too large: this element vanishes between its corners",
                              "shorter than the corners need");
  }
  const Move move = parallel_move(held, end, remaining);
  deviation_ = end + tip_ - held.element.end;
  if (move.end == emitted_ && move.kind != MoveKind::arc) return std::nullopt;
  emitted_ = move.end;
  ready_.set_origin(held.command.origin, held.command.block);
  if (held.law) ready_.emit(held.law->payload);
  ready_.emit(move);
  return std::nullopt;
}

Move CompensationStage::parallel_move(const Held& held, PlanePoint end, double remaining) const {
  Move move = std::get<Move>(held.command.payload);
  move.words = static_cast<AxisSet>(move.words | axis_bit(first_) | axis_bit(second_));
  const PlanePoint point = end + tip_;
  set_plane_point(move.end, point);
  if (!held.element.arc) return move;
  const double radius = parallel_start_radius(held.element, offset_);
  if (radius < same_point || remaining * radius < same_point) {
    move.kind = MoveKind::line;
    return move;
  }
  move.centre = {move.centre[0] + tip_.first, move.centre[1] + tip_.second};
  const double turns = std::max(std::ceil((remaining - same_angle) / full_turn), 1.0);
  move.turns = static_cast<int>(turns);
  // An arc that ends where it starts is a full circle only if the numbers are the same.
  if (std::abs(remaining - turns * full_turn) < same_angle) {
    set_plane_point(move.end, plane_point(emitted_));
  }
  return move;
}

// Around the programmed corner. Two rapids: by lines outside the arc, no more than a quarter turn
// each.
void CompensationStage::emit_round(const Corner& corner, const Held& before, const Command& after) {
  const Move& first = std::get<Move>(before.command.payload);
  const Move& second = std::get<Move>(after.payload);
  const PlanePoint centre = before.element.end + tip_;
  ready_.set_origin(after.origin, after.block);
  Move move = second.kind == MoveKind::rapid ? first : second;
  const bool rapid = move.kind == MoveKind::rapid;
  move.words = static_cast<AxisSet>(axis_bit(first_) | axis_bit(second_));
  move.stop_at_end = false;
  move.end = emitted_;
  if (rapid) {
    const int parts = static_cast<int>(std::ceil(std::abs(corner.turn) / quarter_turn));
    const double half_part = corner.turn / (2.0 * parts);
    const PlanePoint radius = corner.end_before + tip_ - centre;
    for (int k = 1; k < 2 * parts; k += 2) {
      const double angle = k * half_part;
      const PlanePoint turned = std::cos(angle) * radius + std::sin(angle) * left_of(radius);
      set_plane_point(move.end, centre + (1.0 / std::cos(half_part)) * turned);
      ready_.emit(move);
    }
  } else {
    const double arc_length = std::abs(corner.turn * offset_);
    if (move.feed_mode == FeedMode::inverse_time && second.kind != MoveKind::rapid) {
      move.feed *= travel_along(element_of(second)) / arc_length;
    }
    move.kind = MoveKind::arc;
    move.plane = selected_.plane;
    move.counter_clockwise = corner.turn > 0.0;
    move.turns = 1;
    move.centre = {centre.first, centre.second};
  }
  set_plane_point(move.end, corner.start_after + tip_);
  ready_.emit(move);
  emitted_ = move.end;
  deviation_ = corner.start_after + tip_ - before.element.end;
}

void CompensationStage::release_waiting() {
  for (Command& command : waiting_) pass(command);
  waiting_.clear();
}

// Gives a command out; moves along with the plane axes where the tool is.
void CompensationStage::pass(Command& command) {
  if (Move* const move = straight_or_arc(command.payload)) {
    const AxisIndex axes[] = {first_, second_};
    const double off[] = {deviation_.first, deviation_.second};
    for (std::size_t k = 0; k < 2; ++k) {
      const bool named = (move->words & axis_bit(axes[k])) != 0;
      if (!(move->machine_coordinates && named)) move->end[axes[k]] += off[k];
    }
    emitted_ = move->end;
  }
  ready_.set_origin(command.origin, command.block);
  ready_.emit(std::move(command.payload));
}

}  // namespace stanok::lang
