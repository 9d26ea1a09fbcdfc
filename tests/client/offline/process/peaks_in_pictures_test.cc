// The extreme of each column of a forecast is in its picture, its table and what the daemon
// answers: over seeded courses with one high place.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <sstream>

#include "client/offline/process/identify/power_picture.h"
#include "client/offline/process/milling_report.h"
#include "jobs/cutting/cut_columns.h"

namespace stanok::client {
namespace {

// The numbers between "$name << END" and "END".
std::vector<std::vector<double>> data_of(const std::string& script) {
  std::istringstream lines(script);
  std::string line;
  std::vector<std::vector<double>> rows;
  std::getline(lines, line);
  while (std::getline(lines, line) && line != "END") {
    std::istringstream words(line);
    std::vector<double>& row = rows.emplace_back();
    for (double value = 0.0; words >> value;) row.push_back(value);
  }
  return rows;
}

// The largest of a column of a table of text, by its name.
std::map<std::string, double> largest_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> names;
  std::istringstream heading(line);
  for (std::string name; std::getline(heading, name, ',');) names.push_back(name);
  std::map<std::string, double> largest;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::size_t k = 0;
    for (std::string word; std::getline(words, word, ','); ++k)
      largest[names[k]] = jobs::farther_from_zero(largest[names[k]], std::stod(word));
  }
  return largest;
}

double largest(const std::vector<std::vector<double>>& rows, std::size_t column) {
  double most = 0.0;
  for (const auto& row : rows) most = jobs::farther_from_zero(most, row.at(column));
  return most;
}

jobs::MillingForecast random_forecast(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> usual(0.0, 340.0);
  jobs::MillingForecast forecast;
  const std::size_t count = 9000 + random() % 20'000;
  for (std::size_t k = 0; k < count; ++k) {
    jobs::MillingPlace place;
    place.line = static_cast<std::uint32_t>(k / 100);
    place.path_mm = 0.1 * static_cast<double>(k);
    for (double jobs::MillingPlace::* const value :
         {&jobs::MillingPlace::force_peak_n, &jobs::MillingPlace::force_planned_n,
          &jobs::MillingPlace::power_w, &jobs::MillingPlace::deflection_um,
          &jobs::MillingPlace::feed_programmed, &jobs::MillingPlace::feed_planned})
      place.*value = usual(random);
    forecast.places.push_back(place);
  }
  // Each quantity has its peak at a place of its own.
  forecast.places[random() % count].force_peak_n = 3984.0;
  forecast.places[random() % count].force_planned_n = 2984.0;
  forecast.places[random() % count].power_w = 1984.0;
  forecast.places[random() % count].deflection_um = 984.0;
  return forecast;
}

TEST(PeaksInPictures, OfAMillingForecast) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const jobs::MillingForecast forecast = random_forecast(seed);
    const auto picture = data_of(picture_script(forecast, "p.svg"));
    const auto table = largest_of(jobs::csv(forecast.places, jobs::milling_columns()));
    const auto answer = jobs::thinned(forecast.places, 1200, jobs::milling_overview());
    EXPECT_LE(picture.size(), 6000U);
    EXPECT_LE(answer.size(), 1200U);
    // Path, X, Y, then these.
    EXPECT_EQ(largest(picture, 3), 3984.0);
    EXPECT_EQ(largest(picture, 4), 2984.0);
    EXPECT_EQ(largest(picture, 7), 1984.0);
    EXPECT_EQ(largest(picture, 8), 984.0);
    EXPECT_EQ(table.at("force_programmed_n"), 3984.0);
    EXPECT_EQ(table.at("force_n"), 2984.0);
    EXPECT_EQ(table.at("power_w"), 1984.0);
    EXPECT_EQ(table.at("deflection_um"), 984.0);
    EXPECT_EQ(largest(answer, 1), 3984.0);
    EXPECT_EQ(largest(answer, 2), 2984.0);
    EXPECT_EQ(largest(answer, 5), 1984.0);
    EXPECT_EQ(largest(answer, 7), 984.0);
  }
}

// A reading that no model follows is what the picture of the residual is for.
TEST(PeaksInPictures, OfAPower) {
  std::vector<jobs::PowerPoint> points(40'000);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {0.001 * static_cast<double>(k), 500.0, 501.0};
  points[12'345].recorded_w = -900.0;
  const auto picture = data_of(power_picture_script(points, "p.svg"));
  EXPECT_EQ(largest(picture, 1), -900.0);
  EXPECT_EQ(largest(picture, 3), -1401.0);
}

}  // namespace
}  // namespace stanok::client
