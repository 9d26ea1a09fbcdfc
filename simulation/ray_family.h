// All rays along one axis of a grid, with the material on each as intervals.
//
// A ray that carries one piece of material, as nearly all do, keeps it in place; further pieces
// lie in a list aside. Positions along the ray are mm in K.
#pragma once

#include <cstdint>
#include <vector>

namespace stanok::simulation {

struct Interval {
  float from = 0.0F;
  float to = 0.0F;

  [[nodiscard]] double length() const { return static_cast<double>(to) - from; }
};

class RayFamily {
 public:
  explicit RayFamily(std::size_t rays) : rays_(rays) {}

  // Puts material on an empty stretch behind all there is.
  void add(std::size_t ray, double from, double to);
  // Takes away what lies between the two; returns its length.
  double subtract(std::size_t ray, double from, double to);
  // The length of what lies between the two.
  [[nodiscard]] double overlap(std::size_t ray, double from, double to) const;

  // Whether there is any material between the two, judged by the ends of the ray only: fast, true
  // may be wrong.
  [[nodiscard]] bool may_meet(std::size_t ray, float from, float to) const {
    const Ray& it = rays_[ray];
    return it.first.from < to && it.last_to > from;
  }
  [[nodiscard]] bool contains(std::size_t ray, double position) const;

  // All pieces, ascending.
  template <class Visitor>
  void visit(std::size_t ray, Visitor&& visitor) const {
    const Ray& it = rays_[ray];
    if (it.last_to <= it.first.from) return;
    visitor(it.first);
    if (it.aside == 0) return;
    for (const Interval& piece : aside_[it.aside - 1]) visitor(piece);
  }

  [[nodiscard]] std::size_t size() const { return rays_.size(); }
  [[nodiscard]] double length() const;  // of all material

 private:
  struct Ray {
    Interval first;
    float last_to = 0.0F;     // end of the last piece; not above first.from: the ray is empty
    std::uint32_t aside = 0;  // 1 + index of the further pieces; 0: none
  };

  double subtract_from_many(Ray& ray, float from, float to);
  void keep(Ray& ray, const std::vector<Interval>& pieces);
  [[nodiscard]] std::uint32_t take_list();

  std::vector<Ray> rays_;
  std::vector<std::vector<Interval>> aside_;
  std::vector<std::uint32_t> free_;  // lists of `aside_` that no ray has
  std::vector<Interval> pieces_;     // for subtract_from_many
};

}  // namespace stanok::simulation
