// Depth and attributes against 128-bit arithmetic.
#include "common/engine/renderer.h"
#include "common/triangles/rasterize.h"

#include "tests/engine/encode_shader.h"

#include <random>
#include <vector>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

__extension__ using Exact = __float128;

constexpr int size = 48;

/// One triangle given by its corners in clip space, and how to draw it: positions are the first
/// three corners' own, since three corners can be anything to a 4 × 4 matrix.
struct Case {
  std::array<Eigen::Vector4f, 3> clip;
  std::array<float, 3> attribute;
};

class Random {
 public:
  float number(float low, float high) {
    return low + (high - low) * static_cast<float>(generator_() >> 8U) / 16777216.0F;
  }
  bool chance(float part) { return number(0, 1) < part; }

 private:
  std::mt19937 generator_{20};
};

/// Window positions in and around the picture, a third of them slivers; w over `w_ratio`.
Case random_case(Random& random, float w_ratio) {
  Case result;
  Eigen::Vector2f first;
  Eigen::Vector2f second;
  for (std::size_t i = 0; i < 3; ++i) {
    Eigen::Vector2f ndc(random.number(-1.5F, 1.5F), random.number(-1.5F, 1.5F));
    if (i == 2 && random.chance(0.33F)) {
      const float t = random.number(-0.5F, 1.5F);
      ndc = first + t * (second - first) +
            Eigen::Vector2f(random.number(-0.03F, 0.03F), random.number(-0.03F, 0.03F));
    }
    (i == 0 ? first : second) = ndc;
    const float w = std::exp(random.number(0, std::log(w_ratio)));
    result.clip[i] = Eigen::Vector4f(ndc.x() * w, ndc.y() * w, w - 2 * random.number(0, 1), w);
    result.attribute[i] = random.number(0, 1);
  }
  return result;
}

/// A mesh whose vertex i is the unit vector i, and the matrix that takes it to the corner: each
/// clip coordinate is then exactly the one given.
const Mesh& unit_mesh() {
  static const Mesh mesh = {.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            .normals = {},
                            .colors = {},
                            .texture_coordinates = {},
                            .triangles = {{0, 1, 2}}};
  return mesh;
}
Eigen::Matrix4f matrix_of(const Case& c) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 3; ++i) matrix.col(i) = c.clip[static_cast<std::size_t>(i)];
  return matrix;
}

struct Errors {
  double attribute = 0;
  double depth = 0;  ///< over the largest corner's
  int pixels = 0;
};

TriangleEdges edges_of(const Case& c) {
  std::array<Eigen::Vector2f, 3> window;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector4f& p = c.clip[i];
    window[i] = {(p.x() / p.w() + 1) * (size / 2.0F), (1 - p.y() / p.w()) * (size / 2.0F)};
  }
  return make_edges(snap(window));
}

void measure(const Case& c, Renderer& renderer, const PreparedMesh& mesh, Errors& errors) {
  const EncodeShader shader = {c.attribute};
  Framebuffer frame(size, size);
  renderer.draw({.mesh = &mesh, .matrix = matrix_of(c), .shading = shading(shader)}, frame);
  const Image<float> depth = frame.depth();
  const Image<std::int32_t> ids = frame.ids();
  std::array<Exact, 3> corner_depth;
  Exact largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector4f& p = c.clip[i];
    corner_depth[i] = (static_cast<Exact>(p.w()) - p.z()) / 2 / p.w();
    largest = std::max(largest, corner_depth[i]);
  }
  const TriangleEdges edges = edges_of(c);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (ids(x, y) < 0) continue;
      std::array<Exact, 3> b;
      Exact sum = 0;
      Exact z = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto e = static_cast<Exact>(edges.edges[i].at(x, y));
        z += e * corner_depth[i] / edges.twice_area;
        b[i] = e / c.clip[i].w();
        sum += b[i];
      }
      Exact value = 0;
      for (std::size_t i = 0; i < 3; ++i) value += b[i] / sum * c.attribute[i];
      const Rgb8& pixel = frame.color()(x, y);
      const double attribute_error =
          std::abs(static_cast<double>(decode(pixel.r, pixel.g, pixel.b) - value));
      const double depth_error =
          std::abs(static_cast<double>((static_cast<Exact>(depth(x, y)) - z) / largest));
      errors.attribute = std::max(errors.attribute, attribute_error);
      errors.depth = std::max(errors.depth, depth_error);
      ++errors.pixels;
    }
  }
}

TEST(engine_precision, depth_and_attributes_against_float128) {
  Random random;
  Renderer renderer({.threads = 1, .skip = {}});
  const PreparedMesh mesh(unit_mesh());
  for (const float w_ratio : {1.0F, 10.0F, 1e5F}) {
    Errors errors;
    for (int i = 0; i < 6000; ++i) measure(random_case(random, w_ratio), renderer, mesh, errors);
    EXPECT_GT(errors.pixels, 500000);
    // The picture's 24 bits add half of 2^-24.
    EXPECT_LE(errors.attribute, 2.4e-7 + 3e-8) << "w ratio " << w_ratio;
    EXPECT_LE(errors.depth, 3e-7) << "w ratio " << w_ratio;
    RecordProperty("attribute_error_w_" + std::to_string(static_cast<int>(w_ratio)),
                   std::to_string(errors.attribute * 1e7) + "e-7");
    RecordProperty("depth_error_w_" + std::to_string(static_cast<int>(w_ratio)),
                   std::to_string(errors.depth * 1e7) + "e-7");
    std::printf("w ratio %g: attribute error %.3g, depth error %.3g over %d pixels\n",
                static_cast<double>(w_ratio), errors.attribute, errors.depth, errors.pixels);
  }
}

/// An attribute's derivative, and what its float may be off: so much of the sizes of the products
/// it is the sum of.
struct Slope {
  int x, y;
  double exact;
  double allowed;
};

/// In the pixels that see the triangle. With q = E · w0 / w and Q their sum, the attribute a grows
/// by (q1' (a1 − a0) + q2' (a2 − a0) − (a − a0) Q') / Q.
std::vector<Slope> slopes_of(const Case& c, bool down, const Image<std::int32_t>& ids) {
  const TriangleEdges edges = edges_of(c);
  const auto size_of = [](Exact a) { return a < 0 ? -a : a; };
  std::vector<Slope> slopes;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (ids(x, y) < 0) continue;
      Exact sum = 0;
      Exact growth_of_sum = 0;
      Exact beyond_first = 0;
      Exact growth = 0;
      Exact products = 0;
      Exact steps = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& edge = edges.edges[i];
        const auto here = static_cast<Exact>(edge.at(x, y));
        const Exact step = static_cast<Exact>(down ? edge.at(x, y + 1) : edge.at(x + 1, y)) - here;
        const Exact ratio = static_cast<Exact>(c.clip[0].w()) / c.clip[i].w();
        const Exact difference = static_cast<Exact>(c.attribute[i]) - c.attribute[0];
        sum += here * ratio;
        growth_of_sum += step * ratio;
        beyond_first += here * ratio * difference;
        growth += step * ratio * difference;
        products += size_of(step * ratio * difference);
        if (i > 0) steps += size_of(step) + size_of(step * ratio);
      }
      beyond_first /= sum;
      products += size_of(beyond_first) * steps;
      // Ratios, steps, products and sums: each rounded by 2^-24 of a product at most.
      slopes.push_back({x, y, static_cast<double>((growth - beyond_first * growth_of_sum) / sum),
                        static_cast<double>(products / sum) * 4 * 0x1p-24});
    }
  }
  return slopes;
}

TEST(engine_precision, derivatives_against_float128) {
  const PreparedMesh mesh(unit_mesh());
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    Random random;
    Renderer renderer({.threads = 1, .simd = simd, .skip = {}});
    int pixels = 0;
    for (int i = 0; i < 600; ++i) {
      const Case c = random_case(random, i % 2 == 0 ? 10.0F : 1e5F);
      const bool down = i % 4 < 2;
      const auto draw = [&](float scale) {
        const EncodeDerivativeShader shader = {{c.attribute}, down, scale};
        Framebuffer frame(size, size);
        renderer.draw({.mesh = &mesh, .matrix = matrix_of(c), .shading = shading(shader)}, frame);
        return frame;
      };
      const std::vector<Slope> slopes = slopes_of(c, down, draw(1).ids());
      double steepest = 0;
      for (const Slope& slope : slopes) steepest = std::max(steepest, std::abs(slope.exact));
      if (steepest == 0) continue;
      const auto scale = static_cast<float>(0.99 / steepest);
      const Framebuffer frame = draw(scale);
      for (const Slope& slope : slopes) {
        const Rgb8& pixel = frame.color()(slope.x, slope.y);
        const double found =
            (2 * decode(pixel.r, pixel.g, pixel.b) - 1) / static_cast<double>(scale);
        // Scaled, the sum with 1, and the picture's 24 bits add 2^-22 of what 1 stands for.
        ASSERT_NEAR(found, slope.exact, slope.allowed + steepest * 0x1p-22)
            << "triangle " << i << ", pixel " << slope.x << ", " << slope.y;
        ++pixels;
      }
    }
    EXPECT_GT(pixels, 50000);
  }
}

/// Each product is rounded once, and exponent − 1 of them are in the result.
TEST(engine_precision, whole_powers_against_float128) {
  const Case cover = {{{{-4, -4, 0, 1}, {4, -4, 0, 1}, {0, 4, 0, 1}}}, {}};
  const PreparedMesh mesh(unit_mesh());
  Random random;
  for (const SimdTarget simd : supported_simd_targets()) {
    SCOPED_TRACE(name_of(simd));
    Renderer renderer({.threads = 1, .simd = simd, .skip = {}});
    for (const int exponent : {0, 1, 2, 7, 10, 128, 1000, 1024}) {
      for (const float low : {0.0F, 0.5F, 0.99F, 1.0F}) {
        const float base = random.number(low, 1);
        const UniformPowerShader shader = {base, static_cast<float>(exponent)};
        Framebuffer frame(8, 8);
        renderer.draw({.mesh = &mesh, .matrix = matrix_of(cover), .shading = shading(shader)},
                      frame);
        Exact power = 1;
        for (int i = 0; i < exponent; ++i) power *= base;
        const Rgb8& pixel = frame.color()(4, 4);
        const auto error = static_cast<double>(decode(pixel.r, pixel.g, pixel.b) - power);
        EXPECT_LE(std::abs(error), exponent * 0x1p-24 * static_cast<double>(power) + 0x1.8p-24)
            << base << " to the power of " << exponent;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab
