#include "bench/engine/scaling.h"

#include "common/engine/renderer.h"
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
#include <stdexcept>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterlab::bench {

namespace {

/// What `measure` gives in a process of its own: memory and threads begin afresh.
double apart(const std::function<double()>& measure) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const double value = measure();
    _exit(write(ends[1], &value, sizeof(value)) == sizeof(value) ? 0 : 1);
  }
  close(ends[1]);
  double value = 0;
  const bool came = read(ends[0], &value, sizeof(value)) == sizeof(value);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!came) throw std::runtime_error("a measurement did not end well");
  return value;
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

/// Everything needed to draw a scene over and over.
class Drawing {
 public:
  Drawing(const Scene& scene, ShadingKind kind, int threads, int w = width, int h = height)
      : scene_(scene),
        kind_(kind),
        prepared_(scene.mesh),
        frame_(w, h),
        renderer_({.threads = threads, .pin_threads = true, .skip = {}}) {}

  void draw() {
    const PhongShader phong = {{.eye = scene_.eye}};
    DrawCall call = {.mesh = &prepared_, .matrix = scene_.matrix};
    if (kind_ == ShadingKind::phong) call.shading = shading(phong);
    frame_.clear();
    renderer_.draw(call, frame_);
  }

  Cost cost() {
    const std::map<int, double> before = thread_times();
    const auto start = std::chrono::steady_clock::now();
    draw();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    double busiest = 0;
    for (const auto& [thread, time] : thread_times()) {
      const auto was = before.find(thread);
      busiest = std::max(busiest, time - (was == before.end() ? 0 : was->second));
    }
    return {wall.count(), busiest * 1e-6};
  }

 private:
  const Scene& scene_;
  ShadingKind kind_;
  PreparedMesh prepared_;
  Framebuffer frame_;
  Renderer renderer_;
};

/// Medians of two drawings' costs, measured in turn.
std::array<Cost, 2> medians(Drawing& first, Drawing& second) {
  std::array<std::vector<double>, 2> wall;
  std::array<std::vector<double>, 2> busiest;
  first.draw();
  second.draw();
  for (int i = 0; i < 15; ++i) {
    for (const std::size_t which : {0U, 1U}) {
      const Cost cost = (which == 0 ? first : second).cost();
      wall[which].push_back(cost.wall);
      busiest[which].push_back(cost.busiest);
    }
  }
  return {Cost{median(wall[0]), median(busiest[0])}, Cost{median(wall[1]), median(busiest[1])}};
}

Scene scene_named(const std::string& name) {
  for (const SceneEntry& entry : scenes()) {
    if (entry.name == name) return entry.make({width, height});
  }
  throw std::runtime_error("no scene " + name);
}

double two_threads(const std::string& name, ShadingKind kind, double Cost::*what) {
  const Scene scene = scene_named(name);
  Drawing one(scene, kind, 1);
  Drawing two(scene, kind, 2);
  const auto [cost_of_one, cost_of_two] = medians(one, two);
  return cost_of_one.*what / cost_of_two.*what;
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
double cost_of_more(float at_z) {
  const Scene scene = sphere_before_wall(false, 0);
  const Scene more = sphere_before_wall(true, at_z);
  Drawing without(scene, ShadingKind::depth, 1);
  Drawing with(more, ShadingKind::depth, 1);
  const auto [few, many] = medians(without, with);
  return (many.busiest / few.busiest - 1) * 100;
}

/// Of /proc/self/status, in MB.
double memory(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(name + ":", 0) == 0) return std::stod(line.substr(name.size() + 1)) / 1024;
  }
  throw std::runtime_error("no " + name);
}

double memory_beyond_mesh() {
  const Scene scene = scene_named("sphere 8M");
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // forgets the peak so far
  const double before = memory("VmRSS");
  Drawing drawing(scene, ShadingKind::phong, 2);
  drawing.draw();
  return memory("VmHWM") - before;
}

double memory_of_large_picture() {
  const Scene scene = scene_named("quads front to back");
  Drawing drawing(scene, ShadingKind::phong, 2, 16384, 16384);
  drawing.draw();
  return memory("VmHWM");
}

}  // namespace

std::vector<ScalingResult> measure_scaling() {
  std::vector<ScalingResult> results;
  const auto add = [&](const std::string& name, double limit, bool at_least,
                       const std::function<double()>& measure) {
    results.push_back({name, apart(measure), limit, at_least});
    const ScalingResult& r = results.back();
    std::printf("%-64s %8.2f  (%s %.4g%s)\n", name.c_str(), r.value,
                at_least ? "at least" : "at most", limit, r.reached() ? "" : ": not reached");
    std::fflush(stdout);
  };
  for (const std::string scene : {"sphere 1M", "tori far to near"}) {
    for (const ShadingKind kind : {ShadingKind::depth, ShadingKind::phong}) {
      const std::string name = "two threads against one, " + scene + ", " + name_of(kind);
      add(name, 1.8, true, [=] { return two_threads(scene, kind, &Cost::wall); });
      add(name + ", by processor time of the busiest", 1.8, true,
          [=] { return two_threads(scene, kind, &Cost::busiest); });
    }
  }
  add("ten times the geometry hidden behind a wall, % more time", 20, false,
      [] { return cost_of_more(-7); });
  add("ten times the geometry behind the camera, % more time", 10, false,
      [] { return cost_of_more(3); });
  add("8M triangles: MB beyond the mesh's own arrays", 400, false, memory_beyond_mesh);
  add("16384 x 16384 pixels: MB", 3000, false, memory_of_large_picture);
  return results;
}

nlohmann::json to_json(const std::vector<ScalingResult>& results) {
  nlohmann::json array = nlohmann::json::array();
  for (const ScalingResult& r : results) {
    array.push_back({{"name", r.name},
                     {"value", r.value},
                     {"limit", r.limit},
                     {"at_least", r.at_least},
                     {"reached", r.reached()}});
  }
  return array;
}

}  // namespace rasterlab::bench
