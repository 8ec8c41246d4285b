// What a draw call did, and what it was spared.
#pragma once

#include <cstdint>

#include <nlohmann/json_fwd.hpp>

namespace rasterlab {

/// Counts of one draw call. Apart from `milliseconds` they don't depend on the number of threads as
/// long as nothing hidden is skipped (what is hidden depends on what was drawn before).
struct Statistics {
  std::uint64_t clusters = 0;
  std::uint64_t clusters_outside = 0;        ///< not in the view
  std::uint64_t clusters_facing_away = 0;    ///< culled as a whole
  std::uint64_t clusters_hidden = 0;         ///< behind what is already drawn
  std::uint64_t vertices = 0;                ///< taken to the window
  std::uint64_t vertices_skipped = 0;        ///< of skipped clusters
  std::uint64_t triangles = 0;               ///< of clusters that were not skipped
  std::uint64_t triangles_culled = 0;        ///< back faces
  std::uint64_t triangles_without_area = 0;  ///< after snapping
  std::uint64_t triangles_missed = 0;  ///< that miss every sample, or that snapping turned over
  std::uint64_t triangles_hidden = 0;  ///< small, behind what earlier batches drew
  std::uint64_t triangles_clipped = 0;
  std::uint64_t triangles_binned = 0;  ///< once per tile
  std::uint64_t blocks_hidden = 0;     ///< 8×8 pixels of a triangle behind what is drawn
  std::uint64_t tiles_drawn = 0;
  std::uint64_t tiles_untouched = 0;
  std::uint64_t tiles_not_kept = 0;     ///< drawn, without their depth ever being in memory
  std::uint64_t blocks_undisputed = 0;  ///< 8×8 pixels that never had a depth for each
  /// As many as are visible; without the skip of hidden fragments, all that were when drawn.
  std::uint64_t pixels_shaded = 0;
  std::uint64_t pixels_asked = 0;  ///< given to a shader to be discarded or drawn
  /// Numbers of varyings' derivatives that the shader says it doesn't read, of shaded pixels, but
  /// for triangles that are the same all over.
  std::uint64_t derivatives_unread = 0;
  std::uint64_t triangles_shaded = 0;  ///< for which vertex() was called: for one or several tiles
  double milliseconds = 0;

  Statistics& operator+=(const Statistics& other);
};

/// An object of the counts, by the names above.
nlohmann::json to_json(const Statistics& statistics);

}  // namespace rasterlab
