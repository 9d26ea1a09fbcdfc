#include "jobs/cutting/stock_table.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "config/files/machine_file.h"

namespace stanok::jobs {
namespace {

constexpr std::size_t stock_steps_max = 10'000;

// Two or three numbers with a mark between; nothing: they are not.
std::optional<StockStep> stock_step(std::string_view text, char mark) {
  StockStep step;
  double* const places[] = {&step.z_mm, &step.radius_mm, &step.hardness_hb};
  std::size_t count = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double* const place : places) {
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, *place);
    if (error != std::errc{} || !std::isfinite(*place)) return std::nullopt;
    ++count;
    at = next;
    while (at != end && (*at == ' ' || *at == '\r')) ++at;
    if (at == end) break;
    if (*at != mark) return std::nullopt;
    ++at;
  }
  const bool is_whole = at == end && count >= 2 && text.back() != mark;
  if (!is_whole || !(step.radius_mm > 0.0) || step.hardness_hb < 0.0) return std::nullopt;
  return step;
}

// Whether it follows the steps before: z falls, and all of them have a hardness or none.
bool follows(const StockStep& step, const std::vector<StockStep>& steps) {
  if (steps.empty()) return true;
  const bool has_hardness = step.hardness_hb > 0.0;
  return steps.size() < stock_steps_max && step.z_mm < steps.back().z_mm &&
         has_hardness == (steps.back().hardness_hb > 0.0);
}

const StockStep* step_at(const std::vector<StockStep>& steps, double z_mm) {
  const StockStep* found = nullptr;
  for (const StockStep& step : steps)
    if (z_mm <= step.z_mm) found = &step;
  return found;
}

StockTable stock_of_machine(const std::filesystem::path& file) {
  const config::CuttingConfig cutting = config::read_machine_file(file).simulation.cutting;
  if (cutting.stock.empty())
    throw std::runtime_error(file.string() + " has no [[simulation.cutting.stock]]");
  StockTable table{.steps = {},
                   .hardness_hb = cutting.hardness_hb,
                   .hardness_exponent = cutting.hardness_exponent};
  for (const config::StockSection& section : cutting.stock)
    table.steps.push_back(
        {.z_mm = section.z_mm, .radius_mm = section.radius_mm, .hardness_hb = section.hardness_hb});
  return table;
}

}  // namespace

double StockTable::radius_mm(double z_mm) const {
  const StockStep* const step = step_at(steps, z_mm);
  return step != nullptr ? step->radius_mm : 0.0;
}

double StockTable::force_factor(double z_mm) const {
  const StockStep* const step = step_at(steps, z_mm);
  if (step == nullptr || !(step->hardness_hb > 0.0)) return 1.0;
  const double known_hb = hardness_hb > 0.0 ? hardness_hb : steps.front().hardness_hb;
  return known_hb > 0.0 ? std::pow(step->hardness_hb / known_hb, hardness_exponent) : 1.0;
}

std::optional<StockTable> stock_of_text(std::string_view text) {
  StockTable table;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const auto step = stock_step(text.substr(0, comma), ':');
    if (!step || !follows(*step, table.steps)) return std::nullopt;
    table.steps.push_back(*step);
    if (comma == std::string_view::npos) return table;
    text.remove_prefix(comma + 1);
  }
  return std::nullopt;
}

StockTable read_stock_table(const std::filesystem::path& file) {
  if (file.extension() == ".toml") return stock_of_machine(file);
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string() + "; check the path");
  StockTable table;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto step = stock_step(line, ',');
    if (!step && number == 1) continue;  // names of the columns
    if (!step || !follows(*step, table.steps)) {
      throw std::runtime_error(
          file.string() + ":" + std::to_string(number) +
          ": give z, radius and hardness in mm and HB with commas between and falling z; all lines "
          "have a hardness or none");
    }
    table.steps.push_back(*step);
  }
  if (table.steps.empty()) throw std::runtime_error(file.string() + " names no stock");
  return table;
}

}  // namespace stanok::jobs
