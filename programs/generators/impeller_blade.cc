#include "programs/generators/impeller_blade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/place.h"
#include "programs/generators/curve_split.h"

namespace stanok::programs {
namespace {

constexpr double safe_z = 60.0;
constexpr double clearance_z = 40.0;
constexpr double lean = 0.86;  // inclination of the tool as a part of that of the surface normal
constexpr std::array<double, 3> zone_min{-26.0, -43.0, 0.0};
constexpr std::array<double, 3> zone_max{26.0, 43.0, 34.0};

struct Plan {
  int blocks;
  double time_s;  // at the programmed feeds
  int rows;
  int bands;  // with a retract between them
  int decimals;
  Spacing spacing;
};

constexpr Plan full{173103, 2990.0, 400, 5, 5, {0.0008, 0.12, 0.30}};
constexpr Plan small{1500, 15.0, 6, 2, 5, {0.004, 0.2, 0.8}};

using Vector = std::array<double, 3>;

// The blade before it is scaled to the zone: u in [0, 1] along the span, v in [0, 1] from leading
// to trailing edge. A camber line that bends over the span, chords that taper and sweep, and a slow
// wave such as the flow channel has.
Vector raw_blade(double u, double v) {
  const double span = 2.0 * u - 1.0;
  const double chord = 2.0 * v - 1.0;
  const double half_chord = 23.0 - 3.5 * span - 2.0 * span * span;
  const double x = half_chord * chord + 3.0 * std::sin(0.5 * std::numbers::pi * span);
  const double y = 43.0 * span + 2.5 * chord * chord * span;
  const double z = -0.46 * x - 0.0035 * x * x + 0.0035 * y * y + 0.0012 * x * y +
                   0.5 * std::sin(std::numbers::pi * y / 28.0) * std::cos(0.06 * x);
  return {x, y, z};
}

// The blade in its zone, and its tool axis.
class Blade {
 public:
  Blade() {
    constexpr int grid = 400;
    min_.fill(std::numeric_limits<double>::infinity());
    max_.fill(-std::numeric_limits<double>::infinity());
    for (int i = 0; i <= grid; ++i) {
      for (int k = 0; k <= grid; ++k) {
        const Vector p = raw_blade(static_cast<double>(i) / grid, static_cast<double>(k) / grid);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          min_[axis] = std::min(min_[axis], p[axis]);
          max_[axis] = std::max(max_[axis], p[axis]);
        }
      }
    }
  }

  [[nodiscard]] Point pose(double u, double v) const {
    const Vector p = surface(u, v);
    const Vector n = normal(u, v);
    const double inclination = lean * std::atan2(std::hypot(n[0], n[1]), n[2]);
    constexpr double degree = 180.0 / std::numbers::pi;
    return {p[0], p[1], p[2], inclination * degree, std::atan2(-n[1], n[0]) * degree};
  }

 private:
  [[nodiscard]] Vector surface(double u, double v) const {
    Vector p = raw_blade(u, v);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] = zone_min[axis] + (p[axis] - min_[axis]) / (max_[axis] - min_[axis]) *
                                     (zone_max[axis] - zone_min[axis]);
    }
    return p;
  }

  // Upwards, not of unit length.
  [[nodiscard]] Vector normal(double u, double v) const {
    constexpr double h = 1e-4;
    const Vector u0 = surface(u - h, v), u1 = surface(u + h, v);
    const Vector v0 = surface(u, v - h), v1 = surface(u, v + h);
    const Vector a{v1[0] - v0[0], v1[1] - v0[1], v1[2] - v0[2]};
    const Vector b{u1[0] - u0[0], u1[1] - u0[1], u1[2] - u0[2]};
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Vector min_{};
  Vector max_{};
};

class BladeRaster {
 public:
  BladeRaster(const Plan& plan, const Layout& layout, const Budget& budget, const Point& start)
      : plan_(plan), budget_(budget), program_(layout, start) {}

  ProgramWriter lay_out() {
    share_blocks();
    head();
    for (int band = 0; band < plan_.bands; ++band) raster(band);
    tail();
    return std::move(program_);
  }

 private:
  [[nodiscard]] CurveSplit::Curve row_curve(int row) const {
    const double v = static_cast<double>(row) / (plan_.rows - 1);
    return [this, v](double u) { return blade_.pose(u, v); };
  }
  [[nodiscard]] static double row_start(int row) { return row % 2 == 0 ? 0.0 : 1.0; }

  void share_blocks() {
    std::vector<double> weights;
    for (int row = 0; row < plan_.rows; ++row) {
      splits_.emplace_back(row_curve(row), row_start(row), 1.0 - row_start(row), plan_.spacing);
      weights.push_back(splits_.back().chords_wanted());
    }
    counts_ = shares(weights, budget_.row_blocks);
  }

  void head() {
    const Point first = row_curve(0)(row_start(0));
    program_.comment("%");
    program_.comment("(IMPELLER_SURFACE, BLADE, FIVE-AXIS FINISHING)");
    program_.comment("(T2 BALL CUTTER D6, ZERO ON THE TABLE AXIS)");
    program_.block("G21 G90 G17 G40 G49 G80");
    program_.block("T2 M6");
    program_.block("S16000 M3");
    program_.block("G54");
    program_.rapid({stay, stay, stay, first[3], first[4]});
    program_.rapid({first[0], first[1], safe_z, first[3], first[4]}, "G43.4 H2");
    program_.block("G64 P0.01");
    program_.block("M8");
  }

  void tail() {
    program_.rapid({last_[0], last_[1], safe_z, last_[3], last_[4]});
    program_.block("G49");
    program_.block("M9");
    program_.block("M5");
    program_.block("M30");
    program_.comment("%");
  }

  void raster(int band) {
    const int first = plan_.rows * band / plan_.bands;
    const int last = plan_.rows * (band + 1) / plan_.bands - 1;
    program_.comment("(BAND " + std::to_string(band + 1) + ")");
    approach(row_curve(first)(row_start(first)));
    for (int row = first; row <= last; ++row) {
      const CurveSplit::Curve curve = row_curve(row);
      if (row > first) cut(curve(row_start(row)), budget_.feed_low);  // step over at the row's end
      const std::size_t index = checked_size(row);
      for (const double u : splits_[index].ends(counts_[index])) cut(curve(u), feed_at(u));
    }
    program_.rapid({last_[0], last_[1], clearance_z, last_[3], last_[4]});
  }

  void approach(const Point& to) {
    program_.rapid({to[0], to[1], clearance_z, to[3], to[4]});
    program_.rapid({to[0], to[1], to[2] + 2.0, to[3], to[4]});
    cut(to, 0.5 * budget_.feed_low);
  }

  void cut(const Point& pose, double feed) {
    program_.line(pose, feed);
    last_ = pose;
  }

  // Slower over the thin edges at hub and tip of the blade.
  [[nodiscard]] double feed_at(double u) const {
    const double to_edge = std::min(u, 1.0 - u);
    if (to_edge < 0.03) return budget_.feed_low;
    if (to_edge < 0.08) return 0.5 * (budget_.feed_low + budget_.feed_high);
    return budget_.feed_high;
  }

  const Plan& plan_;
  Budget budget_;
  ProgramWriter program_;
  Blade blade_;
  std::vector<CurveSplit> splits_;
  std::vector<int> counts_;
  Point last_{};
};

}  // namespace

Workload impeller_blade(const WorkloadOptions& options) {
  const Plan& plan = options.scale == Scale::full ? full : small;
  const Layout layout{.axis_count = 5,
                      .decimals = options.decimals.value_or(plan.decimals),
                      .feed_decimals = 1,
                      .every_motion_code = true,
                      .every_word = true};
  WorkloadOptions own = options;  // the feed options belong to the three-axis raster
  own.feed_low.reset();
  own.feed_high.reset();
  const auto lay_out = [&](const Budget& budget) {
    return BladeRaster(plan, layout, budget, options.start).lay_out();
  };
  return {"Impeller_surface.nc", layout, fitted(lay_out, plan.blocks, plan.time_s, 0.7, own)};
}

}  // namespace stanok::programs
