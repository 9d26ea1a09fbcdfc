#include "lang/orientation/tool_orientation.h"

#include <cmath>
#include <string>

#include "base/vector3.h"
#include "lang/feed_law/feed_law_words.h"

namespace stanok::lang {
namespace {

std::string angle_text(double angle_deg) {
  return law_number_text(std::round(angle_deg * 1e4) / 1e4 + 0.0);
}

std::string direction_text(const Direction& direction) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    text += (k == 0 ? "" : " ") + std::string(1, "XYZ"[k]) + angle_text(direction[k]);
  }
  return text;
}

std::string name_of_wish(const OrientationWish& wish) {
  if (!wish.name.empty()) return std::string(wish.name);
  return "`" + code_text('G', static_cast<CodeNumber>(wish.word.code)) + "`";
}

void fail_without_axes(ActiveBlock& block, const OrientationWish& wish) {
  block
      .fail("E4353", wish.word,
            name_of_wish(wish) +
                " needs rotary axes that tilt the tool, but the kinematic scheme has none",
            "no such axes")
      .help.emplace_back(
          "select a scheme of type head_table, head_head or table_table with `#kinematics`");
}

std::string hindrance(const ActiveBlock& block, const Alignment& found) {
  using Outcome = Alignment::Outcome;
  if (found.outcome == Outcome::beyond_limit) {
    return block.channel.axes[found.axis].word + " would have to be at " +
           angle_text(found.needed_deg) + " deg, but its limit is " + angle_text(found.limit_deg) +
           " deg";
  }
  if (found.outcome == Outcome::wrong_sign)
    return "no position within the travel has the sign that P selects";
  return "the rotary axes cannot tilt the tool this way in any position";
}

// The direction that cannot be had, what hinders, and how near the machine comes to it.
void fail_out_of_reach(ActiveBlock& block, const OrientationWish& wish, const Alignment& found) {
  BlockFault& fault =
      block.fail("E4354", wish.word,
                 name_of_wish(wish) + " cannot " + std::string(wish.purpose) + " " +
                     direction_text(wish.tool_B) + " of the table: " + hindrance(block, found),
                 "out of reach");
  fault.notes.push_back(block.modal.origin_of(wish.said_by));
  constexpr double in_reach_deg = 1e-6;
  const bool forced = wish.first != FirstRotary::nearest;
  const std::string nearest = "the nearest direction within the travel is " +
                              direction_text(found.nearest_B) + ", " + angle_text(found.off_deg) +
                              " deg off";
  const bool by_sign = forced && found.off_deg < in_reach_deg;
  fault.notes.push_back({by_sign ? "the other sign is within the travel" : nearest, {}});
  fault.help.emplace_back(wish.remedy);
}

}  // namespace

std::optional<Alignment> reachable_angles(ActiveBlock& block, const OrientationWish& wish) {
  return reachable_angles(block, wish, block.modal.frame().base_from_work(block.modal.position_W));
}

std::optional<Alignment> reachable_angles(ActiveBlock& block, const OrientationWish& wish,
                                          const AxisValues& from_B) {
  AlignmentWish asked;
  asked.tool_B = wish.tool_B;
  asked.from_B = from_B;
  asked.first = wish.first;
  const Alignment found = block.tables.alignment(asked);
  switch (found.outcome) {
    case Alignment::Outcome::found:
      return found;
    case Alignment::Outcome::no_rotary_axes:
      fail_without_axes(block, wish);
      return std::nullopt;
    default:
      fail_out_of_reach(block, wish, found);
      return std::nullopt;
  }
}

std::optional<Direction> vector_of_block(ActiveBlock& block) {
  const auto part = [&](char letter) { return block.has(letter) ? block.value(letter) : 0.0; };
  const Vector3<double> vector{part('I'), part('J'), part('K')};
  const double length = std::hypot(vector.x(), vector.y(), vector.z());
  if (length > 0.0 && std::isfinite(length)) return components(Vector3<double>(vector / length));
  block
      .fail("E4355",
            {block.has('I')   ? 'I'
             : block.has('J') ? 'J'
                              : 'K',
             -1,
             {}},
            "the tool vector I, J, K has no direction", "its length is not above 0")
      .help.emplace_back("give the direction from the tool tip to the spindle: K1 is upright");
  return std::nullopt;
}

}  // namespace stanok::lang
