// Polar input, G16: the words of the plane's first and second axis are a radius and an angle.
//
// The centre is the zero of the program, for a radius in G91 the position. What a block leaves out
// stays as it was; an angle in G91 is added. Angles in deg, from the first axis towards the second.
// Source: Fanuc operator's manual B-63944EN, 5.5. Moves and drilling cycles have them; other codes,
// and G53, take their words as they are.
//
// The words `@` and `^` give one point in the plane XY: its distance from the zero of the program,
// and its angle from X. What a block leaves out is that of the position; in G91 both are added to
// those of the position. Source: LinuxCNC, "G-Code Overview", Polar Coordinates.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/angle.h"
#include "lang/block/axis_words.h"
#include "lang/elements/plane_element.h"
#include "lang/words/polar_word.h"

namespace stanok::lang {
namespace {

void centre_at_position(const ActiveBlock& block, const PlaneAxes& axes, PolarInput& polar) {
  polar.centre = {block.modal.programmed_position(axes.first),
                  block.modal.programmed_position(axes.second)};
}

WordName place_of(const NamedWord& word) {
  return {0, -1, word.name};
}

const NamedWord* first_polar_word(const BlockWords& words) {
  const auto found = std::ranges::find_if(
      words.named, [](const NamedWord& word) { return is_polar_word(word.name); });
  return found == words.named.end() ? nullptr : &*found;
}

void put_polar_point(ActiveBlock& block, const PlaneAxes& axes, const PolarInput& polar) {
  block.values[axes.first] = polar.centre[0] + polar.radius * cosine_of_degrees(polar.angle_deg);
  block.values[axes.second] = polar.centre[1] + polar.radius * sine_of_degrees(polar.angle_deg);
  const auto both = static_cast<AxisSet>(axis_bit(axes.first) | axis_bit(axes.second));
  block.programmed = static_cast<AxisSet>(block.programmed | both);
  block.absolute = both;
}

// As if the position had been programmed with radius and angle.
void begin_polar_input(const ActiveBlock& block, const PlaneAxes& axes, PolarInput& polar) {
  const double first = block.modal.programmed_position(axes.first);
  const double second = block.modal.programmed_position(axes.second);
  polar = {};
  polar.plane = block.modal.plane();
  polar.radius = std::hypot(first, second);
  polar.angle_deg = std::atan2(second, first) * 180.0 / std::numbers::pi;
}

bool takes_polar_words(const Code& code) {
  switch (code.action) {
    case CodeAction::move_straight:
    case CodeAction::move_in_arc:
    case CodeAction::drill_hole:
    case CodeAction::drill_or_repeat:
    case CodeAction::peck_or_tap:
    case CodeAction::bore_or_thread:
      return true;
    default:
      return false;
  }
}

void refuse_other_motion(ActiveBlock& block, const Code& code) {
  if (code.group != Group::motion || takes_polar_words(code)) return;
  BlockFault& fault =
      block.fail("E4301", code_word(code.number),
                 "`" + code_text('G', code.number) + "` is not allowed while polar input is active",
                 "not in this mode");
  fault.notes.push_back(block.modal.origin_of(Group::polar));
  fault.help.emplace_back("switch it off with `G15` first");
}

// The modes of the block, which are in force here, allow a point of the plane XY.
bool allows_polar_words(ActiveBlock& block, const Code& user) {
  const WordName place = place_of(*first_polar_word(block.words));
  if (!takes_polar_words(user) || block.machine_coordinates) {
    const std::string code = block.machine_coordinates ? "G53" : code_text('G', user.number);
    block.fail("E4301", place, "`" + code + "` does not take `@` and `^`", "needs X and Y");
  } else if (block.modal.plane() != Plane::xy || block.modal.transformation.axis >= 0) {
    block.fail("E4301", place, "`@` and `^` mean a point in the plane XY", "needs G17")
        .notes.push_back(block.modal.origin_of(Group::plane));
  } else if (block.modal.code(Group::polar) == g(16)) {
    block
        .fail("E4301", place, "`@` and `^` are not allowed while polar input is active",
              "needs G15")
        .notes.push_back(block.modal.origin_of(Group::polar));
  }
  return !block.failed();
}

void put_point_of_polar_words(ActiveBlock& block, const Code& user) {
  const NamedWord* const distance = block.words.called(polar_distance_word);
  const NamedWord* const angle = block.words.called(polar_angle_word);
  if (!allows_polar_words(block, user)) return;
  const PlaneAxes axes = plane_axes(block);
  PolarInput& polar = block.modal.frames.polar;
  begin_polar_input(block, axes, polar);
  const double radius = distance == nullptr ? 0.0 : distance->value * block.length_unit();
  const double angle_deg = angle == nullptr ? 0.0 : angle->value;
  if (block.modal.incremental()) {
    if (polar.radius == 0.0) {
      block.fail("E4008", place_of(*first_polar_word(block.words)),
                 "an increment in polar coordinates has no direction when the axes are at zero",
                 "X0 Y0 here");
      return;
    }
    polar.step_radius = radius;
    polar.step_deg = angle_deg;
    polar.radius += radius;
    polar.angle_deg += angle_deg;
  } else {
    if (distance != nullptr) polar.radius = radius;
    if (angle != nullptr) polar.angle_deg = angle_deg;
  }
  put_polar_point(block, axes, polar);
}

}  // namespace

void collect_polar_words(ActiveBlock& block) {
  if (block.words.named.empty()) return;
  const NamedWord* const word = first_polar_word(block.words);
  if (word == nullptr) return;
  const PlaneAxes axes{block.channel_words.geometry_axis(0), block.channel_words.geometry_axis(1)};
  if (!axes.first.exists() || !axes.second.exists()) {
    block.fail("E4306", place_of(*word), "the channel has no axes X and Y for `@` and `^`", "");
  } else if (is_programmed(block, axes.first) || is_programmed(block, axes.second)) {
    block.fail("E4304", place_of(*word), "X and Y exclude `@` and `^`", "both in one block");
  } else {
    const auto both = static_cast<AxisSet>(axis_bit(axes.first) | axis_bit(axes.second));
    block.programmed = static_cast<AxisSet>(block.programmed | both);
  }
}

void take_polar_words(ActiveBlock& block, const Code& user) {
  if (first_polar_word(block.words) != nullptr) return put_point_of_polar_words(block, user);
  const bool begins = block.words.g.has(g(16));
  if (block.modal.code(Group::polar) != g(16) || block.machine_coordinates) return;
  refuse_other_motion(block, user);
  if (!takes_polar_words(user) || block.failed()) return;
  const PlaneAxes axes = plane_axes(block);
  if (!axes.first.exists() || !axes.second.exists()) return;
  const bool has_radius = is_programmed(block, axes.first);
  const bool has_angle = is_programmed(block, axes.second);
  PolarInput& polar = block.modal.frames.polar;
  if (begins || !polar.is_known || polar.plane != block.modal.plane())
    begin_polar_input(block, axes, polar);
  polar.is_known = true;
  if (!has_radius && !has_angle) return;
  const bool increments = block.modal.incremental();
  polar.from_position = has_radius && increments;
  polar.step_deg = 0.0;
  if (has_radius) {
    polar.radius = block.values[axes.first];
    polar.centre = {};
    if (increments) centre_at_position(block, axes, polar);
  }
  if (has_angle) {
    const double angle_deg = block.values[axes.second] / block.length_unit();
    if (increments) polar.step_deg = angle_deg;
    polar.angle_deg = polar.step_deg + (increments ? polar.angle_deg : angle_deg);
  }
  put_polar_point(block, axes, polar);
}

void repeat_polar_words(ActiveBlock& block) {
  if (block.absolute == 0) return;
  const PlaneAxes axes = plane_axes(block);
  PolarInput& polar = block.modal.frames.polar;
  if (polar.from_position) centre_at_position(block, axes, polar);
  polar.radius += polar.step_radius;
  polar.angle_deg += polar.step_deg;
  put_polar_point(block, axes, polar);
}

}  // namespace stanok::lang
