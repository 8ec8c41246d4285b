// Matrices as text.
#pragma once

#include <sstream>
#include <string>

#include <Eigen/Dense>

namespace rasterlab {

/// A row a line, columns aligned.
template <class Matrix>
std::string text_of(const Matrix& matrix) {
  std::ostringstream text;
  text << matrix.format(Eigen::IOFormat(6, 0, "  ", "\n", "  ")) << "\n";
  return text.str();
}

}  // namespace rasterlab
