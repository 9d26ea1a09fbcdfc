// Action of circular and helical motion.
//
// Symbols: c centre, p0 and p1 start and end, r0 and r1 their distances from c, in the two axes of
// the plane (first, second). Centre from a radius: the chord's midpoint moved along the chord's
// left normal n by +-sqrt(R^2 - (|p1 - p0| / 2)^2); left for a counter-clockwise arc of less than
// half a turn. On a cylinder of radius r the plane is its surface, seen from outside, with r *
// angle along it, in mm: C Z about Z, X A about X, B Y about Y.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

using Point = CurvePoint;

// Noise of coordinates in mm that were inches: a radius that exceeds half the chord by no more
// makes half a circle.
constexpr double coordinate_rounding = 1e-12;

struct ArcPlane {
  AxisIndex first;  // axes of the plane
  AxisIndex second;
  char first_centre = 'I';  // words of the centre
  char second_centre = 'J';
  double first_gain = 1.0;  // of lengths, by scaling and mirror
  double second_gain = 1.0;
  double first_scale = 1.0;  // mm per unit of the axis
  double second_scale = 1.0;
  Group set_by = Group::plane;  // whose code says which plane it is

  [[nodiscard]] Point point(const AxisValues& values) const {
    return {first_scale * values[first], second_scale * values[second]};
  }
};

std::string in_mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

std::optional<ArcPlane> arc_plane_of(ActiveBlock& block, CodeNumber code) {
  static constexpr std::array centre_words{'I', 'J', 'K'};
  if (const AxisIndex face_axis = block.modal.face_axis(); face_axis.exists()) {
    const std::size_t radial = block.modal.transformation.radial;
    ArcPlane face{block.modal.geometry[radial], face_axis, centre_words[radial],
                  centre_words[(radial + 1) % 3]};
    face.set_by = Group::transformation;
    return face;
  }
  const PlaneCoordinates& coordinates = plane_coordinates[block.modal.plane()];
  ArcPlane plane{block.channel_words.geometry_axis(coordinates.first),
                 block.channel_words.geometry_axis(coordinates.second),
                 centre_words[coordinates.first], centre_words[coordinates.second]};
  if (!plane.first.exists() || !plane.second.exists()) {
    block.fail("E4036", code_word(code), "the channel lacks an axis of the arc's plane", "")
        .notes.push_back(block.modal.origin_of(Group::plane));
    return std::nullopt;
  }
  plane.first_gain = block.modal.map.gain(plane.first);
  plane.second_gain = block.modal.map.gain(plane.second);
  if (std::abs(plane.first_gain) != std::abs(plane.second_gain)) {
    block
        .fail("E4303", code_word(code),
              "an arc is not possible while the axes of its plane are scaled differently",
              "it would become an ellipse")
        .notes.push_back(block.modal.origin_of(Group::scaling));
    return std::nullopt;
  }
  return plane;
}

// X and C, Y and A, Z and B.
Plane plane_of_face(const ActiveBlock& block) {
  static constexpr std::array planes{Plane::xy, Plane::yz, Plane::zx};
  return planes.at(block.modal.transformation.radial);
}

bool is_on_cylinder(const ActiveBlock& block) {
  if (block.modal.code(Group::transformation) != g(7, 1)) return false;
  return is_programmed(block, block.modal.transformation.axis);
}

// The surface of G7.1: J along C and K along Z, I along X and J along A, I along B and J along Y.
std::optional<ArcPlane> surface_plane(ActiveBlock& block, CodeNumber code) {
  static constexpr std::array words{'I', 'J', 'K'};
  const ActiveTransformation& cylinder = block.modal.transformation;
  const std::size_t coordinate = cylinder.along;
  const AxisIndex along = block.channel_words.geometry_axis(coordinate);
  if (!along.exists()) {
    block
        .fail("E4036", code_word(code),
              std::string("the channel lacks ") + "XYZ"[coordinate] + ", the axis of the cylinder",
              "")
        .notes.push_back(block.modal.origin_of(Group::transformation));
    return std::nullopt;
  }
  const double scale = cylinder.cylinder_radius_mm * std::numbers::pi / 180.0;
  const bool begins_along = cylinder.along == 0;
  ArcPlane plane{cylinder.axis, along};
  if (begins_along) std::swap(plane.first, plane.second);
  (begins_along ? plane.second_scale : plane.first_scale) = scale;
  plane.first_centre = words[cylinder.along == 2 ? 1 : 0];
  plane.second_centre = words[cylinder.along == 2 ? 2 : 1];
  plane.set_by = Group::transformation;
  (begins_along ? plane.first_gain : plane.second_gain) = block.modal.map.gain(along);
  if (std::abs(block.modal.map.gain(along)) == 1.0) return plane;
  block
      .fail("E4303", code_word(code),
            std::string("an arc on a cylinder is not possible while ") + "XYZ"[coordinate] +
                " is scaled",
            "it would become an ellipse")
      .notes.push_back(block.modal.origin_of(Group::scaling));
  return std::nullopt;
}

// Controls of Fanuc and Haas leave the third word of a centre alone; many posts write it as 0.
bool says_nothing(const ActiveBlock& block, char letter) {
  return block.words.rules.is_fanuc() && block.value(letter) == 0.0;
}

bool check_centre_words(ActiveBlock& block, const ArcPlane& plane, CodeNumber code) {
  const std::string plane_name = code_text('G', block.modal.code(plane.set_by));
  for (const char letter : {'I', 'J', 'K'}) {
    if (!block.has(letter) || letter == plane.first_centre || letter == plane.second_centre ||
        says_nothing(block, letter)) {
      continue;
    }
    block
        .fail("E4030", {letter, -1, {}},
              std::string("`") + letter + "` is not in the plane of the arc",
              "not used in " + plane_name)
        .notes.push_back(block.modal.origin_of(plane.set_by));
    return false;
  }
  const bool has_centre = block.has(plane.first_centre) || block.has(plane.second_centre);
  if (has_centre && block.has('R')) {
    block.fail("E4037", {'R', -1, {}}, "an arc has a centre or a radius, not both",
               "both are given");
    return false;
  }
  if (has_centre || block.has('R')) return true;
  block
      .fail("E4031", code_word(code),
            "`" + code_text('G', code) + "` needs " + plane.first_centre + ", " +
                plane.second_centre + " or R",
            "arc in plane " + plane_name + " without centre or radius")
      .notes.push_back(block.modal.origin_of(plane.set_by));
  return false;
}

std::optional<Point> centre_from_words(ActiveBlock& block, const ArcPlane& plane, const Point& p0) {
  if (block.modal.code(Group::arc_distance) == g(90, 1)) {
    for (const char letter : {plane.first_centre, plane.second_centre}) {
      if (block.has(letter)) continue;
      block
          .fail("E4038", {}, std::string("with an absolute centre `") + letter + "` is needed too",
                "the centre is incomplete")
          .notes.push_back(block.modal.origin_of(Group::arc_distance));
      return std::nullopt;
    }
    const CoordinateMap& map = block.modal.map;
    const double first = block.length(plane.first_centre);
    const double second = block.length(plane.second_centre);
    return Point{plane.first_scale == 1.0 ? map.to_work(plane.first, first) : first,
                 plane.second_scale == 1.0 ? map.to_work(plane.second, second) : second};
  }
  const double i = block.has(plane.first_centre) ? block.length(plane.first_centre) : 0.0;
  const double j = block.has(plane.second_centre) ? block.length(plane.second_centre) : 0.0;
  return Point{p0[0] + plane.first_gain * i, p0[1] + plane.second_gain * j};
}

std::optional<Point> centre_from_radius(ActiveBlock& block, const ArcPlane& plane, const Point& p0,
                                        const Point& p1, const Move& move) {
  const double radius = std::abs(plane.first_gain) * block.length('R');
  const double dx = p1[0] - p0[0];
  const double dy = p1[1] - p0[1];
  const double chord = std::hypot(dx, dy);
  if (chord == 0.0) {
    block
        .fail("E4034", {'R', -1, {}}, "a full circle cannot be given by its radius",
              "end and start are the same point")
        .help.push_back("give the centre with I and J");
    return std::nullopt;
  }
  const double half = chord / 2.0;
  const double missing = half - std::abs(radius);
  if (missing > block.channel.arc_radius_tolerance_mm) {
    block.fail("E4035", {'R', -1, {}}, "the radius is too small to reach the end point",
               "at least " + in_mm(half) + " mm are needed");
    return std::nullopt;
  }
  const double height =
      missing >= -coordinate_rounding ? 0.0 : std::sqrt((radius - half) * (radius + half));
  const double side = move.counter_clockwise == (radius > 0.0) ? 1.0 : -1.0;
  const double scale = side * height / chord;
  return Point{p0[0] + dx / 2.0 - dy * scale, p0[1] + dy / 2.0 + dx * scale};
}

// How far the radii may differ. Programs of LinuxCNC may do so as far as there: by a thousandth of
// the radius too, up to a hundred times of the tolerance (LinuxCNC, interp_arc.cc and
// CENTER_ARC_RADIUS_TOLERANCE).
double radius_tolerance(const ActiveBlock& block, double radius) {
  const double usual = block.channel.arc_radius_tolerance_mm;
  if (!block.words.rules.is_linuxcnc()) return usual;
  constexpr double per_radius = 0.001;
  constexpr double largest = 100.0;
  const double fixed =
      2.0 * std::numbers::sqrt2 * (block.modal.inches() ? 0.001 * mm_per_inch : 0.01);
  return std::max({usual, fixed, std::min(per_radius * radius, largest * fixed)});
}

bool check_radii(ActiveBlock& block, const Point& p0, const Point& p1, const Point& c,
                 CodeNumber code) {
  const double r0 = std::hypot(p0[0] - c[0], p0[1] - c[1]);
  const double r1 = std::hypot(p1[0] - c[0], p1[1] - c[1]);
  if (r0 == 0.0) {
    block.fail("E4033", code_word(code), "the arc starts at its own centre", "radius 0");
    return false;
  }
  if (std::abs(r1 - r0) <= radius_tolerance(block, std::max(r0, r1))) return true;
  block
      .fail("E4032", code_word(code), "start and end of the arc have different radii",
            "radius " + in_mm(r0) + " mm at the start, " + in_mm(r1) + " mm at the end")
      .notes.push_back(block.modal.origin_of(Group::arc_distance));
  return false;
}

}  // namespace

void move_in_arc(ActiveBlock& block, CodeNumber code) {
  const bool has_arc_word = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  if (block.programmed == 0 && !has_arc_word) return;
  const bool on_cylinder = is_on_cylinder(block);
  const auto plane = on_cylinder ? surface_plane(block, code) : arc_plane_of(block, code);
  if (!plane || !check_centre_words(block, *plane, code)) return;

  Move move;
  move.kind = MoveKind::arc;
  const bool about_z = on_cylinder && block.modal.transformation.along == 2;
  move.plane = about_z                            ? Plane::yz
               : on_cylinder                      ? Plane::xy
               : block.modal.face_axis().exists() ? plane_of_face(block)
                                                  : block.modal.plane();
  const bool mirrored = plane->first_gain * plane->second_gain < 0.0;
  move.counter_clockwise = (code == g(3)) != mirrored;
  resolve_ends(block, move);
  const Point p0 = plane->point(block.modal.position_W);
  const Point p1 = plane->point(move.end);
  const auto centre = block.has('R') ? centre_from_radius(block, *plane, p0, p1, move)
                                     : centre_from_words(block, *plane, p0);
  if (!centre || !check_radii(block, p0, p1, *centre, code)) return;
  move.centre = *centre;
  if (block.has('P')) {
    const auto turns = block.integer('P', 1, 1000000);
    if (!turns) return;
    move.turns = *turns;
  }
  resolve_feed(block, move);
  if (block.failed()) return;
  advance_position(block, move);
  block.queue.emit(move);
}

}  // namespace stanok::lang
