#include "bench/engine/peer.h"

#include "common/texture/texture.h"

#include "bench/engine/bench_shaders.h"
#include "bench/engine/pinning.h"

#include <stdexcept>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

namespace rasterlab::bench {

namespace {

const char* const vertex_source = R"(#version 130
uniform mat4 matrix;
in vec3 in_position; in vec3 in_normal; in vec2 in_uv; in vec3 in_tangent;
out vec3 position; out vec3 normal; out vec2 uv; out vec3 tangent; flat out vec3 face_normal;
void main() {
  gl_Position = matrix * vec4(in_position, 1.0);
  position = in_position; normal = in_normal; uv = in_uv; tangent = in_tangent;
  face_normal = in_normal;
})";

const char* const depth_vertex_source = R"(#version 130
uniform mat4 matrix;
in vec3 in_position;
void main() { gl_Position = matrix * vec4(in_position, 1.0); })";

const char* const depth_fragment_source = R"(#version 130
void main() {})";

const char* const fragment_header = R"(#version 130
uniform vec3 toward_light; uniform vec3 eye; uniform vec3 plain_color; uniform vec4 weights;
uniform sampler2D color_map; uniform sampler2D normal_map;
in vec3 position; in vec3 normal; in vec2 uv; in vec3 tangent; flat in vec3 face_normal;
out vec4 result;
vec3 phong(vec3 n, vec3 color) {
  vec3 view = normalize(eye - position);
  float cosine = dot(n, toward_light);
  vec3 reflected = (2.0 * cosine) * n - toward_light;
  float shine = weights.z * pow(max(dot(reflected, view), 0.0), weights.w);
  return color * (weights.x + weights.y * max(cosine, 0.0)) + vec3(shine);
}
void main() {
)";

const char* body_of(ShadingKind kind) {
  switch (kind) {
    case ShadingKind::depth:
      return "";
    case ShadingKind::flat:
      return "result = vec4(plain_color * (weights.x + weights.y * "
             "max(dot(face_normal, toward_light), 0.0)), 1.0); }";
    case ShadingKind::phong:
      return "result = vec4(phong(normalize(normal), plain_color), 1.0); }";
    case ShadingKind::textured:
      return "result = vec4(phong(normalize(normal), texture(color_map, uv).rgb), 1.0); }";
    case ShadingKind::normal_mapped:
      break;
  }
  return "vec3 b = cross(normal, tangent); vec3 m = texture(normal_map, uv).rgb * 2.0 - 1.0;"
         "vec3 n = m.x * tangent + m.y * b + m.z * normal;"
         "result = vec4(phong(normalize(n), texture(color_map, uv).rgb), 1.0); }";
}

GLuint compile(GLenum type, const std::string& source) {
  const GLuint shader = glCreateShader(type);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == 0) {
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, 4096, nullptr, log.data());
    throw std::runtime_error("the peer refuses a shader: " + log);
  }
  return shader;
}

constexpr std::array<const char*, 4> attributes = {"in_position", "in_normal", "in_uv",
                                                   "in_tangent"};

GLuint link(const std::string& vertex, const std::string& fragment) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
  for (GLuint i = 0; i < attributes.size(); ++i) glBindAttribLocation(program, i, attributes[i]);
  glLinkProgram(program);
  GLint done = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done == 0) throw std::runtime_error("the peer cannot link a shader");
  return program;
}

/// The same levels as Texture makes.
GLuint upload(const Image<Rgb8>& image) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  Image<Color> level(image.width(), image.height());
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const Rgb8 texel = image.pixels()[i];
    level.pixels()[i] = Color(texel.r, texel.g, texel.b);
  }
  for (int number = 0;; ++number) {
    std::vector<Rgb8> rows;  // from the bottom up
    for (int y = level.height() - 1; y >= 0; --y) {
      for (int x = 0; x < level.width(); ++x) {
        const auto rounded = (level.row(y)[x].array() + 0.5F).cast<std::uint8_t>().eval();
        rows.push_back({rounded[0], rounded[1], rounded[2]});
      }
    }
    glTexImage2D(GL_TEXTURE_2D, number, GL_RGB8, level.width(), level.height(), 0, GL_RGB,
                 GL_UNSIGNED_BYTE, rows.data());
    if (level.width() == 1 && level.height() == 1) break;
    level = halved(level);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return name;
}

}  // namespace

struct Peer::State {
  int width;
  int height;
  OSMesaContext context = nullptr;
  std::vector<std::uint32_t> pixels;
  std::array<GLuint, 5> programs{};
  std::array<GLuint, 5> buffers{};
  std::array<GLuint, 2> textures{};
};

Peer::Peer(int width, int height, int threads) : state_(std::make_unique<State>()) {
  state_->width = width;
  state_->height = height;
  state_->pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::vector<int> before = thread_ids();
  state_->context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (state_->context == nullptr ||
      OSMesaMakeCurrent(state_->context, state_->pixels.data(), GL_UNSIGNED_BYTE, width, height) ==
          GL_FALSE) {
    throw std::runtime_error("the peer, llvmpipe through OSMesa, cannot be started");
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glFinish();
  int core = 0;
  for (const int thread : thread_ids()) {
    if (std::find(before.begin(), before.end(), thread) == before.end()) {
      pin(thread, core++ % threads);
    }
  }
  for (std::size_t i = 0; i < state_->programs.size(); ++i) {
    const auto kind = static_cast<ShadingKind>(i);
    state_->programs[i] = kind == ShadingKind::depth
                              ? link(depth_vertex_source, depth_fragment_source)
                              : link(vertex_source, fragment_header + std::string(body_of(kind)));
  }
  glGenBuffers(static_cast<GLsizei>(state_->buffers.size()), state_->buffers.data());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
}

Peer::~Peer() {
  OSMesaDestroyContext(state_->context);
}

void Peer::load_textures(const Image<Rgb8>& texture, const Image<Rgb8>& normal_map) {
  state_->textures = {upload(texture), upload(normal_map)};
}

void Peer::load(const Scene& scene) {
  const auto fill = [&](std::size_t buffer, const auto& values) {
    glBindBuffer(GL_ARRAY_BUFFER, state_->buffers[buffer]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(values[0])),
                 values.data(), GL_STATIC_DRAW);
  };
  fill(0, scene.mesh.positions);
  fill(1, scene.mesh.normals);
  fill(2, scene.mesh.texture_coordinates);
  fill(3, scene.tangents);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, state_->buffers[4]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(scene.mesh.triangles.size() * sizeof(Mesh::Triangle)),
               scene.mesh.triangles.data(), GL_STATIC_DRAW);
}

void Peer::draw(const Scene& scene, ShadingKind shading) {
  const GLuint program = state_->programs[static_cast<std::size_t>(shading)];
  glUseProgram(program);
  const auto place = [program](const char* name) { return glGetUniformLocation(program, name); };
  glUniformMatrix4fv(place("matrix"), 1, GL_FALSE, scene.matrix.data());
  const Lighting lighting;
  glUniform3fv(place("toward_light"), 1, lighting.toward_light.data());
  glUniform3fv(place("eye"), 1, scene.eye.data());
  glUniform3fv(place("plain_color"), 1, plain_color().data());
  glUniform4f(place("weights"), Lighting::ambient, Lighting::diffuse, Lighting::specular,
              Lighting::shininess);
  glUniform1i(place("color_map"), 0);
  glUniform1i(place("normal_map"), 1);
  for (GLuint i = 0; i < 2; ++i) {
    glActiveTexture(GL_TEXTURE0 + i);
    glBindTexture(GL_TEXTURE_2D, state_->textures[i]);
  }
  const bool textured = !scene.mesh.texture_coordinates.empty();
  constexpr std::array<GLint, 4> sizes = {3, 3, 2, 3};
  for (GLuint i = 0; i < 4; ++i) {
    const bool there = i == 0 || (shading != ShadingKind::depth && (i == 1 || textured));
    if (!there) {
      glDisableVertexAttribArray(i);
      continue;
    }
    glEnableVertexAttribArray(i);
    glBindBuffer(GL_ARRAY_BUFFER, state_->buffers[i]);
    glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  const GLboolean colored = shading == ShadingKind::depth ? GL_FALSE : GL_TRUE;
  glColorMask(colored, colored, colored, colored);
  glClear(colored == GL_TRUE ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, state_->buffers[4]);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(scene.mesh.triangles.size() * 3),
                 GL_UNSIGNED_INT, nullptr);
  glFinish();
}

Image<Rgb8> Peer::color() const {
  Image<Rgb8> image(state_->width, state_->height);
  for (std::size_t i = 0; i < state_->pixels.size(); ++i) {
    const std::uint32_t p = state_->pixels[i];
    image.pixels()[i] = {static_cast<std::uint8_t>(p), static_cast<std::uint8_t>(p >> 8U),
                         static_cast<std::uint8_t>(p >> 16U)};
  }
  return image;
}

Image<std::uint8_t> Peer::coverage() const {
  std::vector<float> depth(state_->pixels.size());
  glReadPixels(0, 0, state_->width, state_->height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  Image<std::uint8_t> image(state_->width, state_->height);
  for (int y = 0; y < state_->height; ++y) {
    for (int x = 0; x < state_->width; ++x) {
      const int from = (state_->height - 1 - y) * state_->width + x;
      image.row(y)[x] = depth[static_cast<std::size_t>(from)] < 1.0F ? 255 : 0;
    }
  }
  return image;
}

}  // namespace rasterlab::bench
