// Takes pictures with the stages' executables, as a user would, and compares them with the ray
// caster.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

#include "tests/oracle/ray_caster.h"
#include "tests/support/scratch.h"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace rasterlab::oracle {

/// What the flags of cli.md say about a camera, and the ray caster's own idea of them.
struct Viewpoint {
  Eigen::Vector3d eye{1.6, 1.2, 2.4};
  Eigen::Vector3d center{0, 0, 0};
  Eigen::Vector3d up{0, 1, 0};
  double fovy = 40;
  double near = 0.1;
  double far = 20;
  std::optional<double> ortho = {};  ///< height of the view; in place of fovy

  std::vector<std::string> flags() const;
  Camera camera(int width, int height) const;
};

/// A picture a stage took, with what it says about every pixel.
struct Picture {
  Image<Rgb8> color;
  Image<float> distance;  ///< along the view axis
  Image<float> ids;       ///< index of the face, −1 for none
};

/// Runs `stage --mesh MESH --size WxH FLAGS`. Throws std::runtime_error with what it printed when
/// it fails.
Picture take_picture(const std::string& stage, const std::string& mesh, int width, int height,
                     const std::vector<std::string>& flags);

/// The pictures that an exercise of a stage writes, at the size they have by themselves or another.
class Figures {
 public:
  /// Runs `stage --exercise ID FLAGS`. Throws std::runtime_error with what it printed when it
  /// fails.
  Figures(const std::string& stage, const std::string& exercise,
          const std::vector<std::string>& flags = {});

  /// Of "04.4_cube.png".
  Image<Rgb8> operator()(const std::string& file) const;

 private:
  ScratchFolder folder_;
};

/// How a picture agrees with the witness.
struct Agreement {
  int compared = 0;   ///< pixels farther than 1/128 px from every visible edge
  int near_edge = 0;  ///< the others, which are not compared
  int crossing = 0;   ///< another face than the witness's, but one that crosses it within 1/128 px
  int drawn = 0;      ///< compared pixels where the witness sees a face
  int snapping = 0;   ///< right only with a corner of their face snapped the other way of a tie
  int wrong = 0;      ///< compared pixels that differ
  std::string first_faults;

  void add_fault(const std::string& what);
};

std::ostream& operator<<(std::ostream& stream, const Agreement& agreement);

/// Compares face and distance of every pixel.
Agreement compare_geometry(const RayCaster& witness, const Picture& picture);

/// "1.5,0,-2" for a flag, with all digits of a double.
std::string comma_separated(const Eigen::Vector3d& vector);

}  // namespace rasterlab::oracle
