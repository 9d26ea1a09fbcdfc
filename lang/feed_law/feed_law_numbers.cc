#include "lang/feed_law/feed_law_numbers.h"

#include <algorithm>
#include <cmath>

#include "lang/feed_law/law_types.h"
#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

// Takes the numbers in the order in which numbers_of wrote them.
class Taker {
 public:
  explicit Taker(std::span<const double> numbers) : numbers_(numbers) {}

  double next() { return at_ < numbers_.size() ? numbers_[at_++] : failed(); }
  // A whole number from 0 to `last`.
  int whole(int last) {
    const double number = next();
    const bool good = number >= 0.0 && number <= last && number == std::round(number);
    return good ? static_cast<int>(number) : static_cast<int>(failed());
  }
  template <class Enum>
  void take(Enum& value, Enum last) {
    value = static_cast<Enum>(whole(static_cast<int>(last)));
  }
  [[nodiscard]] std::size_t left() const { return numbers_.size() - at_; }
  [[nodiscard]] bool good() const { return good_; }

 private:
  double failed() {
    good_ = false;
    return 0.0;
  }

  std::span<const double> numbers_;
  std::size_t at_ = 0;
  bool good_ = true;
};

bool is_plausible(const FeedLaw& law) {
  const LawType* const type = find_law_type(law.kind);
  const bool not_negative = std::min({law.feed_step, law.path_step_mm, law.feed_last, law.stand_mm,
                                      law.cut_mm, law.speed_first, law.speed_last}) >= 0.0;
  const bool has_speed =
      law.speed == FeedLaw::Speed::unchanged || law.speed_first > 0.0 || !law.curve.empty();
  return type != nullptr && not_negative && has_speed && type->is_plausible(law);
}

FeedLaw::Kind last_kind() {
  return std::ranges::max(law_types(), {}, &LawType::kind).kind;
}

}  // namespace

std::vector<double> numbers_of(const FeedLaw& law) {
  if (law.kind == FeedLaw::Kind::off) return {0.0};
  std::vector<double> numbers{static_cast<double>(law.kind),
                              static_cast<double>(law.feed_mode),
                              law.feed_first,
                              law.feed_step,
                              law.falls ? 1.0 : 0.0,
                              law.path_step_mm,
                              law.feed_last,
                              static_cast<double>(law.steps),
                              law.stand_mm,
                              law.cut_mm,
                              static_cast<double>(law.speed),
                              law.speed_first,
                              law.speed_step,
                              law.speed_last};
  for (const FeedLaw::CurvePoint& point : law.curve) {
    numbers.insert(numbers.end(), {point.path_mm, point.feed, point.speed});
  }
  return numbers;
}

std::optional<FeedLaw> law_of_numbers(std::span<const double> numbers) {
  Taker from(numbers);
  FeedLaw law;
  from.take(law.kind, last_kind());
  if (law.kind == FeedLaw::Kind::off) {
    return from.good() && from.left() == 0 ? std::optional(law) : std::nullopt;
  }
  from.take(law.feed_mode, FeedMode::per_revolution);
  law.feed_first = from.next();
  law.feed_step = from.next();
  law.falls = from.whole(1) != 0;
  law.path_step_mm = from.next();
  law.feed_last = from.next();
  law.steps = from.whole(limits::feed_law_steps);
  law.stand_mm = from.next();
  law.cut_mm = from.next();
  from.take(law.speed, FeedLaw::Speed::m_per_min);
  law.speed_first = from.next();
  law.speed_step = from.next();
  law.speed_last = from.next();
  if (from.left() % 3 != 0 || from.left() / 3 > limits::feed_law_points) return std::nullopt;
  while (from.left() > 0) {
    FeedLaw::CurvePoint point;
    point.path_mm = from.next();
    point.feed = from.next();
    point.speed = from.next();
    law.curve.push_back(point);
  }
  return from.good() && is_plausible(law) ? std::optional(law) : std::nullopt;
}

}  // namespace stanok::lang
