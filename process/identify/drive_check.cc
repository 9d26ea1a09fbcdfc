#include "process/identify/drive_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr std::size_t stretches_of_record = 32;
// Of the force. Less changes the figures by less than their use can notice, and the intervals are
// widened by it.
constexpr double change_refused = 0.04;
// Of the power of the cut; less is of no use to know.
constexpr double rest_told = 0.003;

// The readings of the cut, where they are and what the cut takes there.
class CutReadings {
 public:
  CutReadings(const DriveRecord& record, const DrivePowers& powers, const ColouredNoise& noise)
      : record_(record), noise_(noise), rows_(reading_rows(record)) {
    for (const std::size_t row : rows_) cut_w_.push_back(powers.cut_w[row]);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (record.cuts[rows_[k]]) in_cut_.push_back(k);
  }

  [[nodiscard]] std::vector<double> whitened(const std::vector<double>& by_row) const {
    std::vector<double> values;
    values.reserve(rows_.size());
    for (const std::size_t row : rows_) values.push_back(by_row[row]);
    return noise_.whitened(values);
  }

  // The cut, growing from 0 at the begin of the record to itself at its end.
  [[nodiscard]] std::vector<double> growing() const {
    std::vector<double> values = cut_w_;
    const double whole = std::max(1.0, static_cast<double>(in_cut_.size()));
    double done = 0.0;
    std::size_t next = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (next < in_cut_.size() && in_cut_[next] == k) {
        done += 1.0;
        ++next;
      }
      values[k] *= done / whole;
    }
    return noise_.whitened(values);
  }

  [[nodiscard]] Stretches by_time() const {
    std::vector<double> time_s;
    time_s.reserve(rows_.size());
    for (const std::size_t row : rows_)
      time_s.push_back(static_cast<double>(row) * record_.cycle_s);
    return stretches(time_s, Along::time);
  }
  // Along the cut: from greater z to smaller.
  [[nodiscard]] Stretches by_place() const {
    std::vector<double> way;
    if (record_.z_mm.size() != record_.power_w.size()) return {};
    way.reserve(rows_.size());
    for (const std::size_t row : rows_) way.push_back(-record_.z_mm[row]);
    Stretches along = stretches(way, Along::place);
    for (double& begin : along.begins) begin = -begin;
    along.end = -along.end;
    return along;
  }

 private:
  // With as many readings of the cut each.
  [[nodiscard]] Stretches stretches(const std::vector<double>& place, Along along) const {
    std::vector<double> sorted;
    sorted.reserve(in_cut_.size());
    for (const std::size_t k : in_cut_) sorted.push_back(place[k]);
    std::ranges::sort(sorted);
    constexpr std::size_t readings_least = 8;
    const std::size_t count = std::min(stretches_of_record, sorted.size() / readings_least);
    if (count < 2) return {};
    Stretches all{.columns = {}, .begins = {}, .end = sorted.back(), .along = along};
    for (std::size_t n = 0; n < count; ++n) all.begins.push_back(sorted[n * sorted.size() / count]);
    for (std::size_t n = 0; n < count; ++n) {
      std::vector<double> values(rows_.size(), 0.0);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const bool is_last = n + 1 == count;
        if (place[k] >= all.begins[n] && (is_last || place[k] < all.begins[n + 1]))
          values[k] = cut_w_[k];
      }
      all.columns.push_back(noise_.whitened(values));
    }
    return all;
  }

  const DriveRecord& record_;
  const ColouredNoise& noise_;
  std::vector<std::size_t> rows_;
  std::vector<std::size_t> in_cut_;  // of the readings
  std::vector<double> cut_w_;        // by reading
};

std::string percent_text(double amount) {
  return rounded_text(100.0 * std::abs(amount), 0) + " % " + (amount > 0.0 ? "greater" : "smaller");
}

std::string text_of(const ModelLack& lack) {
  switch (lack.kind) {
    case Misfit::steps:
      return lack.along == Along::place
                 ? "the force from Z " + rounded_text(lack.from, 1) + " to " +
                       rounded_text(lack.to, 1) + " is " + percent_text(lack.amount) +
                       " than elsewhere: steps of hardness or of depth that the stock does not have"
                 : "the force from " + rounded_text(lack.from, 1) + " s to " +
                       rounded_text(lack.to, 1) + " s is " + percent_text(lack.amount) +
                       " than before and after";
    case Misfit::drift:
      return "the force becomes " + percent_text(lack.amount) +
             " over the record: the tool wears or the drive warms up";
    case Misfit::force_law:
      return "the force does not follow the feed by its law: there is a force of the edge";
    default:
      return "the power comes behind more than one lag";
  }
}

double norm(const std::vector<double>& values) {
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

bool is_refused(const ModelLack& lack) {
  const bool is_of_force = lack.kind == Misfit::steps || lack.kind == Misfit::drift;
  return is_of_force && std::abs(lack.amount) > change_refused;
}

}  // namespace

DriveVerdict check_drive(const DriveRecord& record, const DrivePowers& powers,
                         const ColouredNoise& noise, const FitTraces& traces) {
  const CutReadings readings(record, powers, noise);
  std::vector<Suspect> suspects{{.kind = Misfit::drift, .column = readings.growing()}};
  if (!powers.lag_w.empty())
    suspects.push_back({.kind = Misfit::lag, .column = readings.whitened(powers.lag_w)});
  if (!powers.law_w.empty())
    suspects.push_back({.kind = Misfit::force_law, .column = readings.whitened(powers.law_w)});
  const ModelLack lack =
      strongest_lack(traces, suspects, {readings.by_place(), readings.by_time()});
  if (lack.kind == Misfit::none) return {};
  if (lack.rest < rest_told * norm(readings.whitened(powers.cut_w))) return {};
  const FitState state = is_refused(lack) ? FitState::refused : FitState::widened;
  return {.verdict = verdict(state, lack.kind, text_of(lack)), .moved = lack.moved};
}

}  // namespace stanok::process
