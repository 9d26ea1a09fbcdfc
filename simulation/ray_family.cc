#include "simulation/ray_family.h"

#include <algorithm>

#include "base/assert.h"

namespace stanok::simulation {
namespace {

// Shorter pieces are rounding, not material.
constexpr float piece_min = 1e-4F;  // mm

double common(const Interval& piece, float from, float to) {
  return std::max(0.0, static_cast<double>(std::min(piece.to, to)) - std::max(piece.from, from));
}

}  // namespace

void RayFamily::add(std::size_t ray, double from, double to) {
  Ray& it = rays_[ray];
  const Interval piece{static_cast<float>(from), static_cast<float>(to)};
  if (it.last_to <= it.first.from) {
    it.first = piece;
  } else {
    STANOK_ASSERT(piece.from >= it.last_to);
    if (it.aside == 0) it.aside = take_list() + 1;
    aside_[it.aside - 1].push_back(piece);
  }
  it.last_to = piece.to;
}

double RayFamily::subtract(std::size_t ray, double from, double to) {
  Ray& it = rays_[ray];
  const auto a = static_cast<float>(from);
  const auto b = static_cast<float>(to);
  if (it.first.from >= b || it.last_to <= a) return 0.0;
  if (it.aside != 0) return subtract_from_many(it, a, b);
  const double taken = common(it.first, a, b);
  const bool stays_below = a - it.first.from >= piece_min;
  const bool stays_above = it.first.to - b >= piece_min;
  if (stays_below && stays_above) {
    it.aside = take_list() + 1;
    aside_[it.aside - 1].push_back({b, it.first.to});
    it.first.to = a;
  } else if (stays_below) {
    it.first.to = it.last_to = a;
  } else if (stays_above) {
    it.first.from = b;
  } else {
    it = Ray{};
  }
  return taken;
}

double RayFamily::subtract_from_many(Ray& ray, float from, float to) {
  const auto meets = [&](const Interval& piece) { return piece.from < to && piece.to > from; };
  if (!meets(ray.first) && std::ranges::none_of(aside_[ray.aside - 1], meets)) return 0.0;
  double taken = 0.0;
  pieces_.clear();
  const auto cut = [&](const Interval& piece) {
    taken += common(piece, from, to);
    if (std::min(piece.to, from) - piece.from >= piece_min)
      pieces_.push_back({piece.from, std::min(piece.to, from)});
    if (piece.to - std::max(piece.from, to) >= piece_min)
      pieces_.push_back({std::max(piece.from, to), piece.to});
  };
  cut(ray.first);
  for (const Interval& piece : aside_[ray.aside - 1]) cut(piece);
  keep(ray, pieces_);
  return taken;
}

void RayFamily::keep(Ray& ray, const std::vector<Interval>& pieces) {
  std::vector<Interval>& list = aside_[ray.aside - 1];
  list.clear();
  if (pieces.size() > 1) {
    list.assign(pieces.begin() + 1, pieces.end());
  } else {
    free_.push_back(ray.aside - 1);
    ray.aside = 0;
  }
  ray.first = pieces.empty() ? Interval{} : pieces.front();
  ray.last_to = pieces.empty() ? 0.0F : pieces.back().to;
}

double RayFamily::overlap(std::size_t ray, double from, double to) const {
  double sum = 0.0;
  visit(ray, [&](const Interval& piece) {
    sum += common(piece, static_cast<float>(from), static_cast<float>(to));
  });
  return sum;
}

bool RayFamily::contains(std::size_t ray, double position) const {
  const auto at = static_cast<float>(position);
  bool found = false;
  visit(ray, [&](const Interval& piece) { found = found || (piece.from <= at && at < piece.to); });
  return found;
}

double RayFamily::length() const {
  double sum = 0.0;
  for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
    visit(ray, [&](const Interval& piece) { sum += piece.length(); });
  }
  return sum;
}

std::uint32_t RayFamily::take_list() {
  if (!free_.empty()) {
    const std::uint32_t list = free_.back();
    free_.pop_back();
    return list;
  }
  aside_.emplace_back();
  return static_cast<std::uint32_t>(aside_.size() - 1);
}

}  // namespace stanok::simulation
