// What a plunge grinding cycle costs: one simulation, the continuous law, the staircase, all of a
// design. The process is the example of docs/programmer/grinding.md.
#include <benchmark/benchmark.h>

#include "process/grinding/cycle_design.h"

namespace stanok::process {
namespace {

DesignRequest example() {
  DesignRequest request;
  request.process = {.part_radius_mm = 30.0,
                     .width_mm = 20.0,
                     .wheel_radius_mm = 200.0,
                     .stiffness_n_per_m = 25e6,
                     .mass_kg = 32.0,
                     .damping_n_s_per_m = 50911.7,
                     .part_speed_rpm = 120.0,
                     .force_factor = 3.6,
                     .force_exponent = 0.56,
                     .deflection_max_mm = 0.010,
                     .critical_allowance_mm = 0.090,
                     .removal_end_mm2_per_rad = 0.050};
  request.allowance_mm = 0.3;
  return request;
}

// 14.4 s of the cut in steps of 0.5 ms.
void plunge_simulation(benchmark::State& state) {
  const DesignRequest request = example();
  const InfeedLaw law = constant_law(0.3, 0.0, 0.3 / 14.4);
  std::size_t steps = 0;
  for ([[maybe_unused]] auto _ : state) {
    steps += simulate_plunge(request.process, law, {}).samples.size();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(steps));
}
BENCHMARK(plunge_simulation)->Unit(benchmark::kMillisecond);

void find_continuous_law(benchmark::State& state) {
  const DesignRequest request = example();
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(optimal_law(request.process, request.allowance_mm,
                                         usual_feeds(request.process), request.optimiser,
                                         request.simulation));
  }
}
BENCHMARK(find_continuous_law)->Unit(benchmark::kMillisecond);

void design_steps(benchmark::State& state) {
  const DesignRequest request = example();
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(design_staircase(request.process, request.allowance_mm,
                                              usual_feeds(request.process), request.staircase,
                                              request.simulation));
  }
}
BENCHMARK(design_steps)->Unit(benchmark::kMillisecond);

void design_cycle_whole(benchmark::State& state) {
  const DesignRequest request = example();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(design_cycle(request));
}
BENCHMARK(design_cycle_whole)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stanok::process
