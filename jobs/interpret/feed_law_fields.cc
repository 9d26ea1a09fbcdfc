#include "jobs/interpret/feed_law_fields.h"

#include "base/overloaded.h"
#include "lang/feed_law/law_types.h"

namespace stanok::jobs {
namespace {

using lang::FeedLaw;

FieldValue value_of_law(const lang::LawValue& value) {
  return std::visit(Overloaded{[](std::string_view word) { return text_field(word); },
                               [](double number) { return FieldValue(number); }},
                    value.value);
}

FieldList curve_points(const FeedLaw& law) {
  return field_list(law.curve, [&](const FeedLaw::CurvePoint& point) {
    Fields fields{{"path", point.path_mm}, {"feed", point.feed}};
    if (law.speed != FeedLaw::Speed::unchanged) fields.push_back({"speed", point.speed});
    return fields;
  });
}

}  // namespace

Fields feed_law_fields(const FeedLaw& law) {
  const lang::LawType* const type = lang::find_law_type(law.kind);
  Fields fields{{"law", text_field(type == nullptr ? "off" : type->name)}};
  const bool per_revolution = law.feed_mode == lang::FeedMode::per_revolution;
  if (law.gives_feed()) fields.push_back({"feed_unit", per_revolution ? "mm/rev" : "mm/min"});
  if (type != nullptr) {
    for (const lang::LawValue& value : type->values(law))
      fields.push_back({std::string(value.name), value_of_law(value)});
  }
  if (!law.curve.empty()) fields.push_back({"points", curve_points(law)});
  return fields;
}

}  // namespace stanok::jobs
