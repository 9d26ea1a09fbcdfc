#include "jobs/grinding/grind_study.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>

#include "base/place.h"
#include "process/grinding/number_text.h"

namespace stanok::jobs {
namespace {

using process::CycleDesign;
using process::DesignRequest;
using process::Findings;

constexpr const char* allowance_key = "allowance";
constexpr int count_max = 100'000;

// The number of the request that a key names; nullptr: none.
double* quantity_of(DesignRequest& request, const std::string& key) {
  if (key == allowance_key) return &request.allowance_mm;
  for (const process::ProcessQuantity& quantity : process::process_quantities()) {
    if (quantity.key == key) return &(request.process.*quantity.value);
  }
  return nullptr;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

std::optional<double> finite_number_in(std::string_view text) {
  const auto value = number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// FROM:TO:COUNT. Empty: another form.
std::vector<double> values_in_range(const std::vector<std::string_view>& parts) {
  if (parts.size() != 3) return {};
  const auto from = finite_number_in(parts[0]);
  const auto to = finite_number_in(parts[1]);
  const auto count = number_in<int>(parts[2]);
  if (!from || !to || !count || *count < 1 || *count > count_max) return {};
  if (*count == 1) return {*from};
  std::vector<double> values;
  values.reserve(place_of(*count));
  for (int k = 0; k < *count; ++k)
    values.push_back(std::lerp(*from, *to, static_cast<double>(k) / (*count - 1)));
  return values;
}

// A,B,C. Empty: another form.
std::vector<double> values_in_list(const std::vector<std::string_view>& parts) {
  std::vector<double> values;
  for (const std::string_view part : parts) {
    const auto value = finite_number_in(part);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

std::string first_error(const Findings& findings) {
  const auto error = std::ranges::find_if(findings, &process::Finding::is_error);
  return error == findings.end() ? "" : error->code + " " + error->text;
}

StudyPoint studied(DesignRequest request, const std::vector<Variation>& variations,
                   std::size_t index) {
  StudyPoint point{.values = std::vector<double>(variations.size())};
  for (std::size_t k = variations.size(); k-- > 0;) {
    const std::size_t count = variations[k].values.size();
    point.values[k] = variations[k].values[index % count];
    index /= count;
    *quantity_of(request, variations[k].key) = point.values[k];
  }
  request.staircase.effort = process::StaircaseEffort::quick;
  auto design = process::design_cycle(request);
  if (!design) {
    point.finding = first_error(design.error());
    return point;
  }
  point.finding = first_error(design->verification.findings);
  design->verification.run.samples = {};
  point.design = std::move(*design);
  return point;
}

std::string quoted(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) {
    cell += c;
    if (c == '"') cell += c;
  }
  return cell + "\"";
}

std::string cells(const CycleDesign& design) {
  const process::Verification& verification = design.verification;
  std::string text;
  const auto add = [&](double value) { text += "," + process::number_text(value); };
  add(verification.run.time_s);
  add(design.least_time_s);
  add(design.constant_safe_time_s);
  add(static_cast<double>(design.law.size()) / 2.0);
  add(verification.boundary.ratio);
  add(verification.run.residual_mm);
  for (const process::SizeError& error : verification.size_errors) add(error.error_mm);
  return text;
}

}  // namespace

std::optional<Variation> read_variation(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) return std::nullopt;
  Variation variation{.key = text.substr(0, sign), .values = {}};
  DesignRequest any;
  if (quantity_of(any, variation.key) == nullptr) return std::nullopt;
  const std::string_view values = std::string_view(text).substr(sign + 1);
  variation.values = values.find(':') != std::string_view::npos
                         ? values_in_range(parts_of(values, ':'))
                         : values_in_list(parts_of(values, ','));
  if (variation.values.empty()) return std::nullopt;
  return variation;
}

double study_size(const std::vector<Variation>& variations) {
  double size = 1.0;
  for (const Variation& variation : variations)
    size *= static_cast<double>(variation.values.size());
  return size;
}

std::vector<StudyPoint> run_study(const DesignRequest& request,
                                  const std::vector<Variation>& variations, const StudyPart& part,
                                  const std::function<void(std::size_t)>& show) {
  DesignRequest design = request;
  design.comparison = process::Comparison::none;
  const std::size_t combinations = checked_size(study_size(variations));
  const std::size_t begin = part.begin(combinations);
  std::vector<StudyPoint> points(part.end(combinations) - begin);
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  std::mutex fault_mutex;
  std::exception_ptr fault;  // of a thread, for who called
  const auto work = [&] {
    for (std::size_t index = next++; index < points.size(); index = next++) {
      try {
        points[index] = studied(design, variations, begin + index);
      } catch (...) {
        const std::scoped_lock lock(fault_mutex);
        fault = std::current_exception();
      }
      ++done;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k) {
      threads.emplace_back(work);
    }
    constexpr std::chrono::milliseconds between_shows(100);
    try {
      while (done < points.size()) {
        show(done);
        std::this_thread::sleep_for(between_shows);
      }
    } catch (...) {
      next = points.size();  // the threads end with the design that each is at
      throw;
    }
  }
  if (fault) std::rethrow_exception(fault);
  show(points.size());
  return points;
}

std::optional<StudyPart> read_study_part(const std::string& text) {
  constexpr std::size_t parts_max = study_points_max;
  StudyPart part;
  const char* const text_end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), text_end, part.number);
  if (number.ec != std::errc() || number.ptr == text_end || *number.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(number.ptr + 1, text_end, part.of);
  if (of.ec != std::errc() || of.ptr != text_end || part.of > parts_max) return std::nullopt;
  if (part.number < 1 || part.number > part.of) return std::nullopt;
  return part;
}

std::string study_csv(const std::vector<Variation>& variations, const StudyPart& part,
                      const std::vector<StudyPoint>& points) {
  std::string text;
  if (part.number == 1) {
    for (const Variation& variation : variations) text += variation.key + ",";
    text +=
        "cycle_time_s,lower_bound_s,constant_safe_s,feeds,q_over_d_max,residual_mm,"
        "size_error_soft_mm,size_error_stiff_mm,finding\n";
  }
  for (const StudyPoint& point : points) {
    std::string line;
    for (const double value : point.values) {
      line += (line.empty() ? "" : ",") + process::number_text(value);
    }
    line += point.design ? cells(*point.design) : ",,,,,,,,";
    text += line + "," + (point.finding.empty() ? "" : quoted(point.finding)) + "\n";
  }
  return text;
}

}  // namespace stanok::jobs
