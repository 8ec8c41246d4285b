// Meshes and viewpoints from which every stage's pictures are compared with the ray caster.
#pragma once

#include "tests/oracle/picture.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterlab::oracle {

struct GeometryCase {
  std::string name;
  std::string mesh;  ///< as --mesh takes it
  Viewpoint viewpoint = {};
  int width = 96;
  int height = 72;
  Cull cull = Cull::none;
};

inline std::string cull_name(Cull cull) {
  if (cull == Cull::none) return "none";
  return cull == Cull::back ? "back" : "front";
}

inline void PrintTo(const GeometryCase& geometry, std::ostream* stream) {
  *stream << geometry.mesh << " " << testing::PrintToString(geometry.viewpoint.flags())
          << " --cull " << cull_name(geometry.cull);
}

/// The built-in meshes from outside and inside, near and far, in every projection and culling.
std::vector<GeometryCase> built_in_cases();

/// Files no one here wrote: the bunny and what reads of assimp's test models, framed from a
/// three-quarter view. Files that are not there, or that read_mesh() refuses, are left out and
/// named on standard output.
std::vector<GeometryCase> foreign_cases();

/// A mesh framed from a three-quarter view; vertices without a face do not count.
GeometryCase framed(const std::string& name, const std::filesystem::path& file, const Mesh& mesh);

/// Takes the picture with a stage and compares each pixel's face and distance with the ray
/// caster's.
Agreement expect_geometry(const std::string& stage, const GeometryCase& geometry,
                          const std::vector<std::string>& more_flags = {});

/// For INSTANTIATE_TEST_SUITE_P.
template <class Info>
std::string case_name(const Info& info) {
  return info.param.name;
}

}  // namespace rasterlab::oracle
