// The modal state of a channel program: what earlier blocks left in force.
//
// A value: copied to be saved, replaced to be reset. Frames: the position is kept in the active
// workpiece system W, so that a programmed coordinate stays what was programmed to the last bit;
// p_B = rotation * p_W + offset, see frame(). Between the words of a program and W stand scaling
// and mirror (lang/block/coordinate_map.h).
#pragma once

#include <cstdint>

#include "base/diagnostic.h"
#include "lang/block/coordinate_map.h"
#include "lang/block/modal_parts.h"
#include "lang/block/work_frame.h"
#include "lang/contract/active_codes.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/contract/meaning.h"

namespace stanok::lang {

// Coordinates closer than this (mm or deg) are the same: far below any axis resolution, far above
// the rounding of sums of offsets.
inline constexpr double position_noise = 1e-9;
inline constexpr double mm_per_inch = 25.4;
inline constexpr double m_per_foot = 0.3048;
struct ModalState {
  // The active code of each group in tenths (G1 = 10), and the line that set it; 0 = default.
  ActiveCodes codes{};
  GroupArray<std::uint32_t> lines{};

  ModalFeed feed;
  ModalSpindles spindles;
  ModalSwitches switches;
  ModalTool tool;
  RadiusCompensation compensation;
  PathControl path;
  CycleSettings cycles;
  FrameSettings frames;
  CoordinateMap map;  // G51, G51.1
  GeometryAxes geometry{};
  ActiveTransformation transformation;
  ProgrammedCurve curve;
  AxisValues position_W{};

  [[nodiscard]] CodeNumber code(Group group) const { return codes[group]; }
  void set(Group group, CodeNumber number, std::uint32_t line) {
    codes[group] = number;
    lines[group] = line;
  }
  // "G17 is active since line 4"
  [[nodiscard]] Note origin_of(Group group) const;

  [[nodiscard]] bool incremental() const { return code(Group::distance) == g(91); }
  [[nodiscard]] bool inches() const { return code(Group::units) == g(20); }
  [[nodiscard]] bool diameters() const { return code(Group::diameter) == g(7); }
  [[nodiscard]] Plane plane() const;
  [[nodiscard]] FeedMode feed_mode() const;
  // The rotary axis that is programmed in mm (G12.1), or none.
  [[nodiscard]] AxisIndex face_axis() const {
    return code(Group::transformation) == g(12, 1) ? transformation.axis : -1;
  }
  // Everything between W and B:
  // p_B = work offset - overhang + its rotation * (G54.4, G52 + G92 + G68 * p_W).
  [[nodiscard]] WorkFrame frame() const;
  // What an absolute word would have to say, in mm and deg, for the axis to stay where it is.
  [[nodiscard]] double programmed_position(AxisIndex axis) const {
    return map.to_program(axis, position_W[axis]);
  }

  // Keeps the point in B where it is while the frame changes from `before` to frame().
  void reexpress_position(const WorkFrame& before);
  // Takes the point from B. Coordinates that agree to 1e-9 keep their programmed bits.
  void adopt_position(const AxisValues& position_B);
  // Moves the point in B, by a distance along the axes of B.
  void shift_position(const AxisValues& distance_B);
};

// The state at the start of a program, after M2, M30 and reset. Position and offsets are zero.
[[nodiscard]] ModalState default_modal_state(ChannelKind kind);

// The frame as a command.
[[nodiscard]] FrameChange frame_of(const ModalState& modal);
[[nodiscard]] MeaningTerms terms_of(const ModalState& modal);

}  // namespace stanok::lang
