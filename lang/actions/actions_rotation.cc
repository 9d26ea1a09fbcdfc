// Actions of the rotation of the coordinate system: G68 in the plane or about an axis, the tilted
// planes G68.2 to G68.4, G69.
//
// Symbols: c the centre, in the system that work offset, G52 and G92 make; R the rotation. A point
// p_W of the turned system stands at c + R*(p_W - c) of that system. A new G68 replaces the one
// before; words left out of the centre mean the point where the axes stand. Under a tilted plane
// that system is the plane's. A plane is given in the system of work offset, G52 and G92, G68.4 in
// that of the plane before it.
#include <cmath>
#include <optional>

#include "lang/actions/actions.h"
#include "lang/block/block_check.h"

namespace stanok::lang {
namespace {

using Coordinates = std::array<double, 3>;

bool is_about_axis(const ActiveBlock& block) {
  return block.has('I') || block.has('J') || block.has('K');
}

// What the system is turned about; fails the block when it is no direction.
Coordinates axis_of_rotation(ActiveBlock& block) {
  Coordinates axis{};
  if (!is_about_axis(block)) {
    axis[plane_coordinates[block.modal.plane()].normal] = 1.0;
    return axis;
  }
  static constexpr std::array letters{'I', 'J', 'K'};
  for (std::size_t k = 0; k < 3; ++k)
    axis[k] = block.has(letters[k]) ? block.value(letters[k]) : 0.0;
  if (axis == Coordinates{}) {
    block.fail("E4305", {'G', g(68), {}}, "the axis of `G68` has no direction",
               "I, J and K are zero");
  }
  return axis;
}

// Every axis that turns must be there, and the centre lie among them.
bool check_axes(ActiveBlock& block) {
  const bool about_axis = is_about_axis(block);
  AxisSet turning = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!about_axis && k == plane_coordinates[block.modal.plane()].normal) continue;
    const AxisIndex axis = block.modal.geometry[k];
    if (!axis.exists()) {
      block.fail("E4306", {'G', g(68), {}},
                 std::string("`G68` turns ") + "XYZ"[k] + ", which the channel does not have", "");
      return false;
    }
    turning = static_cast<AxisSet>(turning | axis_bit(axis));
  }
  return only_axes(block, g(68), turning);
}

Coordinates centre_of(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  const ProgrammedRotation& before = modal.frames.rotation;
  Coordinates from_centre{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!modal.geometry[k].exists()) continue;
    from_centre[k] = modal.position_W[modal.geometry[k]] - before.centre[k];
  }
  Coordinates centre = components(before.rotation.turned(vector3(from_centre)));
  for (std::size_t k = 0; k < 3; ++k) {
    centre[k] += before.centre[k];
    const AxisIndex axis = modal.geometry[k];
    if (axis.exists() && is_programmed(block, axis)) {
      centre[k] = modal.map.to_work(axis, block.values[axis]);
    }
  }
  return centre;
}

void change_rotation(ActiveBlock& block, const ProgrammedRotation& rotation) {
  const WorkFrame before = block.modal.frame();
  block.modal.frames.rotation = rotation;
  publish_frame(block, before);
}

// The plane is in force from here on; the tool is not aligned with it yet.
void change_plane(ActiveBlock& block, const TiltedPlane& plane) {
  FrameSettings& frames = block.modal.frames;
  const WorkFrame before = block.modal.frame();
  frames.rotation = {};
  frames.definition = {};
  frames.plane = plane;
  publish_frame(block, before);
  follow_alignment(block);
}

std::string plane_code(CodeNumber code) {
  return "`" + code_text('G', code) + "`";
}

// Words that the form has no use for.
bool only_words(ActiveBlock& block, CodeNumber code, LetterSet allowed) {
  const LetterSet refused = block.words.letters & letters_of("IJKPQR") & ~allowed;
  if (refused == 0) return true;
  const char letter = first_letter(refused);
  block.fail("E4003", {letter, -1, {}},
             std::string("`") + letter + "` has no meaning in this form of " + plane_code(code),
             "unused word");
  return false;
}

Coordinates vector_of(const ActiveBlock& block) {
  return {block.has('I') ? block.value('I') : 0.0, block.has('J') ? block.value('J') : 0.0,
          block.has('K') ? block.value('K') : 0.0};
}

// X, Y, Z of the block, mm; words left out are 0.
Coordinates point_of_block(const ActiveBlock& block) {
  Coordinates point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.modal.geometry[k];
    if (axis.exists() && is_programmed(block, axis)) point[k] = block.values[axis];
  }
  return point;
}

bool has_whole_point(ActiveBlock& block, CodeNumber code) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_programmed(block, block.modal.geometry[k])) continue;
    block.fail("E4007", {'G', code, {}}, "a point of " + plane_code(code) + " P2 needs X, Y and Z",
               std::string("no ") + "XYZ"[k]);
    return false;
  }
  return true;
}

void fail_direction(ActiveBlock& block, CodeNumber code, const std::string& why,
                    const std::string& remedy) {
  block.fail("E4351", {'G', code, {}}, plane_code(code) + " describes no plane: " + why, "no plane")
      .help.push_back(remedy);
}

// A plane given as a whole in this block: P0, P1 or P4.
std::optional<EulerAngles> angles_of(ActiveBlock& block, CodeNumber code, int form) {
  if (!only_words(block, code, letters_of(form == 1 ? "IJKPQ" : "IJKP"))) return std::nullopt;
  const Coordinates angles_deg = vector_of(block);
  if (form == 0) return angles_deg;
  if (form == 1) {
    const auto order = block.has('Q') ? block.integer('Q', 123, 321) : std::optional(123);
    if (!order) return std::nullopt;
    const auto plane = roll_pitch_yaw(angles_deg, *order);
    if (!plane) {
      block.fail("E4008", {'Q', -1, {}},
                 "Q of " + plane_code(code) +
                     " P1 is the order of the rotations about X (1), Y (2) and Z (3), each once",
                 "no such order");
    }
    return plane;
  }
  const auto plane = projected(angles_deg);
  if (!plane) {
    fail_direction(block, code, "its two lines are parallel",
                   "give projected angles I and J of less than 90 deg");
  }
  return plane;
}

// A further block of a plane that points (P2) or vectors (P3) give; the whole plane behind the
// last.
std::optional<TiltedPlane> defined_plane(ActiveBlock& block, CodeNumber code, int form) {
  PlaneDefinition& definition = block.modal.frames.definition;
  const bool by_points = form == 2;
  if (!only_words(block, code, letters_of(by_points ? "PQR" : "IJKPQR"))) return std::nullopt;
  if (!block.has('Q')) {
    block.fail("E4007", {'G', code, {}},
               plane_code(code) + " P" + std::to_string(form) + " needs Q, the number of its " +
                   (by_points ? "point" : "vector"),
               "no Q");
    return std::nullopt;
  }
  const auto number = block.integer('Q', 1, by_points ? 3 : 2);
  if (!number || (by_points && !has_whole_point(block, code))) return std::nullopt;
  const auto place = static_cast<std::size_t>(*number - 1);
  definition.form = form;
  definition.parts |= 1U << place;
  definition.values[place] = by_points ? point_of_block(block) : vector_of(block);
  if (place == 0) definition.origin = point_of_block(block);
  if (block.has('R')) definition.turn_deg = block.value('R');
  if (definition.parts != definition.all_parts()) return std::nullopt;
  const auto value = [&](std::size_t k) { return vector3(definition.values[k]); };
  const auto angles = by_points ? through_points({value(0), value(1), value(2)})
                                : along_vectors(value(0), value(1));
  if (!angles && by_points) {
    fail_direction(block, code, "its three points are on one line",
                   "choose points that are not on one line");
  } else if (!angles) {
    fail_direction(block, code, "its vectors are not perpendicular",
                   "give X (Q1) and Z (Q2) of the plane, perpendicular within 5 deg");
  }
  if (!angles) return std::nullopt;
  TiltedPlane plane;
  plane.set(definition.origin, turned_in_itself(*angles, definition.turn_deg));
  return plane;
}

// Square to the tool as it points now; X and Y lie as the spindle and the table have turned them.
TiltedPlane plane_of_tool(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  const auto axes_B = block.tables.spindle_axes(modal.frame().base_from_work(modal.position_W));
  const Rotation work = modal.frames.base_rotation();
  const EulerAngles angles =
      euler_angles(work.turned_back(vector3(axes_B[0])), work.turned_back(vector3(axes_B[2])));
  TiltedPlane plane;
  plane.set(point_of_block(block),
            turned_in_itself(angles, block.has('R') ? block.value('R') : 0.0));
  return plane;
}

TiltedPlane on_top_of(const TiltedPlane& below, const TiltedPlane& upper) {
  const Vector3<double> origin =
      vector3(below.origin) +
      below.rotation.turned(Vector3<double>(vector3(below.local_shift) + vector3(upper.origin)));
  TiltedPlane plane;
  plane.set(components(origin), euler_angles(below.rotation * upper.rotation));
  return plane;
}

bool may_tilt(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code,
                       {Exclusion::radius_compensation, Exclusion::transformation,
                        Exclusion::drilling_cycle, Exclusion::own_rotation, Exclusion::scaling,
                        Exclusion::mirror, Exclusion::carried_offset})) {
    return false;
  }
  AxisSet geometry = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.modal.geometry[k];
    geometry = static_cast<AxisSet>(geometry | axis_bit(axis));
    if (axis.exists()) continue;
    block.fail("E4306", {'G', code, {}},
               plane_code(code) + " tilts " + "XYZ"[k] + ", which the channel does not have", "");
    return false;
  }
  if (code == g(68, 4) && !block.modal.frames.plane.is_on) {
    block.fail("E4350", {'G', code, {}}, "`G68.4` needs an active tilted plane", "no plane")
        .help.emplace_back("program a plane with `G68.2` first");
    return false;
  }
  return only_axes(block, code, geometry);
}

}  // namespace

void fail_open_plane(ActiveBlock& block, const WordName& word) {
  const PlaneDefinition& definition = block.modal.frames.definition;
  std::string missing;
  for (int part = 0; (definition.all_parts() >> part) != 0; ++part) {
    if ((definition.parts >> part & 1U) == 0)
      missing += (missing.empty() ? "Q" : ", Q") + std::to_string(part + 1);
  }
  const std::string form = std::to_string(definition.form);
  block
      .fail("E4352", word,
            "the tilted plane that `G68.2 P" + form + "` began still lacks " + missing,
            "not complete")
      .help.push_back("write the blocks `G68.2 P" + form + " Q..` one after the other");
}

void tilt_plane(ActiveBlock& block, CodeNumber code) {
  if (!may_tilt(block, code)) return;
  if (code == g(68, 3)) return change_plane(block, plane_of_tool(block));
  const auto form = block.has('P') ? block.integer('P', 0, 4) : std::optional(0);
  if (!form) return;
  const PlaneDefinition& begun = block.modal.frames.definition;
  if (begun.is_open() && begun.form != *form) return fail_open_plane(block, {'G', code, {}});
  std::optional<TiltedPlane> plane;
  if (*form == 2 || *form == 3) {
    plane = defined_plane(block, code, *form);
    if (!plane && !block.failed()) block.kept_groups |= group_bit(Group::rotation);
  } else if (const auto angles = angles_of(block, code, *form)) {
    plane.emplace().set(point_of_block(block), *angles);
  }
  if (!plane || block.failed()) return;
  change_plane(block, code == g(68, 4) ? on_top_of(block.modal.frames.plane, *plane) : *plane);
}

void rotate_system(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation, Exclusion::transformation})) {
    return;
  }
  if (!block.has('R')) {
    block.fail("E4007", {'G', code, {}}, "`G68` needs R, the angle", "no R");
    return;
  }
  const Coordinates axis = axis_of_rotation(block);
  if (block.failed() || !check_axes(block)) return;
  // Displays go on naming the plane.
  if (block.modal.frames.plane.is_on) block.kept_groups |= group_bit(Group::rotation);
  const double angle_deg = block.value('R');
  change_rotation(block,
                  {Rotation::about(vector3(axis), angle_deg), axis, angle_deg, centre_of(block)});
}

void cancel_rotation(ActiveBlock& block, CodeNumber code) {
  if (block.modal.code(Group::rotation) == code) return;
  if (excluded_by_mode(block, code, {Exclusion::radius_compensation})) return;
  change_plane(block, {});
}

}  // namespace stanok::lang
