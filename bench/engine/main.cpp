// bench_engine: the engine against Mesa's llvmpipe, the same scenes in the same process, turn by
// turn.
#include "common/engine/renderer.h"
#include "common/stage/guard.h"

#include "bench/engine/bench_shaders.h"
#include "bench/engine/exact_coverage.h"
#include "bench/engine/peer.h"
#include "bench/engine/pinning.h"
#include "bench/engine/report.h"
#include "bench/engine/scaling.h"
#include "bench/engine/scenes.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <set>

#include <CLI/CLI.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterlab::bench {

namespace {

struct Settings {
  bool quick = false;
  std::string out = "out/bench_engine";
  std::string scene;
  std::string shading;
  std::string simd = std::string(name_of(best_simd_target()));
  std::vector<std::string> without;  ///< named_skips
  int width = 1920;
  int height = 1080;
  std::vector<int> threads = {1, 2};
  bool ours_only = false;
  int repeat = 0;
  bool stats = false;
  bool scaling = false;
  /// Only compare, with llvmpipe's texture filter at its most exact, which takes it a little
  /// longer.
  bool exact_peer = false;
};

struct Time {
  double wall;  ///< milliseconds
  double cpu;   ///< of all threads together
};

double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

Time time_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_milliseconds();
  work();
  const double cpu = cpu_milliseconds() - cpu_start;
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), cpu};
}

std::set<std::string> names_of_skips() {
  std::set<std::string> names;
  for (const NamedSkip& one : named_skips) names.insert(one.name);
  return names;
}

/// Our side: everything that stays from frame to frame.
class Ours {
 public:
  Ours(const Settings& settings, int threads, const Texture& texture, const Texture& normal_map)
      : renderer_({.threads = threads,
                   .simd = simd_target(settings.simd),
                   .pin_threads = true,
                   .skip = skips_without(settings.without)}),
        frame_(settings.width, settings.height),
        texture_(texture),
        normal_map_(normal_map) {}

  void load(const Scene& scene) { prepared_ = std::make_unique<PreparedMesh>(scene.mesh); }

  void draw(const Scene& scene, ShadingKind kind, Keep keep) {
    const Lighting lighting = {.eye = scene.eye};
    const FlatShader flat = {lighting};
    const PhongShader phong = {lighting};
    const TexturedShader textured = {lighting, &texture_};
    const NormalMappedShader mapped = {lighting, {normal_map_, texture_}, &scene.tangents};
    DrawCall call = {.mesh = prepared_.get(), .matrix = scene.matrix, .keep = keep};
    if (kind == ShadingKind::flat) call.shading = shading(flat);
    if (kind == ShadingKind::phong) call.shading = shading(phong);
    if (kind == ShadingKind::textured) call.shading = shading(textured);
    if (kind == ShadingKind::normal_mapped) call.shading = shading(mapped);
    frame_.clear();
    statistics_ = renderer_.draw(call, frame_);
  }

  const Framebuffer& frame() const { return frame_; }
  const Statistics& statistics() const { return statistics_; }

 private:
  Renderer renderer_;
  Framebuffer frame_;
  const Texture& texture_;
  const Texture& normal_map_;
  std::unique_ptr<PreparedMesh> prepared_;
  Statistics statistics_;
};

/// What the measured frames keep. The peer can't know that its depth isn't wanted.
Keep kept_for(ShadingKind kind) {
  return kind == ShadingKind::depth ? Keep::depth : Keep::color;
}

/// How two pictures of a scene agree, per million pixels; and if not, who is right.
void compare(const Ours& ours, const Peer& peer, const Scene& scene, ShadingKind kind,
             Result& result) {
  const Image<std::int32_t> ids = ours.frame().ids();
  const Image<std::uint8_t> there = peer.coverage();
  const Image<Rgb8>& a = ours.frame().color();
  const Image<Rgb8> b = peer.color();
  const auto pixels = static_cast<double>(ids.pixels().size());
  double coverage = 0;
  double colors = 0;
  double covered = 0;
  for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
    const bool drawn = ids.pixels()[i] >= 0;
    covered += drawn ? 1 : 0;
    if (drawn != (there.pixels()[i] != 0)) {
      ++coverage;
    } else if (kind != ShadingKind::depth) {
      const Rgb8 p = a.pixels()[i];
      const Rgb8 q = b.pixels()[i];
      const int difference =
          std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
      colors += difference > 3 ? 1 : 0;
    }
  }
  result.coverage_difference = coverage / pixels * 1e6;
  result.color_difference = colors / pixels * 1e6;
  result.pixels = covered;
  if (result.coverage_difference <= difference_limit) return;
  const Image<std::uint8_t> exact = exact_coverage(scene, ids.width(), ids.height());
  for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
    const bool covers = exact.pixels()[i] != 0;
    result.our_error += covers != (ids.pixels()[i] >= 0) ? 1e6 / pixels : 0;
    result.peer_error += covers != (there.pixels()[i] != 0) ? 1e6 / pixels : 0;
  }
}

class Bench {
 public:
  Bench(const Settings& settings, int threads)
      : settings_(settings),
        threads_(threads),
        texture_image_(make_texture(1024)),
        normal_image_(make_normal_map(1024)),
        texture_(texture_image_),
        normal_map_(normal_image_) {
    // First: our threads take their cores from those this one still has.
    ours_ = std::make_unique<Ours>(settings, threads, texture_, normal_map_);
    pin(0, 0);
    if (!settings.ours_only) {
      setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
      if (settings.exact_peer) setenv("GALLIVM_PERF", "no_aos_sampling", 1);
      peer_ = std::make_unique<Peer>(settings.width, settings.height, threads);
      peer_->load_textures(texture_image_, normal_image_);
    }
  }

  std::vector<Result> run() {
    for (const SceneEntry& entry : scenes()) {
      if (!settings_.scene.empty() && entry.name != settings_.scene) continue;
      const Scene scene = entry.make({settings_.width, settings_.height});
      const double prepare = time_of([&] { ours_->load(scene); }).wall;
      if (peer_) peer_->load(scene);
      for (const ShadingKind kind : scene.shadings) {
        if (!settings_.shading.empty() && name_of(kind) != settings_.shading) continue;
        measure(scene, kind, prepare);
      }
    }
    return std::move(results_);
  }

 private:
  void measure(const Scene& scene, ShadingKind kind, double prepare) {
    Result result;
    result.scene = scene.name;
    result.shading = name_of(kind);
    result.threads = threads_;
    result.triangles = static_cast<double>(scene.mesh.triangles.size());
    result.prepare_ms = prepare;
    // Ours leaves this thread free to go anywhere when a frame is done.
    const auto draw_ours_keeping = [&](Keep keep) {
      ours_->draw(scene, kind, keep);
      pin(0, 0);
    };
    const auto draw_ours = [&] { draw_ours_keeping(kept_for(kind)); };
    const auto draw_peer = [&] {
      if (peer_) peer_->draw(scene, kind);
    };
    draw_ours();  // warm up: memory is there, code is compiled
    const Image<Rgb8> measured = ours_->frame().color();
    draw_ours_keeping(Keep::everything);
    if (ours_->frame().color() != measured) throw std::logic_error("what is kept changes pixels");
    for (int i = 0; i < (settings_.quick ? 1 : 2); ++i) draw_peer();
    if (peer_) compare(*ours_, *peer_, scene, kind, result);
    if (settings_.exact_peer) {
      results_.push_back(std::move(result));
      return;
    }
    const int least = settings_.repeat > 0 ? settings_.repeat : settings_.quick ? 5 : 15;
    const double most_ms = settings_.repeat > 0 ? 0 : settings_.quick ? 300 : 3000;
    double spent = 0;
    for (int i = 0; i < least || (spent < most_ms && i < 60); ++i) {
      add(time_of(draw_ours), result.ours, result.ours_cpu);
      if (peer_) add(time_of(draw_peer), result.peer, result.peer_cpu);
      spent += result.ours.back() + (peer_ ? result.peer.back() : 0);
      if (settings_.quick && spent > 700 && i >= 2) break;
    }
    result.peak_memory_mb = peak_memory();
    print_row(result);
    if (settings_.stats) std::cerr << to_json(ours_->statistics()).dump(1) << '\n';
    results_.push_back(std::move(result));
  }

  static void add(Time time, std::vector<double>& wall, std::vector<double>& cpu) {
    wall.push_back(time.wall);
    cpu.push_back(time.cpu);
  }

  const Settings& settings_;
  int threads_;
  Image<Rgb8> texture_image_;
  Image<Rgb8> normal_image_;
  Texture texture_;
  Texture normal_map_;
  std::unique_ptr<Peer> peer_;
  std::unique_ptr<Ours> ours_;
  std::vector<Result> results_;
};

/// In a process of its own, because llvmpipe reads its settings once; both sides get `threads`
/// cores.
std::vector<Result> run_with(const Settings& settings, int threads) {
  const std::string file = settings.out + "/threads_" + std::to_string(threads) + ".json";
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    const int status = run_guarded("bench_engine", [&] {
      std::ofstream(file) << to_json(Bench(settings, threads).run()).dump(1) << '\n';
      return 0;
    });
    std::cout.flush();
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("the measurement with " + std::to_string(threads) +
                             " threads did not end well");
  }
  std::vector<Result> results = from_json(nlohmann::json::parse(std::ifstream(file)));
  std::filesystem::remove(file);
  return results;
}

void compare_exactly(const Settings& settings, Result& result) {
  Settings again = settings;
  again.scene = result.scene;
  again.shading = result.shading;
  again.exact_peer = true;
  result.exact_color_difference = run_with(again, result.threads).front().color_difference;
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app{"The engine against Mesa's llvmpipe: the same scenes, turn by turn", "bench_engine"};
  app.add_flag("--quick", settings.quick, "fewer repetitions: ends within 3 minutes");
  app.add_option("--out", settings.out, "folder for results.json and index.html");
  app.add_option("--scene", settings.scene, "only this scene");
  app.add_option("--shading", settings.shading, "only this shading");
  app.add_option("--threads", settings.threads, "thread counts to measure")->delimiter(',');
  app.add_option("--simd", settings.simd, "instruction set of our side");
  app.add_option("--without", settings.without, "what our side doesn't skip")
      ->delimiter(',')
      ->check(CLI::IsMember(names_of_skips()));
  app.add_option("--width", settings.width, "of the picture");
  app.add_option("--height", settings.height, "of the picture");
  app.add_option("--repeat", settings.repeat, "repetitions of each measurement");
  app.add_flag("--ours-only", settings.ours_only, "leave the peer out, for profiling");
  app.add_flag("--stats", settings.stats, "print what the engine did and skipped");
  app.add_flag(
      "--scaling", settings.scaling,
      "instead: how time and memory follow threads, what is visible, and size; spreads are "
      "between quartiles, in each value's unit");
  CLI11_PARSE(app, argc, argv);
  std::filesystem::create_directories(settings.out);
  if (settings.scaling) {
    std::ofstream(settings.out + "/scaling.json") << to_json(measure_scaling()).dump(1) << '\n';
    return 0;
  }
  if (*std::max_element(settings.threads.begin(), settings.threads.end()) > core_count()) {
    std::cout << "There are more threads than cores for them (" << core_count()
              << "): they take turns.\n";
  }
  print_header();
  std::vector<Result> results;
  for (const int threads : settings.threads) {
    std::vector<Result> part = run_with(settings, threads);
    for (Result& result : part) {
      if (result.color_difference > difference_limit) compare_exactly(settings, result);
    }
    results.insert(results.end(), part.begin(), part.end());
  }
  print_summary(results);
  std::ofstream(settings.out + "/results.json") << to_json(results).dump(1) << '\n';
  std::ofstream(settings.out + "/index.html") << to_html(results);
  return 0;
}

}  // namespace

}  // namespace rasterlab::bench

int main(int argc, char** argv) {
  return rasterlab::run_guarded("bench_engine", [&] { return rasterlab::bench::run(argc, argv); });
}
