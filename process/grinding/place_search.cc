#include "process/grinding/place_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stanok::process {
namespace {

constexpr std::array<double, 3> step_parts{0.16, 0.06, 0.02};  // of a place
constexpr std::size_t evaluations_per_place = 10;

bool is_falling(const std::vector<double>& places_mm, double begin_mm) {
  double before = begin_mm;
  for (const double place : places_mm) {
    if (!(place < before)) return false;
    before = place;
  }
  return true;
}

}  // namespace

std::vector<double> search_places(std::vector<double> places_mm, double begin_mm, int decimals,
                                  const std::function<double(const std::vector<double>&)>& time_s) {
  const double quanta = std::pow(10.0, decimals);
  double least = time_s(places_mm);
  std::size_t left = evaluations_per_place * places_mm.size();
  const auto improves = [&](std::size_t place, double part) {
    std::vector<double> tried = places_mm;
    const double step = std::max(std::abs(tried[place] * part), 1.0 / quanta);
    tried[place] = std::round((tried[place] + std::copysign(step, part)) * quanta) / quanta;
    if (left == 0 || !is_falling(tried, begin_mm)) return false;
    --left;
    const double time = time_s(tried);
    if (!(time < least)) return false;
    least = time;
    places_mm = std::move(tried);
    return true;
  };
  // One place as far as it becomes better.
  const auto moves = [&](std::size_t place, double part) {
    const double sign = improves(place, part) ? 1.0 : improves(place, -part) ? -1.0 : 0.0;
    if (sign == 0.0) return false;
    while (improves(place, sign * part)) {
    }
    return true;
  };
  // From the last one on: it decides the most.
  const auto sweeps = [&](double part) {
    bool has_moved = false;
    for (std::size_t place = places_mm.size(); place-- > 0;) has_moved |= moves(place, part);
    return has_moved;
  };
  for (const double part : step_parts) {
    while (sweeps(part)) {
    }
  }
  return places_mm;
}

}  // namespace stanok::process
