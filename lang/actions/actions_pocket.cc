// Actions of pockets: G12 and G13, circular ones, and G150, with islands.
//
// G12 clockwise, G13 counter-clockwise: the tool stands over the centre. It goes down to Z at feed,
// by half a circle to the first radius I, around, with K and Q on to larger circles, Q apart up to
// K, and by half a circle back to the centre, where it stays in the depth. D is the tool whose
// radius the circles are smaller by (D0: none). In G91 L makes as many levels, Z deeper each.
// Source: Haas mill operator's manual, G12 and G13; where the first circle begins (along the first
// axis) the manual leaves open.
//
// G150: the outline with its islands is a subprogram.
// Source: Haas mill operator's manual, G150: P is the subprogram, X Y the point where the tool
// comes down, Z the depth, R the level from which it does, Q the depth of a level, I or J the way
// between lines along Y or X, K what stays at the walls for a last pass in the depth; G41 or G42 in
// the block says on which side of the outline the pocket lies, D its tool. At the end the tool
// stands over the start point on the level R.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lang/actions/actions.h"
#include "lang/actions/block_execution.h"
#include "lang/pockets/pocket_plan.h"

namespace stanok::lang {
namespace {

constexpr double circles_max = 10000.0;  // of a block; all of them are held at once
constexpr double coordinate_noise = 1e-9;

struct Pocket {
  AxisIndex first;  // axes of the plane, and of the depth
  AxisIndex second;
  AxisIndex depth;
  bool counter_clockwise = false;
  std::vector<double> radii_mm;  // of the tool's centre
  std::vector<double> levels;    // along the depth, W
};

class PocketMoves {
 public:
  PocketMoves(ActiveBlock& block, const Pocket& pocket)
      : block_(block), pocket_(pocket), centre_(block.modal.position_W) {}

  void run() {
    for (const double level : pocket_.levels) {
      AxisValues down = centre_;
      down[pocket_.depth] = level;
      centre_[pocket_.depth] = level;
      line(down, axis_bit(pocket_.depth));
      const double first = pocket_.radii_mm.front();
      arc(first, first / 2.0);
      for (std::size_t k = 0; k < pocket_.radii_mm.size(); ++k) {
        if (k > 0) line(point(pocket_.radii_mm[k]), axis_bit(pocket_.first));
        arc(pocket_.radii_mm[k], 0.0);
      }
      arc(0.0, pocket_.radii_mm.back() / 2.0);
    }
  }

 private:
  // On the first axis, `away` from the centre.
  [[nodiscard]] AxisValues point(double away) const {
    AxisValues p = centre_;
    p[pocket_.first] += away;
    return p;
  }

  void line(const AxisValues& end, AxisSet words) {
    Move move;
    move.kind = MoveKind::line;
    move.end = end;
    move.words = words;
    emit(move);
  }

  // To `end_away`, about a point on the first axis.
  void arc(double end_away, double centre_away) {
    Move move;
    move.kind = MoveKind::arc;
    move.end = point(end_away);
    move.words = static_cast<AxisSet>(axis_bit(pocket_.first) | axis_bit(pocket_.second));
    move.plane = block_.modal.plane();
    move.counter_clockwise = pocket_.counter_clockwise;
    move.centre = {centre_[pocket_.first] + centre_away, centre_[pocket_.second]};
    emit(move);
  }

  void emit(Move& move) {
    if (block_.failed()) return;
    resolve_feed(block_, move);
    if (block_.failed()) return;
    advance_position(block_, move);
    block_.queue.emit(move);
  }

  ActiveBlock& block_;
  const Pocket& pocket_;
  AxisValues centre_;
};

bool find_axes(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  pocket.first = block.channel_words.geometry_axis(plane.first);
  pocket.second = block.channel_words.geometry_axis(plane.second);
  pocket.depth = block.channel_words.geometry_axis(plane.normal);
  if (pocket.first.exists() && pocket.second.exists() && pocket.depth.exists()) return true;
  block.fail("E4036", code_word(code), "the channel lacks an axis of the pocket", "")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return false;
}

// Lengths in the plane, by scaling and mirror; 0, with the block failed, when a circle is none.
double gain_of_plane(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const double first = block.modal.map.gain(pocket.first);
  const double second = block.modal.map.gain(pocket.second);
  if (first * second < 0.0) pocket.counter_clockwise = !pocket.counter_clockwise;
  if (std::abs(first) == std::abs(second)) return std::abs(first);
  block.fail("E4303", code_word(code), "the axes of the circle are scaled by different factors",
             "no circle");
  return 0.0;
}

bool find_radii(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  const std::string name = "`" + code_text('G', code) + "`";
  const auto refuse = [&](char letter, const std::string& why) {
    block.fail(block.has(letter) ? "E4008" : "E4007",
               block.has(letter) ? WordName{letter, -1, {}} : code_word(code),
               name + " needs " + why, "");
    return false;
  };
  const double gain = gain_of_plane(block, code, pocket);
  const auto tool = tool_of_radius(block, code);
  if (block.failed() || !tool) return false;
  const double first = block.has('I') ? gain * block.length('I') : 0.0;
  const double last = block.has('K') ? gain * block.length('K') : first;
  const double step = block.has('Q') ? gain * block.length('Q') : 0.0;
  if (first <= 0.0) return refuse('I', "I, the radius of the first circle, above zero");
  if (last < first) return refuse('K', "K, the radius of the last circle, of at least I");
  if (last > first && step <= 0.0) return refuse('Q', "Q, the step from circle to circle");
  if (block.has('Q') && !block.has('K')) return refuse('K', "K with Q, the last radius");
  if (first <= tool->radius_mm) return refuse('I', "a circle that is larger than the tool");
  if (step > 0.0 && (last - first) / step > circles_max) return refuse('Q', "a larger step Q");
  for (int n = 0; first + n * step < last - coordinate_noise; ++n)
    pocket.radii_mm.push_back(first + n * step - tool->radius_mm);
  pocket.radii_mm.push_back(last - tool->radius_mm);
  return true;
}

bool find_levels(ActiveBlock& block, CodeNumber code, Pocket& pocket) {
  if (!only_axes(block, code, axis_bit(pocket.depth))) return false;
  Move move;
  resolve_ends(block, move);
  const double start = block.modal.position_W[pocket.depth];
  const double step = move.end[pocket.depth] - start;
  const auto count = block.has('L') ? block.integer('L', 1, 9999) : 1;
  if (!count) return false;
  if (*count > 1 && !block.modal.incremental()) {
    block.fail("E4016", {'L', -1, {}},
               "the levels of a pocket are measured from the current position", "needs `G91`");
    return false;
  }
  if (*count * static_cast<double>(pocket.radii_mm.size()) > circles_max) {
    block.fail("E4063", {'L', -1, {}}, "the pocket has too many circles", "too many");
    return false;
  }
  for (int k = 1; k <= *count; ++k) pocket.levels.push_back(start + k * step);
  return true;
}

constexpr std::size_t outline_elements_max = 500;  // of an outline
constexpr double pocket_moves_max = 200'000.0;     // of a block; all of them are held at once
constexpr double pocket_levels_max = 10'000.0;
constexpr double closed_within_mm = 1e-3;
constexpr double level_noise_mm = 1e-9;

struct PocketAxes {
  AxisIndex first;  // of the plane, and of the depth
  AxisIndex second;
  AxisIndex depth;

  [[nodiscard]] AxisSet plane() const {
    return static_cast<AxisSet>(axis_bit(first) | axis_bit(second));
  }
};

struct PocketLevels {
  double above = 0.0;          // R, W
  std::vector<double> depths;  // W, the last one the bottom
};

PlanePoint in_plane(const PocketAxes& axes, const AxisValues& point) {
  return {point[axes.first], point[axes.second]};
}

BlockFault& refuse(ActiveBlock& block, CodeNumber code, const std::string& why,
                   const std::string& help) {
  BlockFault& fault =
      block.fail("E4069", {'G', code, {}}, "the pocket cannot be milled: " + why, "");
  if (!help.empty()) fault.help.push_back(help);
  return fault;
}

std::optional<PocketAxes> find_axes(ActiveBlock& block, CodeNumber code) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  const PocketAxes axes{block.channel_words.geometry_axis(plane.first),
                        block.channel_words.geometry_axis(plane.second),
                        block.channel_words.geometry_axis(plane.normal)};
  if (axes.first.exists() && axes.second.exists() && axes.depth.exists()) return axes;
  block.fail("E4036", {'G', code, {}}, "the channel lacks an axis of the pocket", "")
      .notes.push_back(block.modal.origin_of(Group::plane));
  return std::nullopt;
}

bool has_its_words(ActiveBlock& block, CodeNumber code, const PocketAxes& axes) {
  const auto need = [&](char letter, const char* what) {
    if (block.has(letter) && (letter == 'P' || letter == 'R' || block.value(letter) > 0.0))
      return true;
    block.fail(block.has(letter) ? "E4008" : "E4007",
               {block.has(letter) ? letter : 'G', block.has(letter) ? -1 : code, {}},
               std::string("`G150` needs ") + what, "");
    return false;
  };
  if (!only_axes(block, code, static_cast<AxisSet>(axes.plane() | axis_bit(axes.depth))))
    return false;
  if (!need('P', "P, the subprogram of its outline") ||
      !need('R', "R, the level from which the tool plunges") ||
      !need('Q', "Q, the depth of a level, above zero"))
    return false;
  if (!is_programmed(block, axes.depth)) {
    block.fail("E4007", {'G', code, {}}, "`G150` needs the depth of the pocket", "no depth");
    return false;
  }
  if (block.has('I') == block.has('J')) {
    block.fail("E4007", {'G', code, {}},
               "`G150` needs either I or J, the step between the passes of the tool", "");
    return false;
  }
  if (block.has('K') && block.value('K') < 0.0)
    return need('K', "K, the allowance that remains at the walls");
  return need(block.has('I') ? 'I' : 'J', "a step between the passes above zero");
}

// The side on which the pocket lies, and the tool: what G41 or G42 of the block selected, which is
// over with it. Nothing: there is none.
std::optional<RadiusCompensation> take_compensation(ActiveBlock& block, CodeNumber code) {
  const RadiusCompensation selected = block.modal.compensation;
  block.modal.compensation = {};
  block.set_modal(Group::radius_compensation, g(40));
  if (selected.on() && selected.radius_mm > 0.0) return selected;
  block
      .fail("E4007", {'G', code, {}},
            selected.on() ? "`G150` needs a tool with a radius"
                          : "`G150` needs G41 or G42 in its block, the side of the outline on "
                            "which the pocket is",
            selected.on() ? "radius 0" : "no side")
      .help.emplace_back(
          "write `G41 D1` in the block; the inside of a counter-clockwise outline is on its left");
  return std::nullopt;
}

std::optional<PocketLevels> find_levels(ActiveBlock& block, const PocketAxes& axes, double bottom) {
  PocketLevels levels;
  levels.above = block.modal.map.to_work(axes.depth, block.length('R'));
  const double step = std::abs(block.modal.map.gain(axes.depth)) * block.length('Q');
  const double depth = levels.above - bottom;
  if (!(depth > 0.0)) {
    block.fail("E4062", {'R', -1, {}}, "`R` of `G150` is not above the bottom of the pocket", "");
    return std::nullopt;
  }
  if (depth / step > pocket_levels_max) {
    block.fail("E4063", {'Q', -1, {}}, "`Q` results in too many levels", "too small");
    return std::nullopt;
  }
  for (int n = 1; n * step < depth - level_noise_mm; ++n)
    levels.depths.push_back(levels.above - n * step);
  levels.depths.push_back(bottom);
  return levels;
}

std::optional<PlaneElement> element_of(const Move& move, PlanePoint start, const PocketAxes& axes,
                                       Plane plane) {
  PlaneElement element;
  element.start = start;
  element.end = in_plane(axes, move.end);
  if (move.kind != MoveKind::arc) return element;
  if (move.plane != plane || move.turns != 1) return std::nullopt;
  element.arc = true;
  element.centre = {move.centre[0], move.centre[1]};
  element.counter_clockwise = move.counter_clockwise;
  return with_sweep(element, 1);
}

// The first move leads to the outline; the others are it.
std::vector<OutlineElement> outline_of(ActiveBlock& block, CodeNumber code, const PocketAxes& axes,
                                       const std::vector<Command>& commands, PlanePoint start) {
  std::vector<OutlineElement> outline;
  PlanePoint at = start;
  bool leads_in = true;
  for (const Command& command : commands) {
    if (move_of(command.payload) == nullptr) continue;
    const auto* const move = std::get_if<Move>(&command.payload);
    const auto element = move != nullptr && !move->machine_coordinates
                             ? element_of(*move, at, axes, block.modal.plane())
                             : std::nullopt;
    const std::string line = std::to_string(command.origin.line);
    if (!element || (move->words & ~axes.plane()) != 0) {
      refuse(block, code,
             "its outline may contain only lines and arcs in the plane, see line " + line,
             "remove other moves from the subprogram");
      return {};
    }
    at = element->end;
    const bool moves = element->arc || norm(element->end - element->start) > same_point;
    if (!leads_in && moves) outline.push_back({*element, command.origin.line});
    leads_in = false;
  }
  if (outline.empty()) {
    refuse(block, code, "the subprogram has no outline",
           "its first move leads from the start point to the outline; the others are the outline");
  } else if (outline.size() > outline_elements_max) {
    refuse(block, code,
           "its outline has more than " + std::to_string(outline_elements_max) + " elements",
           "split the pocket");
  } else if (const double gap = norm(outline.back().element.end - outline.front().element.start);
             gap > closed_within_mm) {
    refuse(block, code, "its outline is open by " + std::to_string(gap) + " mm",
           "end it where the first move of the subprogram ends");
  }
  return outline;
}

// An outline that runs the other way, so that its left becomes its right.
void turn_about(std::vector<OutlineElement>& outline) {
  std::reverse(outline.begin(), outline.end());
  for (OutlineElement& one : outline) {
    std::swap(one.element.start, one.element.end);
    one.element.counter_clockwise = !one.element.counter_clockwise;
  }
}

void turn_about(std::vector<PocketWay>& ways) {
  for (PocketWay& way : ways) std::reverse(way.begin(), way.end());
}

class ContourPocketMoves {
 public:
  ContourPocketMoves(ActiveBlock& block, const PocketAxes& axes, double above)
      : block_(block), axes_(axes), above_(above) {}

  // Over the start point, and to R; from below R it goes up first.
  void approach(PlanePoint start) {
    lift();
    over(start);
    if (block_.modal.position_W[axes_.depth] > above_)
      go(MoveKind::rapid, at_depth(above_), axis_bit(axes_.depth));
  }
  // A way in a depth; where the tool is not at its begin, it comes down there from above.
  void cut(const PocketWay& way, double depth) {
    const AxisValues& position = block_.modal.position_W;
    const bool is_there = position[axes_.depth] == depth &&
                          norm(in_plane(axes_, position) - way.front()) <= same_point;
    if (!is_there) {
      lift();
      over(way.front());
      go(MoveKind::line, at_depth(depth), axis_bit(axes_.depth));
    }
    for (std::size_t k = 1; k < way.size(); ++k) {
      if (norm(way[k] - in_plane(axes_, position)) <= same_point) continue;
      go(MoveKind::line, at_point(way[k]), axes_.plane());
    }
  }
  void end(PlanePoint start) {
    lift();
    over(start);
  }

 private:
  void lift() {
    if (block_.modal.position_W[axes_.depth] < above_)
      go(MoveKind::rapid, at_depth(above_), axis_bit(axes_.depth));
  }
  void over(PlanePoint point) {
    if (norm(in_plane(axes_, block_.modal.position_W) - point) > same_point)
      go(MoveKind::rapid, at_point(point), axes_.plane());
  }
  [[nodiscard]] AxisValues at_depth(double depth) const {
    AxisValues end = block_.modal.position_W;
    end[axes_.depth] = depth;
    return end;
  }
  [[nodiscard]] AxisValues at_point(PlanePoint point) const {
    AxisValues end = block_.modal.position_W;
    end[axes_.first] = point.first;
    end[axes_.second] = point.second;
    return end;
  }
  void go(MoveKind kind, const AxisValues& end, AxisSet words) {
    if (block_.failed()) return;
    Move move;
    move.kind = kind;
    move.end = end;
    move.words = words;
    resolve_feed(block_, move);
    if (block_.failed()) return;
    advance_position(block_, move);
    block_.queue.emit(move);
  }

  ActiveBlock& block_;
  const PocketAxes& axes_;
  double above_;
};

void mill(ActiveBlock& block, CodeNumber code, const PocketAxes& axes, const PocketLevels& levels,
          const PocketPlan& plan, PlanePoint start) {
  double moves = 0.0;
  for (const PocketWay& way : plan.level) moves += static_cast<double>(way.size());
  if (moves * static_cast<double>(levels.depths.size()) > pocket_moves_max) {
    block.fail("E4063", {'G', code, {}}, "the pocket needs too many moves", "too many")
        .help.emplace_back("use deeper levels Q or a larger step between the passes");
    return;
  }
  ContourPocketMoves tool(block, axes, levels.above);
  tool.approach(start);
  for (const double depth : levels.depths) {
    for (const PocketWay& way : plan.level) tool.cut(way, depth);
  }
  for (const PocketWay& way : plan.finish) tool.cut(way, levels.depths.back());
  tool.end(start);
}

}  // namespace

void mill_circular_pocket(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(
          block, code,
          {Exclusion::radius_compensation, Exclusion::transformation, Exclusion::inverse_time}))
    return;
  Pocket pocket;
  pocket.counter_clockwise = code == g(13);
  if (!find_axes(block, code, pocket) || !find_radii(block, code, pocket) ||
      !find_levels(block, code, pocket))
    return;
  PocketMoves(block, pocket).run();
}

void mill_contour_pocket(ActiveBlock& block, CodeNumber code) {
  const auto selected = take_compensation(block, code);
  if (!selected ||
      excluded_by_mode(block, code, {Exclusion::transformation, Exclusion::inverse_time}))
    return;
  const auto axes = find_axes(block, code);
  if (!axes || !has_its_words(block, code, *axes)) return;
  const double gain = std::abs(block.modal.map.gain(axes->first));
  if (gain != std::abs(block.modal.map.gain(axes->second))) {
    block.fail("E4303", {'G', code, {}}, "the axes of the pocket are scaled by different factors",
               "");
    return;
  }
  const auto number = block.integer('P', 1, 99999999);
  if (!number) return;
  Move to_bottom;
  resolve_ends(block, to_bottom);
  const auto levels = find_levels(block, *axes, to_bottom.end[axes->depth]);
  if (!levels) return;
  if (block.contours == nullptr)
    return void(refuse(block, code, "a contour cannot hold a cycle", ""));
  const Contour contour = block.contours->subprogram(*number);
  if (!contour.problem.empty()) {
    refuse(block, code, contour.problem,
           "the outline is the subprogram with N or O and the number P: plain blocks up to M99");
    return;
  }
  ModalState modal = block.modal;
  modal.position_W[axes->first] = to_bottom.end[axes->first];
  modal.position_W[axes->second] = to_bottom.end[axes->second];
  const PlanePoint start = in_plane(*axes, modal.position_W);
  const ContourCommands made = commands_of(block, contour, std::move(modal));
  if (!made.problem.empty()) return void(refuse(block, code, made.problem, ""));
  PocketWish wish;
  wish.outline = outline_of(block, code, *axes, made.commands, start);
  if (block.failed()) return;
  const bool left = selected->side == RadiusCompensation::Side::left;
  if (!left) turn_about(wish.outline);
  wish.start = start;
  wish.radius_mm = selected->radius_mm;
  wish.finish_mm = block.has('K') ? gain * block.length('K') : 0.0;
  wish.step_mm = gain * block.length(block.has('I') ? 'I' : 'J');
  wish.lines = block.has('J') ? ScanLines::along_first : ScanLines::along_second;
  if (wish.step_mm > 2.0 * wish.radius_mm) {
    refuse(block, code,
           "its passes are farther apart than the tool is wide, so material would remain",
           "use at most the diameter of the tool for I or J");
    return;
  }
  auto plan = plan_pocket(wish);
  if (!plan) {
    const PocketFault& fault = plan.error();
    refuse(block, code,
           fault.message + (fault.line == 0 ? "" : ", see line " + std::to_string(fault.line)),
           fault.help);
    return;
  }
  // Around the walls the tool has the pocket on the side that the block says.
  if (!left) turn_about(plan->finish);
  mill(block, code, *axes, *levels, *plan, start);
}

}  // namespace stanok::lang
