// A corner between two elements of a contour, cut by a chamfer or rounded by an arc tangent to
// both.
//
// The chamfer begins and ends at its size from the corner, in a straight line: along lines, and as
// a chord of arcs. The rounding is the arc of its radius between both elements, on the inside of
// the corner. Plane coordinates as in lang/elements/plane_element.h; mm, rad.
#pragma once

#include <cstdint>

#include "lang/elements/plane_element.h"

namespace stanok::lang {

// What a block says of its line by an angle besides its end.
struct LineByAngle {
  enum class End : std::uint8_t {
    of_words,      // the block has no such line, or its words give the end
    at_next_line,  // where it meets the line of the next block, which has `given`
    given,         // with an angle besides: it ends a line whose end was not known
  };
  End end = End::of_words;
  PlanePoint direction{};  // of the line; its length says nothing
};

struct CornerRequest {
  enum class Kind : std::uint8_t { none, chamfer, rounding };
  Kind kind = Kind::none;
  double size_mm = 0.0;  // of the chamfer, or the radius
  LineByAngle line{};

  [[nodiscard]] bool cuts() const { return kind != Kind::none && size_mm > 0.0; }
  [[nodiscard]] bool wanted() const { return cuts() || line.end != LineByAngle::End::of_words; }
};

struct CornerCut {
  enum class Fit : std::uint8_t {
    fits,
    is_smooth,  // less than a degree of turn: nothing is cut
    too_large,  // for one of the elements, or no arc touches both
  };
  Fit fit = Fit::fits;
  PlanePoint end_before{};  // of the element before
  PlanePoint start_after{};
  double cut_before = 0.0;  // mm on a line, rad on an arc
  double cut_after = 0.0;
  PlanePoint centre{};  // of the rounding
  bool counter_clockwise = false;
};

// `before` ends where `after` starts.
[[nodiscard]] CornerCut cut_corner(const PlaneElement& before, const PlaneElement& after,
                                   const CornerRequest& request);

}  // namespace stanok::lang
