// One feed law as the language knows it: how it is written, how its words are read, what it must
// have, and what its values are called. lang/feed_law/law_types.h is the list of them.
//
// Constants without state; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "lang/contract/command.h"
#include "lang/words/law_address.h"

namespace stanok::lang {

class LawReader;

// Bit k stands for the k-th address.
using LawAddressSet = std::uint16_t;

[[nodiscard]] constexpr LawAddressSet address_bit(LawAddress address) {
  return static_cast<LawAddressSet>(1U << static_cast<unsigned>(address));
}

// One way to write a law: the addresses it must have and those it may have.
struct LawForm {
  std::string_view law;  // "linear": as messages call it
  // The word of #feedlaw, whose arguments are the addresses of `must` in their order; empty: the
  // form is none of #feedlaw.
  std::string_view directive;
  std::array<LawAddress, 5> addresses{};
  std::size_t must_count = 0;
  LawAddressSet may = 0;

  [[nodiscard]] constexpr std::span<const LawAddress> must() const {
    return {addresses.data(), must_count};
  }
};

template <class... Addresses>
[[nodiscard]] constexpr LawForm law_form(std::string_view law, std::string_view directive,
                                         LawAddressSet may, Addresses... must) {
  return {law, directive, {must...}, sizeof...(must), may};
}

// A value of a law as reports name it, in mm, mm/min or mm/rev.
struct LawValue {
  std::string_view name;
  std::variant<double, std::string_view> value;
};

// Several laws may be of one kind: then they are read differently, and executed alike.
struct LawType {
  std::string_view name;  // as in its forms
  FeedLaw::Kind kind = FeedLaw::Kind::off;
  FeedLaw::Speed speed = FeedLaw::Speed::unchanged;
  std::span<const LawForm> forms;
  // Fills the law from the words of a form; none: the law has no words.
  void (*read)(LawReader& reader) = nullptr;
  // What every modal law of the kind has, so that no saved text can bring one that a block could
  // not. Steps, lengths and speeds are not negative.
  bool (*is_plausible)(const FeedLaw& law) = nullptr;
  // Points of a curve are not among them.
  std::vector<LawValue> (*values)(const FeedLaw& law) = nullptr;
  std::string_view takes_feed;  // why F must be known: "it cuts and rests at the feed F"; empty: no
};

}  // namespace stanok::lang
