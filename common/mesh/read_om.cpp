#include "common/mesh/read_om.h"

#include "common/image/check.h"
#include "common/mesh/byte_reader.h"
#include "common/mesh/mesh_builder.h"
#include "common/mesh/openmesh_silence.h"

#include <sstream>
#include <utility>

// OpenMesh's vectors begin uninitialized; g++ sees that through all inlining when it sanitizes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/IO/OMFormat.hh>
#include <OpenMesh/Core/IO/importer/ImporterT.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

namespace rasterlab {
namespace {

namespace om = OpenMesh::IO::OMFormat;
using om::Chunk;

// ---- Before OpenMesh: what it would stumble over

struct Counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
};

/// The file's head and those of its chunks that make a Mesh. Their sizes are right.
class OmParts {
 public:
  OmParts(std::string_view bytes, const std::string& file)
      : bytes_(bytes), file_(file), reader_(bytes, std::endian::little, file) {
    read_head();
    while (reader_.left() >= om::chunk_header_size()) {
      const std::size_t start = bytes_.size() - reader_.left();
      Chunk::Header chunk{};
      om::operator<<(chunk, reader_.take<std::uint16_t>());
      if (chunk.entity_ == Chunk::Entity_Sentinel) break;
      if (skip(chunk)) kept_ += bytes_.substr(start, bytes_.size() - reader_.left() - start);
    }
  }

  const Counts& counts() const { return counts_; }
  const std::string& kept() const { return kept_; }

 private:
  void read_head() {
    if (!looks_like_om(bytes_)) fail("it does not begin as an OM file does");
    reader_.take_bytes(2);
    mesh_ = reader_.take<char>();
    version_ = reader_.take<std::uint8_t>();
    counts_.vertices = reader_.take<std::uint32_t>();
    counts_.faces = reader_.take<std::uint32_t>();
    counts_.edges = reader_.take<std::uint32_t>();
    kept_ = bytes_.substr(0, bytes_.size() - reader_.left());
  }

  /// Passes over the data of a chunk; true when it is of use.
  bool skip(const Chunk::Header& chunk) {
    const std::size_t integer = std::size_t{1} << chunk.bits_;
    // OpenMesh names custom parts only, but would read a name before any part.
    if (chunk.name_ != 0) {
      if (chunk.type_ != Chunk::Type_Custom) fail("there is a part of unknown kind in it");
      skip_text();
    }
    switch (chunk.type_) {
      case Chunk::Type_Custom:
        if (version_ >= om::mk_version(2, 2)) skip_text();  // the type's name
        reader_.take_bytes(reader_.take<std::uint32_t>());
        return false;
      case Chunk::Type_Status:
        pass(chunk, 4, true);
        return false;
      case Chunk::Type_Pos:
      case Chunk::Type_Normal:
        return pass(chunk, 3 * (4U << chunk.bits_),
                    chunk.dim_ == 2 && chunk.float_ != 0 && chunk.bits_ < 2);
      case Chunk::Type_Texcoord:
        return pass(chunk, 8, chunk.dim_ == 1 && chunk.float_ != 0 && chunk.bits_ == 0);
      case Chunk::Type_Color:
        return pass(chunk, 3, chunk.dim_ == 2 && chunk.float_ == 0 && chunk.bits_ == 0);
      case Chunk::Type_Topology:
        if (chunk.entity_ == Chunk::Entity_Halfedge) return pass(chunk, 3 * integer, true);
        // OpenMesh aborts at a dimension, and takes what edges may have for something else.
        if (chunk.dim_ != 0 || chunk.entity_ == Chunk::Entity_Edge) {
          fail("there is a part of unknown kind in it");
        }
        if (chunk.entity_ == Chunk::Entity_Face && version_ < om::mk_version(2, 0)) {
          skip_polygons(integer);
          return true;
        }
        return pass(chunk, integer, true);
      default:
        fail("there is a part of unknown kind in it");
    }
  }

  /// Passes over a chunk of so many bytes for each element.
  bool pass(const Chunk::Header& chunk, std::size_t bytes, bool is_known) {
    std::size_t elements = 0;
    switch (chunk.entity_) {
      case Chunk::Entity_Vertex:
        elements = counts_.vertices;
        break;
      case Chunk::Entity_Face:
        elements = counts_.faces;
        break;
      case Chunk::Entity_Edge:
        elements = counts_.edges;
        break;
      case Chunk::Entity_Halfedge:
        elements = 2 * counts_.edges;
        break;
      default:
        is_known = false;
    }
    if (!is_known) fail("there is a part of unknown kind in it");
    reader_.take_bytes(elements * bytes);
    return chunk.entity_ == Chunk::Entity_Vertex || chunk.type_ == Chunk::Type_Topology;
  }

  void skip_text() { reader_.take_bytes(reader_.take<std::uint8_t>()); }

  void skip_polygons(std::size_t integer) {
    for (std::size_t i = 0; i < counts_.faces; ++i) {
      const std::size_t corners =
          mesh_ == 'P' ? reader_.take<std::uint16_t>() : (mesh_ == 'Q' ? 4U : 3U);
      reader_.take_bytes(corners * integer);
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_ + ": " + problem);
  }

  std::string_view bytes_;
  std::string file_;
  ByteReader reader_;
  char mesh_ = 0;
  std::uint8_t version_ = 0;
  Counts counts_;
  std::string kept_;
};

// ---- Through OpenMesh

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color |
                   OpenMesh::Attributes::TexCoord2D);
  using Color = OpenMesh::Vec3f;
};
using PolygonMesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
using Vertex = OpenMesh::VertexHandle;
using Edge = OpenMesh::HalfedgeHandle;

/// Hands on to a mesh what the reader finds, but nothing that leads to what is not there.
class CheckedImporter : public OpenMesh::IO::ImporterT<PolygonMesh> {
 public:
  CheckedImporter(PolygonMesh& mesh, const Counts& counts, const std::string& file)
      : ImporterT(mesh), counts_(counts), file_(file) {}

  using ImporterT::add_face;
  using ImporterT::set_color;
  using ImporterT::set_normal;
  using ImporterT::set_texcoord;

  void set_normal(Vertex vertex, const OpenMesh::Vec3f& normal) override {
    check(vertex.idx(), n_vertices());
    ImporterT::set_normal(vertex, normal);
  }
  void set_normal(Vertex vertex, const OpenMesh::Vec3d& normal) override {
    check(vertex.idx(), n_vertices());
    ImporterT::set_normal(vertex, normal);
  }
  void set_color(Vertex vertex, const OpenMesh::Vec3uc& color) override {
    check(vertex.idx(), n_vertices());
    ImporterT::set_color(vertex, color);
  }
  void set_texcoord(Vertex vertex, const OpenMesh::Vec2f& uv) override {
    check(vertex.idx(), n_vertices());
    ImporterT::set_texcoord(vertex, uv);
  }

  Edge add_edge(Vertex from, Vertex to) override {
    check(from.idx(), counts_.vertices);
    check(to.idx(), counts_.vertices);
    return ImporterT::add_edge(from, to);
  }
  OpenMesh::FaceHandle add_face(Edge edge) override {
    check(edge.idx(), 2 * counts_.edges);
    return ImporterT::add_face(edge);
  }
  void set_next(Edge edge, Edge next) override {
    check(next.idx(), 2 * n_edges());
    ImporterT::set_next(edge, next);
  }
  void set_halfedge(Vertex, Edge) override {}  // of no use here

  /// The links were checked against what the file promises: it must have come.
  void check_complete() const {
    if (n_vertices() < counts_.vertices || 2 * n_edges() < 2 * counts_.edges) {
      throw InputError(file_ + ": its vertices or edges are missing");
    }
  }

 private:
  void check(int index, std::size_t count) const {
    if (index < 0 || static_cast<std::size_t>(index) >= count) {
      throw InputError(file_ + ": a link between its parts leads nowhere");
    }
  }

  Counts counts_;
  std::string file_;
};

void add_vertices(const PolygonMesh& source, const OpenMesh::IO::Options& has,
                  MeshBuilder& builder) {
  for (const auto vertex : source.vertices()) {
    const auto& point = source.point(vertex);
    const auto& normal = source.normal(vertex);
    const auto& color = source.color(vertex);
    const auto& uv = source.texcoord2D(vertex);
    builder.positions.emplace_back(point[0], point[1], point[2]);
    if (has.vertex_has_normal()) builder.normals.emplace_back(normal[0], normal[1], normal[2]);
    if (has.vertex_has_color()) builder.colors.emplace_back(color[0], color[1], color[2]);
    if (has.vertex_has_texcoord()) builder.uvs.emplace_back(uv[0], uv[1]);
  }
}

void add_faces(const PolygonMesh& source, const std::string& file, MeshBuilder& builder) {
  std::vector<MeshBuilder::Corner> corners;
  for (const auto face : source.faces()) {
    corners.clear();
    const auto first = source.halfedge_handle(face);
    auto edge = first;
    do {
      corners.push_back(
          {.position = static_cast<std::uint32_t>(source.to_vertex_handle(edge).idx())});
      edge = source.next_halfedge_handle(edge);
      if (corners.size() > source.n_halfedges()) throw InputError(file + ": a face does not close");
    } while (edge != first);
    if (corners.size() >= 3) builder.add_polygon(corners);
  }
}

/// Whether OpenMesh could read it. It throws what it likes where a chunk is damaged.
bool read_by_openmesh(std::istream& stream, CheckedImporter& importer,
                      OpenMesh::IO::Options& options) {
  try {
    return OpenMesh::IO::OMReader().read(stream, importer, options);
  } catch (const InputError&) {
    throw;  // the importer's own
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

bool looks_like_om(std::string_view bytes) {
  return bytes.size() >= om::header_size() && bytes.starts_with("OM") &&
         std::string_view("TQP").find(bytes[2]) != std::string_view::npos;
}

Mesh read_om(std::string_view bytes, const std::string& file) {
  const OmParts parts(bytes, file);
  const OpenMeshSilence silence;
  std::istringstream stream(parts.kept());
  PolygonMesh source;
  CheckedImporter importer(source, parts.counts(), file);
  auto options = OpenMesh::IO::Options(OpenMesh::IO::Options::Binary);
  options += OpenMesh::IO::Options::VertexNormal;
  options += OpenMesh::IO::Options::VertexColor;
  options += OpenMesh::IO::Options::VertexTexCoord;
  if (!read_by_openmesh(stream, importer, options)) {
    throw InputError(file + ": OpenMesh " + std::to_string(OM_GET_VER) +
                     " cannot read this OM file");
  }
  importer.check_complete();
  MeshBuilder builder;
  add_vertices(source, options, builder);
  add_faces(source, file, builder);
  if (options.vertex_has_normal()) builder.give_each_position(&MeshBuilder::Corner::normal);
  if (options.vertex_has_color()) builder.give_each_position(&MeshBuilder::Corner::color);
  if (options.vertex_has_texcoord()) builder.give_each_position(&MeshBuilder::Corner::uv);
  return std::move(builder).build(file);
}

}  // namespace rasterlab
