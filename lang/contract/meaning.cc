#include "lang/contract/meaning.h"

#include <cmath>
#include <numbers>

namespace stanok::lang {
namespace {

// First and second axis of the active plane, as places among X, Y, Z (ISO 841).
std::array<std::size_t, 2> plane_places(const ActiveCodes& codes) {
  if (codes[Group::plane] == g(18)) return {2, 0};
  if (codes[Group::plane] == g(19)) return {1, 2};
  return {0, 1};
}

// On the cylinder the path has a length where the word is an angle.
double path_unit(const MeaningTerms& terms, std::size_t axis) {
  const TransformationChange& change = terms.transformation;
  const bool is_developed =
      change.kind == Transformation::cylinder && change.rotary_axis == static_cast<int>(axis);
  return is_developed ? change.radius_mm * std::numbers::pi / 180.0 : 1.0;
}

void put_polar(const Meaning& meaning, AxisValues& words) {
  if (meaning.codes[Group::polar] != g(16)) return;
  const auto places = plane_places(meaning.codes);
  const AxisIndex first = meaning.terms->geometry.at(places[0]);
  const AxisIndex second = meaning.terms->geometry.at(places[1]);
  if (!first.exists() || !second.exists()) return;
  const double radius = std::hypot(words[first], words[second]);
  words[second] = std::atan2(words[second], words[first]) * 180.0 / std::numbers::pi;
  words[first] = radius;
}

}  // namespace

bool Meaning::is_diameter(std::size_t axis) const {
  return codes[Group::diameter] == g(7) && terms->geometry[0].exists() &&
         terms->geometry[0].place() == axis;
}

AxisValues words_at(const Meaning& meaning, const AxisValues& point_W) {
  const MeaningTerms& terms = *meaning.terms;
  AxisValues words = point_W;
  for (std::size_t k = 0; k < words.size(); ++k) {
    words[k] /= path_unit(terms, k);
    words[k] = (words[k] - terms.shift[k]) / terms.gain[k];
  }
  put_polar(meaning, words);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (meaning.is_diameter(k)) words[k] *= 2.0;
  }
  return words;
}

AxisValues words_of_way(const Meaning& meaning, const AxisValues& way_W) {
  const MeaningTerms& terms = *meaning.terms;
  AxisValues words = way_W;
  for (std::size_t k = 0; k < words.size(); ++k) {
    words[k] /= path_unit(terms, k) * terms.gain[k];
    if (meaning.is_diameter(k)) words[k] *= 2.0;
  }
  return words;
}

void MeaningChanges::note(std::uint64_t block, const ActiveCodes& codes) {
  if (codes == newest_.codes) return;
  newest_.codes = codes;
  enter(block);
}

void MeaningChanges::note(std::uint64_t block, const ActiveCodes& codes, MeaningTerms terms) {
  newest_.codes = codes;
  newest_.terms = std::make_shared<const MeaningTerms>(std::move(terms));
  enter(block);
}

void MeaningChanges::enter(std::uint64_t block) {
  if (!changes_.empty() && changes_.back().block == block) {
    changes_.back().meaning = newest_;
    return;
  }
  if (changes_.size() == kept_max)
    changes_.erase(changes_.begin(), changes_.begin() + kept_max / 2);
  changes_.push_back({block, newest_});
}

}  // namespace stanok::lang
