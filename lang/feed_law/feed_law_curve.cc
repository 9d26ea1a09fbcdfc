#include "lang/feed_law/feed_law_curve.h"

#include <optional>
#include <string>
#include <utility>

#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

using Elements = std::span<const double>;
using MaybeFault = std::optional<BlockFault>;

BlockFault no_curve(std::string message, std::string remedy) {
  BlockFault fault = fault_at("E4345", {}, std::move(message), "a curve of points");
  fault.help.push_back(std::move(remedy));
  return fault;
}

MaybeFault check_sizes(const CurveArrays& arrays) {
  const std::size_t count = arrays.ways.size();
  const auto text = [](Elements elements) { return std::to_string(elements.size()); };
  const bool fits =
      arrays.feeds.size() == count && (arrays.speeds.empty() || arrays.speeds.size() == count);
  if (!fits) {
    return no_curve("the arrays of the curve differ in length: " + text(arrays.ways) +
                        " distances, " + text(arrays.feeds) + " feeds" +
                        (arrays.speeds.empty() ? "" : ", " + text(arrays.speeds) + " speeds"),
                    "give each distance its feed, and its speed if there are speeds");
  }
  if (count < 2 || count > limits::feed_law_points) {
    return no_curve("the curve has " + text(arrays.ways) + " points",
                    "give 2 to " + std::to_string(limits::feed_law_points) + " points");
  }
  return std::nullopt;
}

MaybeFault check_ways(Elements ways) {
  const auto text = [&](std::size_t i) {
    return "distance[" + std::to_string(i) + "] = " + law_number_text(ways[i]);
  };
  if (ways[0] != 0.0) {
    return no_curve("the curve begins with " + text(0) + ", not with 0",
                    "begin with distance 0, where the law begins");
  }
  for (std::size_t i = 1; i < ways.size(); ++i) {
    if (ways[i] > ways[i - 1]) continue;
    return no_curve(text(i) + " is not greater than " + text(i - 1),
                    "give the distances in ascending order");
  }
  return std::nullopt;
}

MaybeFault check_positive(Elements values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > 0.0) continue;
    BlockFault fault =
        fault_at("E4335", {},
                 what + "[" + std::to_string(i) + "] = " + law_number_text(values[i]) +
                     " of the curve must be above 0",
                 "not above 0");
    fault.help.emplace_back("give a value above 0");
    return fault;
  }
  return std::nullopt;
}

MaybeFault check_arrays(const CurveArrays& arrays) {
  if (auto fault = check_sizes(arrays)) return fault;
  if (auto fault = check_ways(arrays.ways)) return fault;
  if (auto fault = check_positive(arrays.feeds, "feed")) return fault;
  return check_positive(arrays.speeds, "speed");
}

}  // namespace

Expected<FeedLaw, BlockFault> read_feed_curve(const LawSurroundings& around,
                                              const CurveArrays& arrays) {
  if (auto fault = check_arrays(arrays)) return Unexpected<BlockFault>(std::move(*fault));
  const double unit = around.length_unit;
  FeedLaw law;
  law.kind = FeedLaw::Kind::curve;
  law.feed_mode = around.feed_mode;
  if (!arrays.speeds.empty()) law.speed = FeedLaw::Speed::rev_per_min;
  for (std::size_t i = 0; i < arrays.ways.size(); ++i) {
    law.curve.push_back({arrays.ways[i] * unit, arrays.feeds[i] * unit,
                         arrays.speeds.empty() ? 0.0 : arrays.speeds[i]});
  }
  law.feed_first = law.curve.front().feed;
  law.speed_first = law.curve.front().speed;
  return law;
}

bool is_plausible_curve_law(const FeedLaw& law) {
  return law.feed_first > 0.0 && law.curve.size() >= 2;
}

std::vector<LawValue> values_of_curve_law(const FeedLaw&) {
  return {};
}

}  // namespace stanok::lang
