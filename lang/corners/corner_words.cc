#include "lang/corners/corner_words.h"

#include <cmath>
#include <string>

#include "lang/corners/corner_value.h"
#include "lang/words/corner_word.h"

namespace stanok::lang {
namespace {

// Of lengths in the plane, by scaling; none where its axes are scaled differently.
std::optional<double> gain_in_plane(const ActiveBlock& block) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  const auto gain = [&block](std::size_t coordinate) {
    return std::abs(block.modal.map.gain(block.channel_words.geometry_axis(coordinate)));
  };
  if (gain(plane.first) != gain(plane.second)) return std::nullopt;
  return gain(plane.first);
}

bool has_plane(const ActiveBlock& block) {
  const PlaneCoordinates& plane = plane_coordinates[block.modal.plane()];
  return block.channel_words.geometry_axis(plane.first).exists() &&
         block.channel_words.geometry_axis(plane.second).exists();
}

std::string name_of_word(const WordName& word) {
  return word.letter == 0 ? word.name : std::string(1, word.letter);
}

// Which axis alone the block had to move for its chamfer I or K; 0: it does, or has none.
char axis_of_square_chamfer(const ActiveBlock& block, const WordName& place) {
  if (place.letter != 'I' && place.letter != 'K') return 0;
  const bool behind_z = place.letter == 'I';
  const AxisIndex axis = block.channel_words.geometry_axis(behind_z ? 2 : 0);
  const bool alone = axis.exists() && block.programmed == axis_bit(axis) &&
                     block.words.has('I') != block.words.has('K');
  return alone ? '\0' : behind_z ? 'Z' : 'X';
}

}  // namespace

void read_corner(ActiveBlock& block) {
  if (!has_corner_words(block)) return;
  const auto chamfer = corner_value(block, chamfer_word);
  const auto rounding = corner_value(block, rounding_word);
  const auto& word = chamfer ? chamfer : rounding;
  if (!word) return;
  const WordName& place = word->place;
  if (chamfer && rounding) {
    block.fail("E4150", place, "a corner has a chamfer or a rounding", "both in one block");
  } else if (!block.flow.moves) {
    block.fail("E4150", place, "`" + name_of_word(place) + "` needs a motion in its block",
               "no motion");
  } else if (const char axis = axis_of_square_chamfer(block, place); axis != 0) {
    block
        .fail("E4150", place,
              "`" + name_of_word(place) + "` is a chamfer after a move of " + axis + " alone",
              "another move")
        .help.emplace_back("write the chamfer as `C` or `,C`");
  } else if (word->value < 0.0) {
    block.fail("E4008", place, "`" + name_of_word(place) + "` must not be negative", "negative");
  } else if (!has_plane(block) || block.modal.transformation.axis >= 0) {
    block.fail("E4150", place, "a corner is not possible in this plane",
               "needs a plane of two axes");
  } else if (block.modal.feed.law.kind != FeedLaw::Kind::off || block.law_feed != 0.0) {
    block.fail("E4150", place, "a feed law is not possible along a corner", "a law is active")
        .help.emplace_back("write the corner as a separate G1, G2 or G3");
  } else if (const auto gain = gain_in_plane(block)) {
    const auto kind = chamfer ? CornerRequest::Kind::chamfer : CornerRequest::Kind::rounding;
    block.end.corner.kind = kind;
    block.end.corner.size_mm = word->value * block.length_unit() * *gain;
  } else {
    block
        .fail("E4303", place,
              "a corner is not possible while the axes of its plane are scaled "
              "differently",
              "scaled differently")
        .notes.push_back(block.modal.origin_of(Group::scaling));
  }
}

}  // namespace stanok::lang
