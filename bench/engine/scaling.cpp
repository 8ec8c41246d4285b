#include "bench/engine/scaling.h"

#include "common/engine/renderer.h"
#include "common/engine/thread_team.h"
#include "common/mesh/shapes.h"

#include "bench/engine/bench_shaders.h"
#include "bench/engine/pinning.h"
#include "bench/engine/scenes.h"
#include "bench/support/statistics.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterlab::bench {

namespace {

/// What came out, and how far apart the quartiles are of what it is the median of, in its unit.
struct Measured {
  double value;
  double spread = 0;

  static Measured of(const std::vector<double>& values) {
    const double middle = median(values);
    return {middle, bench::spread(values) * middle};
  }
};

/// What `measure` gives in a process of its own: memory and threads begin afresh.
template <class Values>
Values apart(const std::function<Values()>& measure) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const Values values = measure();
    _exit(write(ends[1], &values, sizeof(values)) == sizeof(values) ? 0 : 1);
  }
  close(ends[1]);
  Values values;
  const bool came = read(ends[0], &values, sizeof(values)) == sizeof(values);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!came) throw std::runtime_error("a measurement did not end well");
  return values;
}

/// Nanoseconds each thread has run.
std::map<int, double> thread_times() {
  std::map<int, double> times;
  for (const int thread : thread_ids()) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    file >> times[thread];
  }
  return times;
}

/// A frame's cost, whatever else the machine does: milliseconds of the clock, and processor time of
/// the thread that took most.
struct Cost {
  double wall;
  double busiest;
};

constexpr int width = 1920;
constexpr int height = 1080;

/// What `work` costs.
template <class Work>
Cost cost_of(const Work& work) {
  const std::map<int, double> before = thread_times();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  double busiest = 0;
  for (const auto& [thread, time] : thread_times()) {
    const auto was = before.find(thread);
    busiest = std::max(busiest, time - (was == before.end() ? 0 : was->second));
  }
  return {wall.count(), busiest * 1e-6};
}

/// Everything needed to draw a scene over and over.
class Drawing {
 public:
  /// Keeps colours, or what there is without them.
  Drawing(const Scene& scene, ShadingKind kind)
      : Drawing(scene, kind, kind == ShadingKind::phong ? Keep::color : Keep::depth, width,
                height) {}
  Drawing(const Scene& scene, ShadingKind kind, Keep keep, int w, int h)
      : scene_(scene), kind_(kind), keep_(keep), prepared_(scene.mesh), frame_(w, h) {}

  void draw(Renderer& renderer) {
    const PhongShader phong = {{.eye = scene_.eye}};
    DrawCall call = {.mesh = &prepared_, .matrix = scene_.matrix, .keep = keep_};
    if (kind_ == ShadingKind::phong) call.shading = shading(phong);
    frame_.clear();
    renderer.draw(call, frame_);
  }

  Cost cost(Renderer& renderer) {
    return cost_of([&] { draw(renderer); });
  }

 private:
  const Scene& scene_;
  ShadingKind kind_;
  Keep keep_;
  PreparedMesh prepared_;
  Framebuffer frame_;
};

EngineOptions pinned(int threads) {
  return {.threads = threads, .pin_threads = true, .skip = {}};
}

/// How many times one cost is another.
struct CostRatio {
  Measured wall;
  Measured busiest;
};

/// Of some frames in a row the middle ones by the clock and by processor time. The first, which
/// finds threads asleep and caches with something else in them, isn't counted.
template <class MakeFrame>
Cost cost_in_a_row(const MakeFrame& frame) {
  std::vector<double> wall;
  std::vector<double> busiest;
  frame();
  for (int i = 0; i < 5; ++i) {
    const Cost cost = frame();
    wall.push_back(cost.wall);
    busiest.push_back(cost.busiest);
  }
  return {median(wall), median(busiest)};
}

/// Some frames of the one and some of the other in turns, so that what slows the machine down for a
/// while slows both.
class Turns {
 public:
  template <class MakeFrame, class MakeOther>
  void take(const MakeFrame& one, const MakeOther& other) {
    const Cost a = cost_in_a_row(one);
    const Cost b = cost_in_a_row(other);
    wall_.push_back(a.wall / b.wall);
    busiest_.push_back(a.busiest / b.busiest);
  }

  CostRatio ratio() const { return {Measured::of(wall_), Measured::of(busiest_)}; }

 private:
  std::vector<double> wall_;
  std::vector<double> busiest_;
};

constexpr int turns = 15;

template <class MakeFrame, class MakeOther>
CostRatio ratio_of_costs(const MakeFrame& one, const MakeOther& other) {
  Turns both;
  for (int i = 0; i < turns; ++i) both.take(one, other);
  return both.ratio();
}

Scene scene_named(const std::string& name) {
  for (const SceneEntry& entry : scenes()) {
    if (entry.name == name) return entry.make({width, height});
  }
  throw std::runtime_error("no scene " + name);
}

/// Called, so that one thread and two run the same instructions.
[[gnu::noinline]] void sum_products(std::span<float> numbers) {
  for (int times = 0; times < 20000; ++times) {
    for (float& n : numbers) n = n * 0.999F + 0.5F;
  }
}

/// Work that is cut in halves, each of which knows nothing of the other nor asks for memory: what
/// two threads can be against one on this machine, whose cores others may use.
Cost cost_of_halves(ThreadTeam& team) {
  return cost_of([&team] {
    std::optional<StayOnCore> on_core;
    team.stay(on_core);
    std::array<std::array<float, 1024>, 2> numbers{};
    team.for_each(2, [&](int half, int) { sum_products(numbers[static_cast<std::size_t>(half)]); });
  });
}

struct TwoThreads {
  CostRatio engine;
  CostRatio machine;  ///< meanwhile
};

TwoThreads two_threads(const std::string& name, ShadingKind kind) {
  const Scene scene = scene_named(name);
  Drawing drawing(scene, kind);
  Renderer one(pinned(1));
  Renderer two(pinned(2));
  ThreadTeam alone(1, true);
  ThreadTeam both(2, true);
  Turns engine;
  Turns machine;
  for (int i = 0; i < turns; ++i) {
    engine.take([&] { return drawing.cost(one); }, [&] { return drawing.cost(two); });
    machine.take([&] { return cost_of_halves(alone); }, [&] { return cost_of_halves(both); });
  }
  return {engine.ratio(), machine.ratio()};
}

/// A sphere of 100 000 triangles before a wall, and what else there is ten times as much of.
Scene sphere_before_wall(bool with_more, float more_at_z) {
  Scene scene = scene_named("quads front to back");
  const Mesh ball = make_shape("uv_sphere", 158);
  Mesh mesh;
  const auto append = [&mesh](const Mesh& part, const Eigen::Vector3f& at, float scale) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Eigen::Vector3f& p : part.positions) mesh.positions.push_back(at + scale * p);
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    for (const auto& [a, b, c] : part.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  };
  append(ball, {0, 0, -3}, 1);
  append(make_shape("wall", 1), {0, 0, -5}, 12);
  for (int i = 0; with_more && i < 10; ++i) {
    append(ball, {0.2F * static_cast<float>(i) - 1, 0, more_at_z}, 1);
  }
  scene.mesh = std::move(mesh);
  return scene;
}

/// How much longer a frame takes with ten times the geometry at a depth, in percent.
Measured cost_of_more(float at_z) {
  const Scene scene = sphere_before_wall(false, 0);
  const Scene more = sphere_before_wall(true, at_z);
  Drawing without(scene, ShadingKind::depth);
  Drawing with(more, ShadingKind::depth);
  Renderer renderer(pinned(1));
  const Measured ratio =
      ratio_of_costs([&] { return with.cost(renderer); }, [&] { return without.cost(renderer); })
          .busiest;
  return {(ratio.value - 1) * 100, ratio.spread * 100};
}

/// Of /proc/self/status, in MB.
double memory(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(name + ":", 0) == 0) return std::stod(line.substr(name.size() + 1)) / 1024;
  }
  throw std::runtime_error("no " + name);
}

Measured memory_beyond_mesh() {
  const Scene scene = scene_named("sphere 8M");
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // forgets the peak so far
  const double before = memory("VmRSS");
  Drawing drawing(scene, ShadingKind::phong, Keep::everything, width, height);
  Renderer renderer(pinned(2));
  drawing.draw(renderer);
  return {memory("VmHWM") - before};
}

Measured memory_of_large_picture() {
  const Scene scene = scene_named("quads front to back");
  Drawing drawing(scene, ShadingKind::phong, Keep::everything, 16384, 16384);
  Renderer renderer(pinned(2));
  drawing.draw(renderer);
  return {memory("VmHWM")};
}

void print(const ScalingResult& r) {
  std::printf("%-76s %8.2f  spread %5.2f  (%s %.4g%s", r.name.c_str(), r.value, r.spread,
              r.at_least ? "at least" : "at most", r.limit, r.reached() ? "" : ": not reached");
  if (r.machine) std::printf("; sums in registers meanwhile: %.2f", *r.machine);
  std::puts(")");
  std::fflush(stdout);
}

}  // namespace

std::vector<ScalingResult> measure_scaling() {
  std::vector<ScalingResult> results;
  const auto add = [&](const std::string& name, const Measured& measured, double limit,
                       bool at_least, std::optional<double> machine = {}) {
    results.push_back({name, measured.value, measured.spread, limit, at_least, machine});
    print(results.back());
  };
  const auto add_most = [&](const std::string& name, double limit, Measured (*measure)()) {
    add(name, apart<Measured>(measure), limit, false);
  };
  for (const std::string scene : {"sphere 1M", "tori far to near"}) {
    for (const ShadingKind kind : {ShadingKind::depth, ShadingKind::phong}) {
      const std::string name = "two threads against one, " + scene + ", " + name_of(kind);
      const auto [engine, machine] = apart<TwoThreads>([&] { return two_threads(scene, kind); });
      add(name, engine.wall, 1.8, true, machine.wall.value);
      add(name + ", by processor time of the busiest", engine.busiest, 1.8, true,
          machine.busiest.value);
    }
  }
  add_most("ten times the geometry hidden behind a wall, % more time", 20,
           [] { return cost_of_more(-7); });
  add_most("ten times the geometry behind the camera, % more time", 10,
           [] { return cost_of_more(3); });
  add_most("8M triangles: MB beyond the mesh's own arrays", 400, memory_beyond_mesh);
  add_most("16384 x 16384 pixels: MB", 3000, memory_of_large_picture);
  return results;
}

nlohmann::json to_json(const std::vector<ScalingResult>& results) {
  nlohmann::json array = nlohmann::json::array();
  for (const ScalingResult& r : results) {
    array.push_back({{"name", r.name},
                     {"value", r.value},
                     {"spread", r.spread},
                     {"limit", r.limit},
                     {"at_least", r.at_least},
                     {"reached", r.reached()}});
    if (r.machine) array.back()["sums_in_registers"] = *r.machine;
  }
  return array;
}

}  // namespace rasterlab::bench
