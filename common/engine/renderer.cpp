#include "common/engine/renderer.h"

#include "common/engine/compiled_simd_targets.h"
#include "common/engine/kernels.h"
#include "common/engine/thread_team.h"
#include "common/image/check.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <numeric>

namespace rasterlab {

#define RASTERLAB_DECLARE_KERNELS(simd) \
  namespace simd_##simd {               \
    extern const EngineKernels kernels; \
  }
RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_DECLARE_KERNELS)
#undef RASTERLAB_DECLARE_KERNELS

namespace {

const EngineKernels& kernels_for(SimdTarget target) {
  switch (target) {
#define RASTERLAB_CASE(simd) \
  case SimdTarget::simd:     \
    return simd_##simd::kernels;
    RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_CASE)
#undef RASTERLAB_CASE
    default:
      throw InputError("this build of the engine is not for " + std::string(name_of(target)));
  }
}

int thread_count(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

/// The threads, and what each has of its own.
class Renderer::Threads {
 public:
  explicit Threads(const EngineOptions& options)
      : team(thread_count(options.threads), options.pin_threads),
        workers(static_cast<std::size_t>(team.size())) {}

  /// Calls `work(item, worker)` for items 0 … count − 1 in no order; a worker has one caller at a
  /// time.
  template <class Work>
  void for_each(int count, const Work& work) {
    team.for_each(count, [&](int item, int member) {
      work(item, workers[static_cast<std::size_t>(member)]);
    });
  }

  ThreadTeam team;
  std::vector<Worker> workers;
};

namespace {

/// One draw call on its way.
template <class Threads>
class Drawing {
 public:
  Drawing(const DrawJob& job, const EngineKernels& kernels, Threads& threads)
      : job_(job), kernels_(kernels), threads_(threads) {}

  void run() {
    for (Worker& worker : threads_.workers) worker.begin(job_.frame.tile_count());
    find_visible();
    sort_front_to_back();
    for (std::size_t begin = 0;;) {
      const std::size_t end = std::min(begin + batch_size, visible_.size());
      draw_batch({visible_.data() + begin, end - begin}, end == visible_.size());
      if (end == visible_.size()) break;
      begin = end;
    }
  }

 private:
  static constexpr std::uint32_t clusters_per_task = 256;
  /// Clusters; what a batch draws hides much of the next ones. With fewer, tiles would be fetched
  /// more often.
  static constexpr std::size_t batch_size = 256;
  /// What is worth fetching a tile's memory for (TileBin::worth); with less it waits.
  static constexpr std::uint32_t enough_for_a_tile = 192;
  /// What bins may hold, in bytes, before every tile is drawn.
  static constexpr std::size_t most_binned = std::size_t{16} << 20U;

  void find_visible() {
    const auto count = static_cast<std::uint32_t>(job_.mesh->clusters().list.size());
    const auto tasks = static_cast<int>((count + clusters_per_task - 1) / clusters_per_task);
    std::vector<std::vector<VisibleCluster>> found(static_cast<std::size_t>(tasks));
    threads_.for_each(tasks, [&](int task, Worker& worker) {
      const std::uint32_t begin = static_cast<std::uint32_t>(task) * clusters_per_task;
      kernels_.find_visible(job_, begin, std::min(begin + clusters_per_task, count),
                            found[static_cast<std::size_t>(task)], worker.statistics);
    });
    for (const auto& part : found) visible_.insert(visible_.end(), part.begin(), part.end());
  }

  /// Roughly, by distributing them over classes of depth: the order changes no pixel, and an exact
  /// one hides hardly more.
  void sort_front_to_back() {
    if (!job_.skip.front_to_back) return;
    // Nothing is nearer than 1. Of positive floats the bits are in the order of the numbers.
    const auto depth_bits = [](const VisibleCluster& c) {
      return std::bit_cast<std::uint32_t>(std::min(c.nearest, 1.0F));
    };
    const auto [far, near] = std::minmax_element(
        visible_.begin(), visible_.end(), [&](const VisibleCluster& a, const VisibleCluster& b) {
          return depth_bits(a) < depth_bits(b);
        });
    if (far == near) return;
    const std::uint32_t nearest = depth_bits(*near);
    constexpr std::uint64_t classes = 4096;
    const std::uint64_t range = std::uint64_t{nearest} - depth_bits(*far) + 1;
    const auto class_of = [&](const VisibleCluster& c) {
      return static_cast<std::size_t>((nearest - depth_bits(c)) * classes / range);
    };
    std::vector<std::uint32_t> end(classes + 1);
    for (const VisibleCluster& c : visible_) ++end[class_of(c) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<VisibleCluster> sorted(visible_.size());
    for (const VisibleCluster& c : visible_) sorted[end[class_of(c)]++] = c;
    visible_ = std::move(sorted);
  }

  void draw_batch(std::span<const VisibleCluster> clusters, bool last) {
    constexpr std::size_t per_task = 8;  // few enough that threads end at the same time
    const auto tasks = static_cast<int>((clusters.size() + per_task - 1) / per_task);
    threads_.for_each(tasks, [&](int task, Worker& worker) {
      const std::size_t begin = static_cast<std::size_t>(task) * per_task;
      kernels_.bin_clusters(
          job_, clusters.subspan(begin, std::min(per_task, clusters.size() - begin)), worker);
    });
    const bool every_tile = last || bytes_binned() > most_binned;
    const std::uint32_t enough = last && !job_.skip.untouched_tiles ? 0
                                 : every_tile                       ? 1
                                                                    : enough_for_a_tile;
    threads_.for_each(job_.frame.tile_count(), [&](int index, Worker& worker) {
      const bool passing = last && is_passing(index);
      const Tile tile = tile_to_draw(index, passing, worker);
      if (worth_drawing(index) >= enough) draw_tile(tile, worker);
      if (!last) return;
      finish_tile(tile, worker);
      if (passing && was_drawn(index)) leave(tile, worker);
    });
    if (!every_tile) return;
    for (Worker& worker : threads_.workers) worker.arena.reset();
  }

  std::size_t bytes_binned() const {
    std::size_t bytes = 0;
    for (const Worker& worker : threads_.workers) bytes += worker.arena.bytes();
    return bytes;
  }

  std::uint32_t worth_drawing(int tile) const {
    std::uint32_t worth = 0;
    for (Worker& worker : threads_.workers) worth += worker.bin(tile).worth;
    return worth;
  }

  bool was_drawn(int tile) const { return job_.frame.drawn()[tile] != FrameAccess::not_drawn; }

  /// Whether a tile that is drawn now, at last, can do without the framebuffer's memory.
  bool is_passing(int tile) const {
    return job_.keep != Keep::everything && job_.skip.unwanted_depth && !was_drawn(tile);
  }

  /// A tile with no more than what is wanted of it.
  Tile tile_to_draw(int index, bool passing, Worker& worker) const {
    Tile tile = passing ? job_.frame.tile_in(worker.passing_tile, index) : job_.frame.tile(index);
    if (job_.wants_depth_only()) tile.key = nullptr;
    if (passing && job_.spares_undisputed_blocks()) {
      tile.undisputed = &worker.passing_tile.undisputed;
    }
    return tile;
  }

  void draw_tile(const Tile& tile, Worker& worker) {
    job_.frame.prepare(tile);
    if (job_.colors_blocks()) {
      give_background(tile.index);
      job_.frame.color_state(tile.index) = FrameAccess::picture;
    }
    kernels_.draw_tile(job_, tile, threads_.workers, worker);
    for (Worker& from : threads_.workers) from.bin(tile.index) = {};
  }

  /// Where there is no picture yet; it may be there already.
  void give_background(int tile) const {
    const std::uint8_t there = job_.frame.color_state(tile);
    const bool skips = there == FrameAccess::background && job_.skip.untouched_tiles;
    if (there != FrameAccess::picture && !skips) job_.frame.fill_background(tile);
  }

  void finish_tile(const Tile& tile, Worker& worker) {
    const bool drawn = was_drawn(tile.index);
    ++(drawn ? worker.statistics.tiles_drawn : worker.statistics.tiles_untouched);
    if (job_.shading == nullptr) return;
    const bool all_drawn = drawn && job_.frame.tile_far(tile.index) > 0;
    if (!all_drawn) give_background(tile.index);
    if (!drawn) return;
    if (!job_.colors_blocks()) job_.shading->shade_tile(job_, tile, worker);
    job_.frame.color_state(tile.index) = FrameAccess::picture;
  }

  /// What of a passing tile is wanted goes to the framebuffer.
  void leave(const Tile& tile, Worker& worker) {
    ++worker.statistics.tiles_not_kept;
    if (tile.undisputed != nullptr) {
      worker.statistics.blocks_undisputed += static_cast<unsigned>(tile.undisputed->count());
    }
    if (job_.keep != Keep::depth) return;
    kernels_.write_depth(tile, job_.frame.tile(tile.index).depth);
  }

  const DrawJob& job_;
  const EngineKernels& kernels_;
  Threads& threads_;
  std::vector<VisibleCluster> visible_;
};

std::uint32_t take_keys(FrameAccess& frame, std::size_t triangles) {
  constexpr std::size_t limit = std::size_t{1} << 31U;
  if (frame.keys_used() + triangles + 1 >= limit) {
    throw CheckError("more than 2^31 triangles were drawn into a framebuffer since it was cleared");
  }
  const std::uint32_t first = frame.keys_used() + 1;
  frame.keys_used() += static_cast<std::uint32_t>(triangles);
  return first;
}

Cull cull_in_picture(const DrawCall& call) {
  if (!call.mirrored || call.cull == Cull::none) return call.cull;
  return call.cull == Cull::back ? Cull::front : Cull::back;
}

}  // namespace

Renderer::Renderer(const EngineOptions& options)
    : options_(options), threads_(std::make_unique<Threads>(options)) {
  simd_target(name_of(options.simd));
}

Renderer::~Renderer() = default;

Statistics Renderer::draw(const DrawCall& call, Framebuffer& frame) {
  if (call.mesh == nullptr) throw CheckError("a draw call without a mesh");
  const auto start = std::chrono::steady_clock::now();
  const EngineKernels& kernels = kernels_for(options_.simd);
  FrameAccess access(frame);
  if (access.kept() != Keep::everything) {
    throw CheckError("the draw call before did not keep everything: clear the framebuffer first");
  }
  const std::uint32_t first_key = take_keys(access, call.mesh->mesh().triangles.size());
  const DrawJob job = {call.mesh,
                       ClipTransform(call.matrix, frame.width(), frame.height()),
                       cull_in_picture(call),
                       call.mirrored,
                       options_.skip,
                       call.keep,
                       first_key,
                       call.shading.shader,
                       call.shading.kernels[static_cast<std::size_t>(options_.simd)],
                       access};
  for (Worker& worker : threads_->workers) worker.statistics = {};
  access.kept() = Keep::color;  // should a shader throw, depth is there only in part
  if (frame.width() > 0 && frame.height() > 0) {
    std::optional<StayOnCore> on_core;
    threads_->team.stay(on_core);
    Drawing(job, kernels, *threads_).run();
  }
  access.kept() = call.keep;
  Statistics total;
  for (const Worker& worker : threads_->workers) total += worker.statistics;
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  total.milliseconds = time.count();
  return total;
}

}  // namespace rasterlab
