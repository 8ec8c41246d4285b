#include "tests/oracle/picture.h"

#include "common/image/files.h"

#include "tests/support/process.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rasterlab::oracle {

namespace {

std::string number(double value) {
  if (std::isinf(value)) return "inf";
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

/// The corners of a triangle are snapped to 1/256 px, so its pixels show what lies up to 1/512 px
/// beside them; a little more for the single precision of the corners before they are snapped.
constexpr double snapping = 1.0 / 512 + 1.0 / 4096;

/// How much a distance may differ at a pixel: what the snapping and single precision explain.
double distance_tolerance(const RayCaster& witness, double x, double y, const Hit& hit) {
  double tolerance = 4e-6 * hit.distance;
  for (const double dx : {-snapping, snapping}) {
    for (const double dy : {-snapping, snapping}) {
      const double beside = witness.cast_plane(x + dx, y + dy, hit.face).distance;
      tolerance = std::max(tolerance, std::abs(beside - hit.distance) + 4e-6 * hit.distance);
    }
  }
  return tolerance;
}

std::string geometry_fault(const RayCaster& witness, double x, double y, const Hit& hit, int id,
                           double distance, Agreement& agreement) {
  Hit expected = hit;
  if (id != hit.face) {
    const bool both = id >= 0 && hit.face >= 0;
    const bool crosses = both && witness.covers(x, y, id) &&
                         witness.crossing_distance(x, y, id, hit.face) <= 1.0 / 128;
    if (!crosses) {
      std::ostringstream fault;
      fault << "face " << id << ", expected " << hit.face;
      return fault.str();
    }
    ++agreement.crossing;
    expected = witness.cast_plane(x, y, id);
  }
  if (id < 0) return std::isinf(distance) ? "" : "distance " + number(distance) + " of nothing";
  const double error = std::abs(distance - expected.distance);
  if (error <= distance_tolerance(witness, x, y, expected)) return "";
  return "distance " + number(distance) + ", expected " + number(expected.distance) + " ± " +
         number(distance_tolerance(witness, x, y, expected));
}

void run(const std::vector<std::string>& command) {
  const ProcessResult result = run_process(command);
  if (result.exit_status == 0) return;
  std::string line;
  for (const std::string& word : command) line += word + " ";
  throw std::runtime_error(line + "exited with " + std::to_string(result.exit_status) + ": " +
                           result.err);
}

}  // namespace

std::string comma_separated(const Eigen::Vector3d& vector) {
  return number(vector.x()) + "," + number(vector.y()) + "," + number(vector.z());
}

std::vector<std::string> Viewpoint::flags() const {
  std::vector<std::string> all{"--eye", comma_separated(eye), "--center", comma_separated(center),
                               "--up",  comma_separated(up),  "--near",   number(near),
                               "--far", number(far)};
  all.insert(all.end(), {ortho ? "--ortho" : "--fovy", number(ortho.value_or(fovy))});
  return all;
}

Camera Viewpoint::camera(int width, int height) const {
  const double aspect = static_cast<double>(width) / height;
  return {.view = look_at(eye, center, up),
          .projection = ortho ? orthographic(*ortho, aspect, near, far)
                              : perspective(fovy, aspect, near, far)};
}

Picture take_picture(const std::string& stage, const std::string& mesh, int width, int height,
                     const std::vector<std::string>& flags) {
  const ScratchFolder scratch;
  std::vector<std::string> command{program(stage),
                                   "--mesh",
                                   mesh,
                                   "--size",
                                   std::to_string(width) + "x" + std::to_string(height),
                                   "--out",
                                   scratch / "picture.ppm",
                                   "--depth",
                                   scratch / "distance.pfm",
                                   "--ids",
                                   scratch / "ids.pfm"};
  command.insert(command.end(), flags.begin(), flags.end());
  run(command);
  return {.color = read_image<Rgb8>(scratch / "picture.ppm"),
          .distance = read_image<float>(scratch / "distance.pfm"),
          .ids = read_image<float>(scratch / "ids.pfm")};
}

Figures::Figures(const std::string& stage, const std::string& exercise,
                 const std::vector<std::string>& flags) {
  std::vector<std::string> command{program(stage), "--exercise", exercise, "--out", folder_.path()};
  command.insert(command.end(), flags.begin(), flags.end());
  run(command);
}

Image<Rgb8> Figures::operator()(const std::string& file) const {
  return read_image<Rgb8>(folder_ / file);
}

void Agreement::add_fault(const std::string& what) {
  ++wrong;
  if (wrong <= 10) first_faults += "  " + what + "\n";
}

std::ostream& operator<<(std::ostream& stream, const Agreement& agreement) {
  return stream << agreement.wrong << " of " << agreement.compared << " pixels differ ("
                << agreement.drawn << " show a face, " << agreement.crossing
                << " where two faces cross, " << agreement.snapping
                << " right with a corner snapped otherwise; " << agreement.near_edge
                << " more lie within 1/128 px of an edge)\n"
                << agreement.first_faults;
}

Agreement compare_geometry(const RayCaster& witness, const Picture& picture) {
  Agreement agreement;
  const std::vector<double> edges = witness.edge_distances();
  for (int y = 0; y < witness.height(); ++y) {
    for (int x = 0; x < witness.width(); ++x) {
      const auto pixel = static_cast<std::size_t>(y * witness.width() + x);
      if (edges[pixel] <= 1.0 / 128) {
        ++agreement.near_edge;
        continue;
      }
      ++agreement.compared;
      const Hit hit = witness.cast(x + 0.5, y + 0.5);
      if (hit.face >= 0) ++agreement.drawn;
      const std::string fault =
          geometry_fault(witness, x + 0.5, y + 0.5, hit, static_cast<int>(picture.ids(x, y)),
                         picture.distance(x, y), agreement);
      if (!fault.empty()) {
        std::ostringstream what;
        what << "(" << x << ", " << y << "): " << fault;
        agreement.add_fault(what.str());
      }
    }
  }
  return agreement;
}

}  // namespace rasterlab::oracle
