#include "client/offline/interpret/feed_law_text.h"

#include "base/enum_names.h"
#include "client/offline/interpret/record_parts.h"

namespace stanok::client {
namespace {

using lang::FeedLaw;

constexpr auto feed_law_names = enum_names<FeedLaw::Kind>({
    {FeedLaw::Kind::off, "off"},
    {FeedLaw::Kind::linear, "linear"},
    {FeedLaw::Kind::modulated, "modulated"},
    {FeedLaw::Kind::interrupted, "interrupted"},
    {FeedLaw::Kind::curve, "curve"},
});

void append_speed(std::string& text, const FeedLaw& law) {
  const bool cutting = law.speed == FeedLaw::Speed::m_per_min;
  append(text, R"(,"speed_unit":"{}","speed_first":{})", cutting ? "m/min" : "1/min",
         law.speed_first);
  if (law.speed_last != 0.0) {
    append(text, R"(,"speed_last":{})", law.speed_last);
  } else {
    append(text, R"(,"speed_step":{})", law.speed_step);
  }
}

void append_linear(std::string& text, const FeedLaw& law) {
  append(text, R"(,"feed_first":{},"feed_step":{})", law.feed_first,
         law.falls ? 0.0 - law.feed_step : law.feed_step);
  if (law.feed_last != 0.0) append(text, R"(,"feed_last":{})", law.feed_last);
  if (law.way_step_mm != 0.0) append(text, R"(,"way_step":{})", law.way_step_mm);
  if (law.speed != FeedLaw::Speed::unchanged) append_speed(text, law);
}

void append_curve(std::string& text, const FeedLaw& law) {
  text += R"(,"points":[)";
  const char* comma = "";
  for (const FeedLaw::CurvePoint& point : law.curve) {
    append(text, R"({}{{"way":{},"feed":{})", comma, point.way_mm, point.feed);
    if (law.speed != FeedLaw::Speed::unchanged) append(text, R"(,"speed":{})", point.speed);
    text += '}';
    comma = ",";
  }
  text += ']';
}

}  // namespace

void append_feed_law(std::string& text, const FeedLaw& law) {
  append(text, R"({{"law":"{}")", feed_law_names[law.kind]);
  const bool per_revolution = law.feed_mode == lang::FeedMode::per_revolution;
  if (law.gives_feed()) {
    append(text, R"(,"feed_unit":"{}")", per_revolution ? "mm/rev" : "mm/min");
  }
  if (law.kind == FeedLaw::Kind::linear) append_linear(text, law);
  if (law.kind == FeedLaw::Kind::modulated) {
    append(text, R"(,"feed_min":{},"feed_max":{},"feed_step":{},"way_step":{},"steps":{})",
           law.feed_first, law.feed_last, law.feed_step, law.way_step_mm, law.steps);
  }
  if (law.kind == FeedLaw::Kind::interrupted) {
    append(text, R"(,"stand":{},"cut":{})", law.stand_mm, law.cut_mm);
  }
  if (law.kind == FeedLaw::Kind::curve) append_curve(text, law);
  text += '}';
}

}  // namespace stanok::client
