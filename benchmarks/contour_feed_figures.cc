// The figures of docs/developer/motion.md on codes and the position controller: numbers as CSV into
// a folder, and the tables of the document on the standard output.
//
//   contour_feed_figures FOLDER
//   gnuplot -e "data='FOLDER'; pictures='docs/developer/pictures'"
//   benchmarks/contour_feed_figures.gnuplot
//
// increments.csv and velocity_codes.csv are figures 3 and 6 of V. Kombarov, V. Sorokin, stability
// of contour feed (2013); following.csv and demand.csv compare eq. (2) with eq. (16) on the
// simulated drive. Everything is computed with the code of the runtime; nothing depends on time.
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/support/contour_following.h"

namespace stanok {
namespace {

using testing::CircleTask;
using testing::FollowedCycle;
using testing::RateSource;

constexpr double cycle_s = testing::circle_cycle_s;
constexpr double kp = 40.0;  // 1/s: 2.4 m/min per mm

class CsvFile {
 public:
  CsvFile(const std::filesystem::path& path, std::string_view header)
      : file_(std::fopen(path.c_str(), "w")) {
    if (file_ == nullptr) throw std::runtime_error("cannot write " + path.string());
    fmt::print(file_, "{}\n", header);
  }
  ~CsvFile() { std::fclose(file_); }
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  template <class... Values>
  void row(fmt::format_string<Values...> format, Values&&... values) {
    fmt::print(file_, format, std::forward<Values>(values)...);
    fmt::print(file_, "\n");
  }

 private:
  std::FILE* file_;
};

struct Extremes {
  double low = 0.0;
  double high = 0.0;
};

// Relative error of the velocity that follows from integer positions at constant feed.
Extremes increment_error(double feed_mm_per_min, const motion::CodeScale& scale) {
  const double step = feed_mm_per_min / 60.0 * cycle_s;
  Extremes error;
  for (int n = 1; n <= 20000; ++n) {
    const auto increment = static_cast<double>(motion::position_code(step * n, scale) -
                                               motion::position_code(step * (n - 1), scale));
    const double relative = increment * scale.resolution / step - 1.0;
    error.low = std::min(error.low, relative);
    error.high = std::max(error.high, relative);
  }
  return error;
}

// Largest relative error of the contour speed that follows from the velocity codes of a circle.
double velocity_code_error(double feed_mm_per_min, const motion::CodeScale& scale) {
  constexpr double radius = 20.0;
  const double turn = feed_mm_per_min / 60.0 * cycle_s / radius;
  const double chord = 2.0 * radius * std::sin(0.5 * turn);
  const auto code = [&](double before, double now) {
    return static_cast<double>(motion::velocity_code(before, now, scale)) / scale.kmv;
  };
  double worst = 0.0;
  const double whole = 2.0 * std::numbers::pi;
  for (int n = 0; n < 20000; ++n) {
    const double angle = whole * n / 20000.0;  // all over the circle, whatever the feed
    const double vx = code(radius * std::cos(angle - turn), radius * std::cos(angle));
    const double vy = code(radius * std::sin(angle - turn), radius * std::sin(angle));
    worst = std::max(worst, std::abs(std::hypot(vx, vy) * scale.resolution / chord - 1.0));
  }
  return worst;
}

void write_increments(const std::filesystem::path& folder) {
  CsvFile csv(folder / "increments.csv", "feed_mm_per_min,low_percent,high_percent");
  const auto write = [&](double feed) {
    const Extremes error = increment_error(feed, {});
    csv.row("{},{:.6g},{:.6g}", feed, 100.0 * error.low, 100.0 * error.high);
  };
  for (int feed = 1; feed < 200; ++feed) write(feed);
  for (int feed = 200; feed <= 60000; feed += 50) write(feed);

  fmt::print("| F, mm/min | increments per cycle | lowest | highest |\n|---|---|---|---|\n");
  for (const double feed : {10.0, 50.0, 100.0, 1000.0, 5000.0, 20000.0, 60000.0}) {
    const Extremes error = increment_error(feed, {});
    fmt::print("| {} | {:.4g} | {:+.3g} % | {:+.3g} % |\n", feed, feed / 60.0, 100.0 * error.low,
               100.0 * error.high);
  }
}

constexpr std::array code_feeds{1.0, 60.0, 1000.0, 6000.0, 60000.0};  // mm/min

// Eq. (15) for both axes and rounding to nearest.
double corrected_bound(double feed_mm_per_min, const motion::CodeScale& scale) {
  const double step = feed_mm_per_min / 60.0 * cycle_s / scale.resolution;
  return std::numbers::sqrt2 / 2.0 / (scale.kmv * step);
}

void write_velocity_codes(const std::filesystem::path& folder) {
  CsvFile csv(folder / "velocity_codes.csv", "kmv,feed_mm_per_min,percent,bound_percent");
  fmt::print("\n| Kmv |");
  for (const double feed : code_feeds) fmt::print(" F{} |", feed);
  fmt::print("\n|---|---|---|---|---|---|\n");
  for (int power = 0; power <= 6; ++power) {
    const motion::CodeScale scale{.kmv = std::pow(10.0, power)};
    fmt::print("| 10^{} |", power);
    for (const double feed : code_feeds) {
      const double percent = 100.0 * velocity_code_error(feed, scale);
      const double bound = 100.0 * corrected_bound(feed, scale);
      csv.row("{:g},{},{:.6g},{:.6g}", scale.kmv, feed, percent, bound);
      fmt::print(" {:.2g} ({:.2g}) |", percent, bound);
    }
    fmt::print("\n");
  }
}

struct Law {
  const char* name;
  motion::ControllerGains gains;
};

// The terms of eq. (16), one after the other.
std::array<Law, 4> laws(const CircleTask& task) {
  const motion::ControllerGains all = testing::inverting_gains(kp, task.loop);
  std::array<Law, 4> laws{{{"kp", all}, {"kp, kv", all}, {"kp, kv, ka", all}, {"all", all}}};
  for (std::size_t n = 0; n < 3; ++n) laws[n].gains.kr = 0.0;
  for (std::size_t n = 0; n < 2; ++n) laws[n].gains.ka = 0.0;
  laws[0].gains.kv = 0.0;
  return laws;
}

void write_following(const std::filesystem::path& folder) {
  CsvFile csv(folder / "following.csv",
              "feed_mm_per_min,law,error_um,error_differences_um,roughness_mm_per_s,"
              "roughness_differences_mm_per_s");
  fmt::print(
      "\n| F, mm/min | terms | error rms | with differences | roughness of U | with differences | "
      "ratio |\n|---|---|---|---|---|---|---|\n");
  for (const double feed : {1000.0, 2000.0, 3000.0, 6000.0, 9000.0, 12000.0, 18000.0}) {
    const CircleTask task{.feed_per_s = feed / 60.0};
    int number = 0;
    for (const Law& law : laws(task)) {
      const auto cycles = follow_circle(task, law.gains, RateSource::interpolator);
      const auto differenced = follow_circle(task, law.gains, RateSource::differences);
      const double error = 1e3 * following_error_rms(cycles);
      const double error_differenced = 1e3 * following_error_rms(differenced);
      const double rough = roughness(cycles);
      const double rough_differenced = roughness(differenced);
      csv.row("{},{},{:.6g},{:.6g},{:.6g},{:.6g}", feed, number++, error, error_differenced, rough,
              rough_differenced);
      if (feed != 6000.0 && feed != 12000.0) continue;
      fmt::print("| {} | {} | {:.3g} um | {:.3g} um | {:.3g} mm/s | {:.3g} mm/s | {:.0f} |\n", feed,
                 law.name, error, error_differenced, rough, rough_differenced,
                 rough_differenced / rough);
    }
  }
}

// U of the X axis over a tenth of a second, with all terms: eq. (16), and eq. (2) with the
// differences (3) and (4).
void write_demand(const std::filesystem::path& folder) {
  CsvFile csv(folder / "demand.csv", "t_s,analytic_mm_per_s,differences_mm_per_s");
  const CircleTask task{.feed_per_s = 100.0};
  const motion::ControllerGains gains = testing::inverting_gains(kp, task.loop);
  const auto analytic = follow_circle(task, gains, RateSource::interpolator);
  const auto differences = follow_circle(task, gains, RateSource::differences);
  for (std::size_t n = 0; n < 100; ++n) {
    csv.row("{:.3f},{:.6g},{:.6g}", static_cast<double>(n) * cycle_s, analytic[n].demand[0],
            differences[n].demand[0]);
  }
}

}  // namespace
}  // namespace stanok

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    fmt::print(stderr, "usage: contour_feed_figures FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder(arguments[1]);
    std::filesystem::create_directories(folder);
    stanok::write_increments(folder);
    stanok::write_velocity_codes(folder);
    stanok::write_following(folder);
    stanok::write_demand(folder);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
