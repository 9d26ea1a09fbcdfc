#include "lang/pockets/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace stanok::lang {
namespace {

// An end of a stretch: on which edge, and how far along it from its first corner.
struct EdgePlace {
  std::size_t line = 0;
  std::size_t edge = 0;
  double along = 0.0;
  PlanePoint point;
};

// A stretch of a scan line that lies in the region.
struct Stretch {
  EdgePlace begin;
  EdgePlace end;
  std::size_t row = 0;
  bool done = false;
};

PlanePoint swapped(PlanePoint p) {
  return {p.second, p.first};
}

// How far each corner of a closed line is from the first one, along it; last the whole length.
std::vector<double> lengths_along(const ClosedLine& line) {
  std::vector<double> lengths{0.0};
  for (std::size_t k = 0; k < line.size(); ++k)
    lengths.push_back(lengths.back() + norm(line[(k + 1) % line.size()] - line[k]));
  return lengths;
}

// In coordinates whose first one runs along the scan lines.
class Scan {
 public:
  Scan(std::vector<ClosedLine> edges, double step) : edges_(std::move(edges)), step_(step) {
    for (const ClosedLine& line : edges_) lengths_.push_back(lengths_along(line));
    find_stretches();
  }

  // Ways over all stretches, from where the tool stands if that is an end of one.
  std::vector<PocketWay> ways() {
    std::vector<PocketWay> ways;
    for (Stretch& stretch : stretches_) {
      if (stretch.done) continue;
      ways.push_back({stretch.begin.point});
      follow(stretch, stretch.end, ways.back());
    }
    return ways;
  }

 private:
  void find_stretches() {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlanePoint& point : edges_.front()) {
      low = std::min(low, point.second);
      high = std::max(high, point.second);
    }
    // The edges of the region are cut: no line on them.
    const auto rows = static_cast<std::size_t>(std::ceil((high - low) / step_));
    for (std::size_t row = 1; row < rows; ++row) {
      first_of_row_.push_back(stretches_.size());
      add_row(row, low + static_cast<double>(row) * (high - low) / static_cast<double>(rows));
    }
    first_of_row_.push_back(stretches_.size());
  }

  void add_row(std::size_t row, double level) {
    std::vector<EdgePlace> places;
    for (std::size_t line = 0; line < edges_.size(); ++line) {
      const ClosedLine& corners = edges_[line];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const PlanePoint& a = corners[k];
        const PlanePoint& b = corners[(k + 1) % corners.size()];
        if ((a.second <= level) == (b.second <= level)) continue;
        const double part = (level - a.second) / (b.second - a.second);
        places.push_back({line,
                          k,
                          lengths_[line][k] + part * norm(b - a),
                          {a.first + part * (b.first - a.first), level}});
      }
    }
    std::ranges::sort(places, {}, [](const EdgePlace& place) { return place.point.first; });
    for (std::size_t k = 0; k + 1 < places.size(); k += 2)
      stretches_.push_back({places[k], places[k + 1], row});
  }

  // Along `stretch` to `end`, and on to stretches of the rows beside as long as there are.
  void follow(Stretch& first, EdgePlace end, PocketWay& way) {
    Stretch* stretch = &first;
    while (true) {
      stretch->done = true;
      way.push_back(end.point);
      const auto next = next_stretch(end, stretch->row);
      if (!next) return;
      go_along_edge(end, next->from, way);
      stretch = next->stretch;
      end = next->to;
    }
  }

  struct Next {
    Stretch* stretch = nullptr;
    EdgePlace from;
    EdgePlace to;
    double way = 0.0;
  };

  std::optional<Next> next_stretch(const EdgePlace& end, std::size_t row) {
    constexpr double detour_max = 4.0;  // of the distance of lines
    std::optional<Next> best;
    const std::size_t low = row > 1 ? row - 1 : row;
    for (std::size_t beside = low; beside <= row + 1 && beside < first_of_row_.size(); ++beside) {
      for (std::size_t k = first_of_row_[beside - 1]; k < first_of_row_[beside]; ++k) {
        Stretch& stretch = stretches_[k];
        if (stretch.done) continue;
        consider(end, {&stretch, stretch.begin, stretch.end}, best);
        consider(end, {&stretch, stretch.end, stretch.begin}, best);
      }
    }
    return best && best->way <= detour_max * step_ ? best : std::nullopt;
  }

  void consider(const EdgePlace& end, Next next, std::optional<Next>& best) const {
    if (next.from.line != end.line) return;
    const double whole = lengths_[end.line].back();
    const double straight = std::abs(next.from.along - end.along);
    next.way = std::min(straight, whole - straight);
    if (!best || next.way < best->way) best = next;
  }

  // The shorter way along the edge; `from` is on the way already.
  void go_along_edge(const EdgePlace& from, const EdgePlace& to, PocketWay& way) const {
    const ClosedLine& line = edges_[from.line];
    const double whole = lengths_[from.line].back();
    double ahead = to.along - from.along;
    if (ahead < 0.0) ahead += whole;
    std::size_t edge = from.edge;
    if (ahead <= whole - ahead) {
      while (edge != to.edge) {
        edge = (edge + 1) % line.size();
        way.push_back(line[edge]);
      }
    } else {
      while (edge != to.edge) {
        way.push_back(line[edge]);
        edge = (edge + line.size() - 1) % line.size();
      }
    }
    way.push_back(to.point);
  }

  std::vector<ClosedLine> edges_;
  double step_;
  std::vector<std::vector<double>> lengths_;
  std::vector<Stretch> stretches_;
  std::vector<std::size_t> first_of_row_;  // of row k at k - 1
};

}  // namespace

void add_scan_lines(const std::vector<ClosedLine>& edges, ScanLines direction, double step_mm,
                    std::vector<PocketWay>& ways) {
  std::vector<ClosedLine> turned = edges;
  const bool turns = direction == ScanLines::along_second;
  for (ClosedLine& line : turned) {
    for (PlanePoint& point : line) point = turns ? swapped(point) : point;
  }
  for (PocketWay& way : Scan(std::move(turned), step_mm).ways()) {
    for (PlanePoint& point : way) point = turns ? swapped(point) : point;
    ways.push_back(std::move(way));
  }
}

}  // namespace stanok::lang
