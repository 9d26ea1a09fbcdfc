#include "daemon/desk/surface_desk.h"

#include <algorithm>
#include <cmath>

#include "daemon/desk/process/process_answers.h"
#include "daemon/desk/program_folder.h"
#include "daemon/report/part_json.h"
#include "protocol/contract/geometry_bytes.h"
#include "runtime/workpiece/stl_files.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using protocol::Failure;
using runtime::SurfacePage;
using runtime::SurfaceRequest;
using simulation::ReferenceSurface;

// In steps of 0.1 um, two's complement.
std::uint32_t deviation_of(const ReferenceSurface& reference, const SurfacePage::Corner& corner) {
  constexpr double steps_per_mm = 1e4;
  constexpr double steps_max = 2e9;
  const auto& [x, y, z] = corner.place_mm;
  const double steps = std::round(steps_per_mm * reference.deviation({x, y, z}));
  return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::clamp(steps, -steps_max, steps_max)));
}

std::string base64_of_corners(const SurfacePage& page, const ReferenceSurface* reference) {
  protocol::GeometryBytes bytes;
  bytes.reserve(page.corners.size());
  for (const SurfacePage::Corner& corner : page.corners) {
    bytes.add(corner.place_mm, reference == nullptr ? static_cast<std::uint32_t>(corner.tool)
                                                    : deviation_of(*reference, corner));
  }
  return bytes.base64();
}

json geometry_of_surface(const SurfacePage& page, std::size_t number,
                         const ReferenceSurface* reference) {
  json bricks = json::array();
  for (const SurfacePage::Brick& brick : page.bricks)
    bricks.push_back({brick.number, brick.first, brick.behind});
  return {{"kind", protocol::GeometryKind::surface},
          {"id", page.workpiece},
          {"page", number},
          {"count", page.corners.size()},
          {"bricks", std::move(bricks)},
          {"base64", base64_of_corners(page, reference)}};
}

// A kind that nobody knows is no blank: it has been refused.
const char* name_of_blank(simulation::BlankKind kind) {
  if (kind == simulation::BlankKind::solid) return "solid";
  return kind == simulation::BlankKind::cylinder ? "cylinder" : "box";
}

json numbers(const simulation::Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

json surface_answer(int channel, const SurfaceRequest& request,
                    const std::optional<SurfacePage>& page, const ReferenceSurface* reference) {
  if (!page) {
    return {{"channel", channel},   {"workpiece", nullptr}, {"version", 0},
            {"next", nullptr},      {"blank", nullptr},     {"base", nullptr},
            {"cycles_left_out", 0}, {"geometry", nullptr}};
  }
  const simulation::Blank& blank = page->blank;
  return {{"channel", channel},
          {"workpiece", page->workpiece},
          {"version", page->version},
          {"next", page->next ? json(*page->next) : json(nullptr)},
          {"blank",
           {{"shape", name_of_blank(blank.kind)},
            {"size", numbers(blank.size)},
            {"zero", numbers(blank.zero)},
            {"resolution", blank.resolution}}},
          {"base", carried_json(page->scheme, page->in_base)},
          {"cycles_left_out", page->cycles_left_out},
          {"geometry", geometry_of_surface(*page, request.from, reference)}};
}

}  // namespace

void SurfaceDesk::surface(int session, const json& parameters, int channel, Answer answer) {
  const SurfaceRequest request{.workpiece = parameters.value("workpiece", std::uint32_t{0}),
                               .since = parameters.value("since", std::uint32_t{0}),
                               .from = parameters.value("from", std::size_t{0})};
  const auto work = [live = machine_.live_workpieces(), request, channel, known = reference_,
                     folder = ProgramFolder(machine_.program_root(),
                                            runtime::program_format(machine_.file().machine)),
                     name = parameters.value("reference", std::string())](
                        const std::stop_token&) -> CommandResult {
    // Who begins anew gets the file as it is now.
    const bool begins = request.since == 0 && request.from == 0;
    if (!name.empty() && (begins || known->program != name)) {
      *known = {};
      const auto file = folder.read(name);
      if (!file) return Unexpected<Failure>(file.error());
      const auto bytes = runtime::bytes_of_stl(file->path);
      if (!bytes) return nothing_told(bytes.error());
      auto surface = simulation::reference_of_stl(*bytes);
      if (!surface) return nothing_told(name + ": " + surface.error());
      known->surface.emplace(std::move(*surface));
      known->program = name;
    }
    const ReferenceSurface* const reference = name.empty() ? nullptr : &*known->surface;
    const auto page = live == nullptr ? std::nullopt : live->page(channel, request);
    return surface_answer(channel, request, page, reference);
  };
  work_.submit(session, work, std::move(answer));
}

}  // namespace stanok::daemon
