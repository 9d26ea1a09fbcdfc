#include "daemon/desk/surface_desk.h"

#include "protocol/geometry_bytes.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using runtime::SurfacePage;
using runtime::SurfaceRequest;

std::string base64_of(const SurfacePage& page) {
  protocol::GeometryBytes bytes;
  bytes.reserve(page.corners.size());
  for (const SurfacePage::Corner& corner : page.corners)
    bytes.add(corner.place_mm, static_cast<std::uint32_t>(corner.tool));
  return bytes.base64();
}

json geometry_of(const SurfacePage& page, std::size_t number) {
  json bricks = json::array();
  for (const SurfacePage::Brick& brick : page.bricks)
    bricks.push_back({brick.number, brick.first, brick.behind});
  return {{"kind", protocol::GeometryKind::surface},
          {"id", page.workpiece},
          {"page", number},
          {"count", page.corners.size()},
          {"bricks", std::move(bricks)},
          {"base64", base64_of(page)}};
}

// A kind that nobody knows is no blank: it has been refused.
const char* name_of(simulation::BlankKind kind) {
  if (kind == simulation::BlankKind::solid) return "solid";
  return kind == simulation::BlankKind::cylinder ? "cylinder" : "box";
}

json numbers(const simulation::Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

json surface_answer(int channel, const SurfaceRequest& request,
                    const std::optional<SurfacePage>& page) {
  if (!page) {
    return {{"channel", channel}, {"workpiece", nullptr}, {"version", 0},       {"next", nullptr},
            {"blank", nullptr},   {"cycles_left_out", 0}, {"geometry", nullptr}};
  }
  const simulation::Blank& blank = page->blank;
  return {{"channel", channel},
          {"workpiece", page->workpiece},
          {"version", page->version},
          {"next", page->next ? json(*page->next) : json(nullptr)},
          {"blank",
           {{"shape", name_of(blank.kind)},
            {"size", numbers(blank.size)},
            {"zero", numbers(blank.zero)},
            {"resolution", blank.resolution}}},
          {"cycles_left_out", page->cycles_left_out},
          {"geometry", geometry_of(*page, request.from)}};
}

}  // namespace

void SurfaceDesk::surface(int session, const json& parameters, int channel, Answer answer) {
  const SurfaceRequest request{.workpiece = parameters.value("workpiece", std::uint32_t{0}),
                               .since = parameters.value("since", std::uint32_t{0}),
                               .from = parameters.value("from", std::size_t{0})};
  const auto work = [live = machine_.live_workpieces(), request,
                     channel](const std::stop_token&) -> CommandResult {
    const auto page = live == nullptr ? std::nullopt : live->page(channel, request);
    return surface_answer(channel, request, page);
  };
  work_.submit(session, work, std::move(answer));
}

}  // namespace stanok::daemon
