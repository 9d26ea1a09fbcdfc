#include "client/offline/interpret/feed_law_text.h"

#include "client/offline/interpret/record_parts.h"
#include "lang/feed_law/law_types.h"

namespace stanok::client {
namespace {

using lang::FeedLaw;

void append_value(std::string& text, const lang::LawValue& value) {
  if (const auto* const word = std::get_if<std::string_view>(&value.value)) {
    append(text, R"(,"{}":"{}")", value.name, *word);
  } else {
    append(text, R"(,"{}":{})", value.name, std::get<double>(value.value));
  }
}

void append_curve(std::string& text, const FeedLaw& law) {
  text += R"(,"points":[)";
  const char* comma = "";
  for (const FeedLaw::CurvePoint& point : law.curve) {
    append(text, R"({}{{"path":{},"feed":{})", comma, point.path_mm, point.feed);
    if (law.speed != FeedLaw::Speed::unchanged) append(text, R"(,"speed":{})", point.speed);
    text += '}';
    comma = ",";
  }
  text += ']';
}

}  // namespace

void append_feed_law(std::string& text, const FeedLaw& law) {
  const lang::LawType* const type = lang::find_law_type(law.kind);
  append(text, R"({{"law":"{}")", type == nullptr ? "off" : type->name);
  const bool per_revolution = law.feed_mode == lang::FeedMode::per_revolution;
  if (law.gives_feed()) {
    append(text, R"(,"feed_unit":"{}")", per_revolution ? "mm/rev" : "mm/min");
  }
  if (type != nullptr) {
    for (const lang::LawValue& value : type->values(law)) append_value(text, value);
  }
  if (!law.curve.empty()) append_curve(text, law);
  text += '}';
}

}  // namespace stanok::client
