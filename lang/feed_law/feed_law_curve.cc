#include "lang/feed_law/feed_law_curve.h"

#include <string>
#include <utility>

#include "lang/actions/actions.h"
#include "lang/feed_law/feed_law_words.h"
#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

using Elements = std::span<const Value>;

void fail_curve(ActiveBlock& block, std::string message, std::string remedy) {
  block.fail("E4345", {}, std::move(message), "a curve of points")
      .help.push_back(std::move(remedy));
}

bool check_sizes(ActiveBlock& block, const CurveArrays& arrays) {
  const std::size_t count = arrays.ways.size();
  const auto text = [](Elements elements) { return std::to_string(elements.size()); };
  const bool fits =
      arrays.feeds.size() == count && (arrays.speeds.empty() || arrays.speeds.size() == count);
  if (!fits) {
    fail_curve(block,
               "the arrays of the curve differ in length: " + text(arrays.ways) + " ways, " +
                   text(arrays.feeds) + " feeds" +
                   (arrays.speeds.empty() ? "" : ", " + text(arrays.speeds) + " speeds"),
               "give each way its feed, and its speed if there are speeds");
  } else if (count < 2 || count > limits::feed_law_points) {
    fail_curve(block, "a curve of " + text(arrays.ways) + " points",
               "give 2 to " + std::to_string(limits::feed_law_points) + " points");
  }
  return !block.failed();
}

bool check_ways(ActiveBlock& block, Elements ways) {
  const auto text = [&](std::size_t i) {
    return "way[" + std::to_string(i) + "] = " + law_number_text(ways[i].number);
  };
  if (ways[0].number != 0.0) {
    fail_curve(block, "the curve begins with " + text(0) + ", not with 0",
               "begin with the way 0, where the law begins");
  }
  for (std::size_t i = 1; i < ways.size() && !block.failed(); ++i) {
    if (ways[i].number > ways[i - 1].number) continue;
    fail_curve(block, text(i) + " does not lie behind " + text(i - 1), "let the ways ascend");
  }
  return !block.failed();
}

bool check_positive(ActiveBlock& block, Elements values, const std::string& what) {
  for (std::size_t i = 0; i < values.size() && !block.failed(); ++i) {
    if (values[i].number > 0.0) continue;
    block
        .fail("E4335", {},
              what + "[" + std::to_string(i) + "] = " + law_number_text(values[i].number) +
                  " of the curve must be above 0",
              "not above 0")
        .help.emplace_back("give a value above 0");
  }
  return !block.failed();
}

}  // namespace

std::optional<FeedLaw> read_feed_curve(ActiveBlock& block, const CurveArrays& arrays) {
  const bool good = check_sizes(block, arrays) && check_ways(block, arrays.ways) &&
                    check_positive(block, arrays.feeds, "feed") &&
                    check_positive(block, arrays.speeds, "speed") && allows_feed_law(block, {}) &&
                    (arrays.speeds.empty() || spindle_takes_law(block, {}, "speeds of a curve"));
  if (!good) return std::nullopt;
  const double unit = block.length_unit();
  FeedLaw law;
  law.kind = FeedLaw::Kind::curve;
  law.feed_mode = block.modal.feed_mode();
  if (!arrays.speeds.empty()) law.speed = FeedLaw::Speed::rev_per_min;
  for (std::size_t i = 0; i < arrays.ways.size(); ++i) {
    law.curve.push_back({arrays.ways[i].number * unit, arrays.feeds[i].number * unit,
                         arrays.speeds.empty() ? 0.0 : arrays.speeds[i].number});
  }
  law.feed_first = law.curve.front().feed;
  law.speed_first = law.curve.front().speed;
  return law;
}

}  // namespace stanok::lang
