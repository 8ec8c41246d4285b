// Shaders that show what they were given, for tests.
#pragma once

#include "common/mesh/shader_types.h"

#include <atomic>
#include <stdexcept>

namespace rasterlab {

/// Normals and positions into colours through everything number.h offers.
struct BusyShader {
  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
    Vector3<Number> position;
  };

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    return {mesh.normals[index], mesh.positions[index]};
  }

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Vector3<Number> normal = normalized(point.value.normal);
    const Number facing = maximum(normal.z(), Number(0));
    const Number shine = power(facing, Number(2.5F)) * power(facing, 10.0F);
    const Number stripes =
        point.value.position.x() * Number(8) - round_down(point.value.position.x() * Number(8));
    const Number slope = log_2(magnitude(point.dx.position.x()) + Number(1e-6F)) * Number(-0.05F);
    return {select(point.front_facing, facing, Number(0.2F)), stripes, minimum(shine, slope)};
  }
};

/// Leaves holes.
struct HolesShader : BusyShader {
  template <class Number>
  Fragment<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Number x = point.value.position.x() * Number(10);
    const Number y = point.value.position.y() * Number(10);
    return {BusyShader::fragment(point),
            x - round_down(x) < Number(0.4F) || y - round_down(y) < Number(0.3F)};
  }
};

/// Reads no derivatives, and says so.
struct QuietShader : BusyShader {
  static constexpr bool reads_derivatives = false;

  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const auto& [normal, position] = point.value;
    return {magnitude(normal.x()), magnitude(normal.y()), magnitude(position.z())};
  }
};

/// The same, but doesn't say so.
struct UndeclaredShader : QuietShader {
  static constexpr bool reads_derivatives = true;
};

/// Knows floats only.
struct PlainShader : BusyShader {
  Vector3<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    return {point.value.position.x(), point.value.position.y(), point.front_facing ? 1.0F : 0.0F};
  }
};

/// Nothing but sums and products, which are the same for any Number.
struct StripesShader : BusyShader {
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Number stripes = point.value.position.x() * Number(8);
    const Number slope = point.dx.position.x() * Number(20) - point.dy.position.y() * Number(30);
    return {stripes - round_down(stripes), slope,
            select(point.front_facing, point.value.normal.z(), Number(0.5F))};
  }
};

/// Of every third triangle the same all over.
struct PatchworkShader : StripesShader {
  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return StripesShader::vertex(mesh, triangle, triangle % 3 == 0 ? 0 : corner);
  }
};

/// StripesShader, but for floats only, and telling how often it was asked.
struct CountingShader : StripesShader {
  std::atomic<int>* fragments;

  explicit CountingShader(std::atomic<int>& count) : fragments(&count) {}

  Vector3<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    ++*fragments;
    return StripesShader::fragment(point);
  }
};

/// Triangle t is grey, t codes bright; of every third one the left half is white instead, and every
/// fifth isn't drawn.
struct NumberedShader {
  template <class Number>
  struct Varyings {
    Number code;
    Number side;
    Number drawn;
  };

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    return {static_cast<float>(triangle), triangle % 3 == 0 ? mesh.positions[index].x() : 1,
            triangle % 5 == 0 ? 0.0F : 1.0F};
  }

  template <class Number>
  Fragment<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Number grey =
        select(point.value.side < Number(0), Number(1), Number(point.value.code / Number(255)));
    return {{grey, grey, grey}, point.value.drawn < Number(0.5F)};
  }
};

/// Fronts and backs have a grey each; the backs of every seventh triangle aren't drawn. The same
/// for corners that differ and for corners that don't.
struct TwoSidedShader {
  bool corners_differ;

  template <class Number>
  struct Varyings {
    Number code;
    Number corner;
  };

  Varyings<float> vertex(const Mesh&, std::uint32_t triangle, int corner) const {
    return {static_cast<float>(triangle % 128), corners_differ ? static_cast<float>(corner) : 0.0F};
  }

  Fragment<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    const float grey = (point.value.code + (point.front_facing ? 0.0F : 128.0F)) / 255;
    const bool seventh = static_cast<int>(point.value.code) % 7 == 0;
    return {{grey, grey, grey}, seventh && !point.front_facing};
  }
};

/// Like an exercise that isn't written.
struct FailingShader : TwoSidedShader {
  Fragment<float> fragment(const SurfacePoint<Varyings, float>&) const {
    throw std::runtime_error("not written");
  }
};

}  // namespace rasterlab
