// Few points that look like many: time series that keep their peaks, curves that keep their shape.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stanok::recording {

struct TimePoint {
  double time = 0.0;  // s
  double value = 0.0;
};

// Keeps the first, the smallest, the largest and the last value of every bin of time: a line
// through them looks as the line through all. When the bins are used up, neighbours are merged and
// bins are twice as long. What is no finite number is left out.
class PeakSeries {
 public:
  void add(double time, double value);
  // At most four for each of `bins_max` bins, ordered by time.
  [[nodiscard]] std::vector<TimePoint> points() const;

  static constexpr std::size_t bins_max = 2000;

 private:
  struct Bin {
    TimePoint first, smallest, largest, last;
  };
  static void merge(const Bin& later, Bin& bin);

  std::vector<Bin> bins_;
  std::int64_t values_per_bin_ = 1;
  std::int64_t values_in_last_bin_ = 0;
};

using PlotPoint = std::array<double, 3>;

// Keeps points that are at least a distance apart; the distance grows so that their number stays
// bounded. Where something is no coordinate of a machine (a damaged log) no point is kept.
class ThinnedPath {
 public:
  // `begins_stretch`: no line leads to the point.
  enum class Joint { continues, begins_stretch };
  void add(const PlotPoint& point, Joint joint);
  [[nodiscard]] std::vector<std::vector<PlotPoint>> stretches() const;

  static constexpr std::size_t points_max = 20000;

 private:
  struct Kept {
    PlotPoint point{};
    Joint joint = Joint::continues;
  };
  [[nodiscard]] bool is_near(const PlotPoint& a, const PlotPoint& b) const;
  void thin();

  std::vector<Kept> kept_;
  bool last_is_provisional_ = false;  // near the one before it: the next point replaces it
  double distance_ = 0.001;           // mm
};

}  // namespace stanok::recording
