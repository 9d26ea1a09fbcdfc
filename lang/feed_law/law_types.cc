#include "lang/feed_law/law_types.h"

#include <algorithm>
#include <vector>

#include "base/assert.h"
#include "lang/feed_law/feed_law_curve.h"
#include "lang/feed_law/interrupted_law.h"
#include "lang/feed_law/linear_law.h"
#include "lang/feed_law/modulated_law.h"
#include "lang/feed_law/speed_law.h"

namespace stanok::lang {

std::span<const LawType> law_types() {
  static constexpr auto types = std::to_array<LawType>({
      linear_law,
      modulated_law,
      interrupted_law,
      spindle_speed_law,
      cutting_speed_law,
      curve_law,
  });
  return types;
}

std::span<const LawForm> law_forms() {
  static const std::vector<LawForm> all = [] {
    std::vector<LawForm> forms;
    for (const LawType& type : law_types())
      forms.insert(forms.end(), type.forms.begin(), type.forms.end());
    return forms;
  }();
  return all;
}

const LawType& law_type_of(const LawForm& form) {
  const auto types = law_types();
  const auto found = std::ranges::find(types, form.law, &LawType::name);
  STANOK_ASSERT(found != types.end());
  return *found;
}

const LawType* find_law_type(FeedLaw::Kind kind) {
  const auto types = law_types();
  const auto found = std::ranges::find(types, kind, &LawType::kind);
  return found == types.end() ? nullptr : &*found;
}

}  // namespace stanok::lang
