// Actions of transformations: G12.1 polar face, G7.1 cylinder, G13.1 off.
//
// On the face the channel's C is programmed in mm, as the second axis of a plane with X, or, where
// the channel has no C but one of the two, A with Y or B with Z; on the
// cylinder it stays in deg, and the feed is that along the surface. Where the point stands in the
// new coordinates is the channel's knowledge: the program waits for it. The cylinder turns by C
// about Z, by A about X or by B about Y: the axis whose word has the radius.
#include <algorithm>
#include <array>

#include "lang/actions/actions.h"

namespace stanok::lang {
namespace {

bool excludes_transformation(ActiveBlock& block, CodeNumber code) {
  return excluded_by_mode(
      block, code,
      {Exclusion::radius_compensation, Exclusion::tcp, Exclusion::drilling_cycle,
       Exclusion::rotation, Exclusion::carried_offset});
}

void change(ActiveBlock& block, const TransformationChange& transformation) {
  block.modal.transformation.change = transformation;
  block.modal.transformation.axis = transformation.rotary_axis;
  block.modal.transformation.cylinder_radius_mm = transformation.radius_mm;
  block.queue.emit(transformation);
  block.queue.emit(ProgramRequest{});
  block.awaits_position = true;
}

std::optional<AxisIndex> rotary_axis(ActiveBlock& block, CodeNumber code, char word) {
  const AxisIndex axis = block.channel_words.axis_called(std::string_view(&word, 1));
  if (axis.exists() && block.channel.axes[axis].rotary) {
    if (is_spindle_now(block, axis)) {
      refuse_axis_that_is_spindle(block, axis);
      return std::nullopt;
    }
    return axis;
  }
  block.fail("E4306", {'G', code, {}},
             "`" + code_text('G', code) + "` needs a rotary axis " + word + " in the channel", "");
  return std::nullopt;
}

// A rotary axis, the linear coordinate along the cylinder about which it turns, and the one whose
// place in the planes the length around takes.
struct CylinderAxis {
  char word;
  std::size_t along;
  int replaced;
};
constexpr auto cylinder_axes = std::to_array<CylinderAxis>({{'C', 2, 1}, {'A', 0, 1}, {'B', 1, 0}});

// A rotary axis, and the linear coordinate across it in the plane of the face.
struct FaceAxis {
  char word;
  std::size_t radial;
};
constexpr auto face_axes = std::to_array<FaceAxis>({{'C', 0}, {'A', 1}, {'B', 2}});

// C, or the only one of A and B that the channel has.
const FaceAxis& face_of(const ActiveBlock& block) {
  const auto turns = [&](char word) {
    const AxisIndex axis = block.channel_words.axis_called(std::string_view(&word, 1));
    return axis.exists() && block.channel.axes[axis].rotary;
  };
  if (turns('C') || turns('A') == turns('B')) return face_axes[0];
  return turns('A') ? face_axes[1] : face_axes[2];
}

// The one whose word the block has; C where it has none.
const CylinderAxis& cylinder_of(const ActiveBlock& block) {
  const auto named = [&](const CylinderAxis& row) {
    const AxisIndex axis = block.channel_words.axis_called(std::string_view(&row.word, 1));
    return axis.exists() && is_programmed(block, axis);
  };
  const auto* const found = std::ranges::find_if(cylinder_axes, named);
  return found == cylinder_axes.end() ? cylinder_axes[0] : *found;
}

}  // namespace

void cancel_transformation(ActiveBlock& block, CodeNumber code) {
  if (block.modal.code(Group::transformation) == code || excludes_transformation(block, code))
    return;
  change(block, {});
}

void select_polar_face(ActiveBlock& block, CodeNumber code) {
  if (excludes_transformation(block, code)) return;
  if (excluded_by_mode(block, code, {Exclusion::transformation})) return;
  const FaceAxis& face = face_of(block);
  const auto axis = rotary_axis(block, code, face.word);
  if (!axis) return;
  if (!block.modal.geometry[face.radial].exists()) {
    block.fail("E4306", {'G', code, {}},
               std::string("`G12.1` needs an axis ") + "XYZ"[face.radial] + " in the channel", "");
    return;
  }
  block.modal.transformation.radial = face.radial;
  const int replaced = static_cast<int>((face.radial + 1) % 3);
  change(block, {Transformation::polar_face, 0.0, axis->number(), replaced});
}

// G7.1 Cn, An or Bn; a radius of 0 is G13.1.
void select_cylinder(ActiveBlock& block, CodeNumber code) {
  if (block.programmed == 0) {
    block.fail("E4007", {'G', code, {}}, "`G7.1` needs C, A or B, the radius of the cylinder",
               "no radius");
    return;
  }
  const CylinderAxis& cylinder = cylinder_of(block);
  const auto axis = rotary_axis(block, code, cylinder.word);
  if (!axis || !only_axes(block, code, axis_bit(*axis))) return;
  const double radius = block.values[*axis] * block.length_unit();
  if (radius < 0.0) {
    block.fail("E4008", {cylinder.word, -1, {}}, "the radius of the cylinder must not be negative",
               "negative");
    return;
  }
  if (radius == 0.0) {
    cancel_transformation(block, g(13, 1));
    block.set_modal(Group::transformation, g(13, 1));
    block.kept_groups |= group_bit(Group::transformation);
    return;
  }
  if (excludes_transformation(block, code)) return;
  if (excluded_by_mode(block, code, {Exclusion::transformation})) return;
  block.modal.transformation.along = cylinder.along;
  change(block, {Transformation::cylinder, radius, axis->number(), cylinder.replaced});
}

}  // namespace stanok::lang
