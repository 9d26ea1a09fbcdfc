#include "lang/corners/line_angle.h"

#include <cmath>

#include "base/angle.h"
#include "lang/block/axis_words.h"
#include "lang/corners/corner_value.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {
namespace {

// Below, a line is parallel to the axis whose coordinate the block gives: rounding of the angle.
constexpr double parallel = 1e-9;

WordName place_of_angle(const ActiveBlock& block) {
  const auto word = corner_value(block, angle_word);
  return word ? word->place : WordName{};
}

struct LineAxes {
  AxisIndex first;
  AxisIndex second;
};

// Where the block goes along an axis, in programmed coordinates.
double programmed_end(const ActiveBlock& block, AxisIndex axis) {
  const bool from_position = (block.incremental & axis_bit(axis)) != 0 ||
                             (block.modal.incremental() && (block.absolute & axis_bit(axis)) == 0);
  const double before = from_position ? block.modal.programmed_position(axis) : 0.0;
  return before + block.values[axis];
}

void put(ActiveBlock& block, AxisIndex axis, double programmed) {
  block.values[axis] = programmed;
  block.programmed = static_cast<AxisSet>(block.programmed | axis_bit(axis));
  block.absolute = static_cast<AxisSet>(block.absolute | axis_bit(axis));
  block.incremental = static_cast<AxisSet>(block.incremental & ~axis_bit(axis));
}

// The other coordinate of the point at which the line from the position has `given`.
void complete_line(ActiveBlock& block, AxisIndex given, AxisIndex other, double along_given,
                   double along_other) {
  if (std::abs(along_given) < parallel) {
    block.fail("E4153", place_of_angle(block),
               "a line of this angle has no point with this coordinate",
               "parallel to the other axis");
    return;
  }
  const double way = programmed_end(block, given) - block.modal.programmed_position(given);
  const double end = block.modal.programmed_position(other) + way * along_other / along_given;
  put(block, other, end);
}

}  // namespace

void collect_line_angle(ActiveBlock& block) {
  if (!has_corner_words(block) || !corner_value(block, angle_word)) return;
  if (block.programmed != 0) return;
  const AxisIndex any = block.channel_words.geometry_axis(0);
  if (!any.exists()) return;
  put(block, any, block.modal.programmed_position(any));
  block.end.corner.line.end = LineByAngle::End::at_next_line;
}

void take_line_angle(ActiveBlock& block) {
  if (!has_corner_words(block)) return;
  const auto word = corner_value(block, angle_word);
  if (!word) return;
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  const LineAxes axes{block.channel_words.geometry_axis(plane.first),
                      block.channel_words.geometry_axis(plane.second)};
  if (!axes.first.exists() || !axes.second.exists() || block.modal.transformation.axis >= 0) {
    block.fail("E4153", place_of_angle(block), "a line cannot be given by its angle in this plane",
               "needs a plane of two axes");
    return;
  }
  LineByAngle& line = block.end.corner.line;
  const double along_first = cosine_of_degrees(word->value);
  const double along_second = sine_of_degrees(word->value);
  line.direction = {block.modal.map.gain(axes.first) * along_first,
                    block.modal.map.gain(axes.second) * along_second};
  if (line.end == LineByAngle::End::at_next_line) return;
  const bool has_first = is_programmed(block, axes.first);
  const bool has_second = is_programmed(block, axes.second);
  if (has_first && !has_second) {
    complete_line(block, axes.first, axes.second, along_first, along_second);
  } else if (has_second && !has_first) {
    complete_line(block, axes.second, axes.first, along_second, along_first);
  } else {
    line.end = has_first ? LineByAngle::End::given : LineByAngle::End::at_next_line;
  }
}

void check_line_angle(ActiveBlock& block, const Code* axis_user) {
  if (!has_corner_words(block) || !corner_value(block, angle_word)) return;
  const bool is_line = axis_user != nullptr && axis_user->number == g(1);
  if (!is_line) {
    block.fail("E4153", place_of_angle(block), "`,A` needs a line at feed, G1", "no such motion");
  } else if (block.modal.feed.law.kind != FeedLaw::Kind::off || block.law_feed != 0.0) {
    block
        .fail("E4153", place_of_angle(block),
              "a feed law is not possible along a line by its angle", "a law is active")
        .help.emplace_back("write the end of the line with both coordinates");
  }
}

}  // namespace stanok::lang
