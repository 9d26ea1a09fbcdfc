// The list of feed laws. A new one is a pair of files beside this one and a row of law_types.cc.
#pragma once

#include <span>

#include "lang/feed_law/law_type.h"

namespace stanok::lang {

[[nodiscard]] std::span<const LawType> law_types();
// The forms of all laws; those of a law follow each other.
[[nodiscard]] std::span<const LawForm> law_forms();
// The law that the form is one of.
[[nodiscard]] const LawType& law_type_of(const LawForm& form);
// The first law of the kind; nullptr: there is none (off).
[[nodiscard]] const LawType* find_law_type(FeedLaw::Kind kind);

}  // namespace stanok::lang
