#include "bench/texture/attribute_rows.h"

#include "common/engine/simd.h"

#include <algorithm>

namespace rasterlab::bench::RASTERLAB_SIMD {
namespace {

using namespace rasterlab::RASTERLAB_SIMD;  // Number, Doubles, load(), store()

/// u/w, v/w and 1/w of as many pixels as there are lanes, or any multiple of all three.
struct OverW {
  Number u, v, one;
};

Number at(const Plane& plane, Number x, Number y) {
  return Number(plane.a) * x + (Number(plane.b) * y + Number(plane.c));
}

OverW at(const std::array<Plane, 3>& planes, Number x, Number y) {
  return {at(planes[0], x, y), at(planes[1], x, y), at(planes[2], x, y)};
}

// ---- Where the values over w come from

struct FromOrigin {
  static OverW evaluate(const AttributeRow& row, Number pixel) {
    return at(row.from_origin, Number(row.x) + pixel, Number(row.y));
  }
};

struct FromTile {
  static OverW evaluate(const AttributeRow& row, Number pixel) {
    return at(row.from_tile, Number(row.x_in_tile) + pixel, Number(row.y_in_tile));
  }
};

/// Weights from edge functions, which are whole numbers that doubles hold exactly.
struct FromIntegers {
  static OverW evaluate(const AttributeRow& row, Number pixel) {
    const Doubles step = to_doubles(pixel);
    const Doubles e1 = Doubles(row.edge1) + step * Doubles(row.step1);
    const Doubles e2 = Doubles(row.edge2) + step * Doubles(row.step2);
    const Doubles rest = Doubles(row.area) - (e1 + e2);
    const Number q1 = to_number(e1) * Number(row.ratio1);
    const Number q2 = to_number(e2) * Number(row.ratio2);
    const Number q0 = to_number(rest);
    const auto mix = [&](const std::array<float, 3>& corners) {
      return q0 * Number(corners[0]) + (q1 * Number(corners[1]) + q2 * Number(corners[2]));
    };
    return {mix(row.u), mix(row.v), q0 + (q1 + q2)};
  }
};

// ---- How 1/w is turned over

struct Estimate {
  static Number inverse(Number a) { return Number(hn::ApproximateReciprocal(a.v)); }
};

struct Newton {
  static Number inverse(Number a) {
    const Number estimate = Estimate::inverse(a);
    return estimate * (Number(2) - a * estimate);
  }
};

struct Division {
  static Number inverse(Number a) { return Number(1) / a; }
};

template <class Source, class Inverse>
void evaluate_each(const AttributeRow& row, float* u, float* v) {
  for (int first = 0; first < row.count; first += lanes) {
    const OverW over_w = Source::evaluate(row, as_numbers(iota(first)));
    const Number w = Inverse::inverse(over_w.one);
    store(over_w.u * w, u + first);
    store(over_w.v * w, v + first);
  }
}

/// Divides at the ends of runs, and goes straight between them. The last run ends with the row.
template <int run_length>
void evaluate_in_runs(const AttributeRow& row, float* u, float* v) {
  std::array<float, AttributeRow::most + 16> end_at{};
  std::array<float, AttributeRow::most + 16> end_u{};
  std::array<float, AttributeRow::most + 16> end_v{};
  const int last = row.count - 1;
  const int runs = (last + run_length - 1) / run_length;
  for (int i = 0; i <= runs + lanes; ++i) {
    end_at[static_cast<std::size_t>(i)] = static_cast<float>(std::min(i * run_length, last));
  }
  for (int first = 0; first <= runs; first += lanes) {
    const OverW over_w = FromTile::evaluate(row, load(end_at.data() + first));
    store(over_w.u / over_w.one, end_u.data() + first);
    store(over_w.v / over_w.one, end_v.data() + first);
  }
  u[last] = end_u[static_cast<std::size_t>(runs)];
  v[last] = end_v[static_cast<std::size_t>(runs)];
  for (int run = 0; run < runs; ++run) {
    const auto i = static_cast<std::size_t>(run);
    const int begin = run * run_length;
    const int end = std::min(begin + run_length, last);
    const float part = 1 / static_cast<float>(end - begin);
    const float step_u = (end_u[i + 1] - end_u[i]) * part;
    const float step_v = (end_v[i + 1] - end_v[i]) * part;
    for (int x = begin; x < end; ++x) {
      u[x] = end_u[i] + static_cast<float>(x - begin) * step_u;
      v[x] = end_v[i] + static_cast<float>(x - begin) * step_v;
    }
  }
}

constexpr const char* far_origin = "large terms cancel, and take the digits along";
constexpr const char* estimated = "as good as the processor's estimate: 12 to 14 bits";

constexpr AttributeRung all_rungs[] = {
    {"plane at origin, estimate", &evaluate_each<FromOrigin, Estimate>, 0, estimated},
    {"plane at origin, + Newton", &evaluate_each<FromOrigin, Newton>, 0, far_origin},
    {"plane at origin, division", &evaluate_each<FromOrigin, Division>, 0, far_origin},
    {"plane at tile, estimate", &evaluate_each<FromTile, Estimate>, 0, estimated},
    {"plane at tile, + Newton", &evaluate_each<FromTile, Newton>, 0, "a few last bits"},
    {"plane at tile, division", &evaluate_each<FromTile, Division>, 0, "a few last bits"},
    {"integers, estimate", &evaluate_each<FromIntegers, Estimate>, 0, estimated},
    {"integers, + Newton", &evaluate_each<FromIntegers, Newton>, 0, "a few last bits"},
    {"integers, division", &evaluate_each<FromIntegers, Division>, 0, "a few last bits"}};

constexpr AttributeRung runs[] = {
    {"runs of 32", &evaluate_in_runs<32>, 32, "straight between two exact pixels"},
    {"runs of 16", &evaluate_in_runs<16>, 16, "straight between two exact pixels"},
    {"runs of 8", &evaluate_in_runs<8>, 8, "straight between two exact pixels"},
    {"each pixel", &evaluate_each<FromTile, Division>, 0, "none"}};

}  // namespace

std::span<const AttributeRung> attribute_rungs() {
  return all_rungs;
}
std::span<const AttributeRung> affine_rungs() {
  return runs;
}

}  // namespace rasterlab::bench::RASTERLAB_SIMD
