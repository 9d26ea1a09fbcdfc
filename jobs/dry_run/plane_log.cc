#include "jobs/dry_run/plane_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stanok::jobs {
namespace {

constexpr double same_deg = 1e-6;

// What P asks for beside G53.1 and G53.6.
constexpr std::array signs{std::pair{"P1", lang::FirstRotary::positive},
                           std::pair{"P2", lang::FirstRotary::negative}};

bool are_same(const std::vector<RotaryAngle>& a, const std::vector<RotaryAngle>& b) {
  return std::ranges::equal(a, b, [](const RotaryAngle& one, const RotaryAngle& two) {
    return one.word == two.word && std::abs(one.deg - two.deg) < same_deg;
  });
}

}  // namespace

void PlaneLog::note(const Place& place, const lang::AxisValues& from_B,
                    const lang::AxisValues& to_B) {
  lang::AlignmentWish wish;
  wish.tool_B = tables_.spindle_axes(to_B)[2];
  wish.from_B = to_B;
  const lang::AxisSet turned = tables_.alignment(wish).axes;
  PlanePosition position{
      .place = place, .tool = wish.tool_B, .axes = angles(turned, to_B), .other = {}};
  const auto known = std::ranges::find_if(found_, [&](const PlanePosition& one) {
    return one.place.file == place.file && one.place.line == place.line &&
           are_same(one.axes, position.axes);
  });
  if (known != found_.end() || found_.size() >= count_max) return;
  wish.from_B = from_B;
  position.other = other(wish, position.axes);
  found_.push_back(std::move(position));
}

std::vector<RotaryAngle> PlaneLog::angles(lang::AxisSet axes,
                                          const lang::AxisValues& angles_B) const {
  const lang::MachineReading reading = tables_.machine_reading();
  std::vector<RotaryAngle> found;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    if ((axes & lang::axis_bit(k)) != 0)
      found.push_back({words_[k], reading.in_machine(k, angles_B[k])});
  }
  return found;
}

std::optional<PlanePosition::Other> PlaneLog::other(const lang::AlignmentWish& wish,
                                                    const std::vector<RotaryAngle>& taken) const {
  for (const auto& [word, first] : signs) {
    lang::AlignmentWish asked = wish;
    asked.first = first;
    const lang::Alignment there = tables_.alignment(asked);
    if (there.outcome == lang::Alignment::Outcome::found) {
      auto axes = angles(there.axes, there.angles_B);
      if (!are_same(axes, taken)) return PlanePosition::Other{word, std::move(axes), {}};
    } else if (there.outcome == lang::Alignment::Outcome::beyond_limit) {
      return PlanePosition::Other{
          word, {{words_[there.axis.place()], there.needed_deg}}, there.limit_deg};
    }
  }
  return std::nullopt;
}

}  // namespace stanok::jobs
