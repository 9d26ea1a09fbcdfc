// The laws of spindle speed and of cutting speed: a linear feed, and at its steps a step of the
// speed, n_n n_k dn in rev/min or v_n v_k dv in m/min. The last speed is given, or the step.
//
// Source: docs/programmer/feed-laws.md. Constants without state; any thread.
#pragma once

#include "lang/feed_law/linear_law.h"

namespace stanok::lang {

void read_spindle_speed_law(LawReader& reader);
void read_cutting_speed_law(LawReader& reader);

inline constexpr std::array spindle_speed_forms{
    law_form("spindle speed", "speed", 0, LawAddress::speed_first, LawAddress::speed_step,
             LawAddress::feed_first, LawAddress::feed_step, LawAddress::path_step),
    law_form("spindle speed", "", address_bit(LawAddress::path_step), LawAddress::speed_first,
             LawAddress::speed_last, LawAddress::feed_first, LawAddress::feed_last,
             LawAddress::feed_step),
};
inline constexpr std::array cutting_speed_forms{
    law_form("cutting speed", "cutting_speed", 0, LawAddress::cutting_first,
             LawAddress::cutting_step, LawAddress::feed_first, LawAddress::feed_step,
             LawAddress::path_step),
    law_form("cutting speed", "", address_bit(LawAddress::path_step), LawAddress::cutting_first,
             LawAddress::cutting_last, LawAddress::feed_first, LawAddress::feed_last,
             LawAddress::feed_step),
};

inline constexpr LawType spindle_speed_law{.name = "spindle speed",
                                           .kind = FeedLaw::Kind::linear,
                                           .speed = FeedLaw::Speed::rev_per_min,
                                           .forms = spindle_speed_forms,
                                           .read = read_spindle_speed_law,
                                           .is_plausible = is_plausible_linear_law,
                                           .values = values_of_linear_law,
                                           .takes_feed = {}};
inline constexpr LawType cutting_speed_law{.name = "cutting speed",
                                           .kind = FeedLaw::Kind::linear,
                                           .speed = FeedLaw::Speed::m_per_min,
                                           .forms = cutting_speed_forms,
                                           .read = read_cutting_speed_law,
                                           .is_plausible = is_plausible_linear_law,
                                           .values = values_of_linear_law,
                                           .takes_feed = {}};

}  // namespace stanok::lang
