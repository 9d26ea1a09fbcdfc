#include "daemon/desk/path_pages.h"

#include <cmath>

#include "base/enum_names.h"
#include "daemon/report/part_json.h"
#include "protocol/contract/geometry_bytes.h"

namespace stanok::daemon {
namespace {

using jobs::GivenUp;
using jobs::PathPage;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;

constexpr auto given_up_names = enum_names<GivenUp>({
    {GivenUp::no, ""},
    {GivenUp::computing_time, "computing_time"},
    {GivenUp::machine_time, "machine_time"},
    {GivenUp::points, "points"},
    {GivenUp::refused, "refused"},
    {GivenUp::failed, "failed"},
    {GivenUp::replaced, "replaced"},
});

json word_of(GivenUp why) {
  return why == GivenUp::no ? json(nullptr) : json(std::string(given_up_names[why]));
}

using Places = std::array<float, 3> PathPage::Point::*;

constexpr std::string_view on_part = "part";

std::string base64_of_points(const PathPage& page, Places places) {
  protocol::GeometryBytes bytes;
  bytes.reserve(page.points.size());
  for (const PathPage::Point& point : page.points) bytes.add(point.*places, point.line);
  return bytes.base64();
}

// [first, behind the last] of the points that are so.
json ranges_where(const PathPage& page, bool PathPage::Point::* is_so) {
  json ranges = json::array();
  std::size_t first = 0;
  for (std::size_t k = 0; k <= page.points.size(); ++k) {
    if (k < page.points.size() && page.points[k].*is_so) continue;
    if (k > first) ranges.push_back({first, k});
    first = k + 1;
  }
  return ranges;
}

// [point, value]: the value that holds from this point on.
template <class Read>
json steps_of(const PathPage& page, const Read& read) {
  json steps = json::array();
  for (std::size_t k = 0; k < page.points.size(); ++k) {
    const auto now = read(page.points[k]);
    if (k == 0 || now != read(page.points[k - 1])) steps.push_back({k, now});
  }
  return steps;
}

// In tenths of mm/min.
double feed_of(const PathPage::Point& point) {
  return std::round(static_cast<double>(point.feed_mm_per_min) * 10.0) / 10.0;
}

json geometry_of_path(const PathPage& page, std::uint32_t id, std::size_t number, Places places) {
  return {{"kind", protocol::GeometryKind::path},
          {"id", id},
          {"page", number},
          {"count", page.points.size()},
          {"rapid", ranges_where(page, &PathPage::Point::rapid)},
          {"arcs", ranges_where(page, &PathPage::Point::arc)},
          {"begins", ranges_where(page, &PathPage::Point::begins)},
          {"feeds", steps_of(page, feed_of)},
          {"tools", steps_of(page, [](const PathPage::Point& point) { return point.tool; })},
          {"base64", base64_of_points(page, places)}};
}

CommandResult path_is_gone() {
  return Unexpected<Failure>(
      Failure{FailureKind::refused, "E9018", "a newer path has replaced it", 0, {}});
}

}  // namespace

CommandResult path_answer(const jobs::PlannedPath* path, int channel, const json& parameters) {
  const bool wants_one = parameters.contains("page") && parameters.value("follow", 0) == 0;
  const auto wanted_id = parameters.value("path", std::uint64_t{0});
  const auto system = parameters.value("system", std::string("work"));
  if (path == nullptr) {
    if (wanted_id != 0) return path_is_gone();
    return json{{"channel", channel},  {"program", nullptr}, {"id", nullptr},
                {"pages", 0},          {"points", 0},        {"complete", false},
                {"given_up", nullptr}, {"system", system},   {"part", nullptr},
                {"geometry", nullptr}};
  }
  if (wanted_id != 0 && wanted_id != path->id()) return path_is_gone();
  const auto state = path->state();
  const auto number = parameters.value("page", std::size_t{0});
  const auto page = path->page(number);
  json answer = {
      {"channel", channel},
      {"program", path->program()},
      {"id", path->id()},
      {"pages", state.pages},
      {"points", state.points},
      {"complete", state.is_complete},
      {"given_up", word_of(state.given_up)},
      {"system", system},
      {"part", state.part ? carried_json(state.part->scheme, state.part->in_base) : json(nullptr)},
      {"geometry", nullptr}};
  if (page == nullptr) return answer;
  const Places places =
      system == on_part ? &PathPage::Point::on_part_mm : &PathPage::Point::place_mm;
  answer["geometry"] = geometry_of_path(*page, path->id(), number, places);
  if (!wants_one && number + 1 < state.pages) {
    answer["geometry"]["more"] = {{"method", "program.path"},
                                  {"params",
                                   {{"channel", channel},
                                    {"path", path->id()},
                                    {"page", number + 1},
                                    {"follow", 1},
                                    {"system", system}}}};
  }
  return answer;
}

}  // namespace stanok::daemon
