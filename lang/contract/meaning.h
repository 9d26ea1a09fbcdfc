// Meaning: everything that gives a word of a program its meaning, as it is from one block to the
// next: the active codes, the chain of frames, the tool and its length, scaling and mirror.
//
// A value that never changes: what changes is which one is in effect. The channel numbers them;
// path and items carry the number. For displays, touching off and logs; made by the interpreter,
// which has the one that its next block will be read in. Lengths mm, angles deg, axes in the order
// of the channel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lang/contract/active_codes.h"
#include "lang/contract/changed_rows.h"

namespace stanok::lang {

// A system of X, Y and Z that lies within another one: p = rotation * p_within + shift, mm.
struct SystemWithin {
  bool is_on = false;
  Rotation rotation;
  std::array<double, 3> shift{};
};

// Each term of p_B = work offset - overhang + its rotation * set-up error * (G52 + G92 + plane *
// (its G52 + G68 * p_W)), and of W: w = gain * word + shift. A term that is off is 0.
struct MeaningTerms {
  FrameChange frame;              // all of it together: W in B
  AxisValues work_offset_B{};     // of the table; under G54.2 where the rotary table has brought it
  Rotation work_offset_rotation;  // G10 L2 R
  AxisValues local_shift{};       // G52
  AxisValues axis_shift{};        // G92
  int overhang_axis = -1;         // #tool_overhang
  double overhang_mm = 0.0;
  SystemWithin set_up_error;            // G54.4
  SystemWithin plane;                   // G68.2 to G68.4
  std::array<double, 3> plane_shift{};  // G52 along the axes of the plane
  SystemWithin rotation;                // G68
  AxisValues gain{};                    // G51, G51.1
  AxisValues shift{};
  ToolInPlace tool;
  ToolLength length;
  int radius_offset = -1;  // D; -1: none
  TransformationChange transformation;
  std::array<AxisIndex, 3> geometry{};  // the channel's X, Y, Z

  MeaningTerms() { gain.fill(1.0); }
};

struct Meaning {
  ActiveCodes codes{};
  std::shared_ptr<const MeaningTerms> terms = std::make_shared<const MeaningTerms>();

  [[nodiscard]] bool inches() const { return codes[Group::units] == g(20); }
  // Whether the word of this axis is a diameter.
  [[nodiscard]] bool is_diameter(std::size_t axis) const;
};

// The words that lead to a point of the path in W, under G90: radius and angle under G16, diameters
// under G7; mm and deg, whatever unit the program has.
[[nodiscard]] AxisValues words_at(const Meaning& meaning, const AxisValues& point_W);
// A way along the axes in W as differences of words; under G16 too along the axes.
[[nodiscard]] AxisValues words_of_way(const Meaning& meaning, const AxisValues& way_W);

struct MeaningChange {
  std::uint64_t block = 0;  // running number in the run; 0: its start
  Meaning meaning;
};

// The changes of a run until somebody takes them; who never does loses the oldest.
class MeaningChanges {
 public:
  // Where the terms are the ones of before they are not copied.
  void note(std::uint64_t block, const ActiveCodes& codes);
  void note(std::uint64_t block, const ActiveCodes& codes, MeaningTerms terms);
  [[nodiscard]] const MeaningTerms& newest_terms() const { return *newest_.terms; }
  [[nodiscard]] std::vector<MeaningChange> take() { return std::exchange(changes_, {}); }

 private:
  static constexpr std::size_t kept_max = 256;

  void enter(std::uint64_t block);

  Meaning newest_;
  std::vector<MeaningChange> changes_;
};

}  // namespace stanok::lang
